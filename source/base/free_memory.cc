// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/free_memory.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>
#include <unistd.h>

namespace abut
{
  namespace
  {
    constexpr std::uint64_t machines_meet = 10;

    struct Machine
    {
      std::string name;
      double available = std::numeric_limits<double>::infinity(); ///< bytes

      void serialize(Archive &archive) { archive(name, available); }
    };

    Machine this_machine()
    {
      char name[256] = "";
      gethostname(name, sizeof(name) - 1);
      Machine machine;
      machine.name = name;
      std::ifstream memory("/proc/meminfo");
      std::string word;
      double kibibytes = 0.;
      while (memory >> word)
        if (word == "MemAvailable:" && memory >> kibibytes)
          machine.available = 1024. * kibibytes;
      return machine;
    }
  } // namespace

  double free_memory(Processes &processes)
  {
    const std::vector<Machine> machines = processes.collect(machines_meet, this_machine);
    double least = std::numeric_limits<double>::infinity();
    for (const Machine &machine : machines)
    {
      const auto there = std::count_if(machines.begin(), machines.end(),
                                       [&](const Machine &other) { return other.name == machine.name; });
      least = std::min(least, machine.available / static_cast<double>(there));
    }
    return least;
  }
} // namespace abut
