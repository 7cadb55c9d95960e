// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/launch.h>

#include <cstdlib>
#include <initializer_list>

namespace abut
{
  namespace
  {
    /// The number in the first of these variables that is set; otherwise `by_default`.
    int number_in(const std::initializer_list<const char *> variables, const int by_default)
    {
      for (const char *variable : variables)
        if (const char *value = std::getenv(variable))
          return std::atoi(value);
      return by_default;
    }
  } // namespace

  Launch Launch::from_environment()
  {
    // PMIx tells the rank alone; how many there are, srun says, which may also have started a batch script.
    const int of_srun = std::getenv("PMIX_RANK") != nullptr ? number_in({"SLURM_STEP_NUM_TASKS"}, 1) : 1;
    return {number_in({"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}, of_srun),
            number_in({"OMPI_COMM_WORLD_RANK", "PMI_RANK", "PMIX_RANK"}, 0)};
  }
} // namespace abut
