// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/report/history.h>
#include <abut/report/numbers.h>

#include <sstream>

namespace abut
{
  std::string History::csv() const
  {
    std::ostringstream out;
    out << "pass,step,dofs,boundary_dofs,cells,eta_max,increment,error_discretisation,error_penalty,"
           "error_iteration,error_total,true_error_energy,true_error_stress,effectivity,effectivity_total,"
           "normal_force,max_pressure,wall_time_s\n";
    const std::string pass = "0", unknown;
    for (const auto &[record, wall_time] : rows_)
    {
      const std::string cells[] = {pass,
                                   std::to_string(record.step),
                                   std::to_string(counts_.dofs),
                                   std::to_string(counts_.boundary_dofs),
                                   std::to_string(counts_.cells),
                                   unknown, // eta_max
                                   exact_number(record.increment),
                                   unknown, // error_discretisation
                                   unknown, // error_penalty
                                   exact_number(record.bound),
                                   unknown, // error_total
                                   unknown, // true_error_energy
                                   unknown, // true_error_stress
                                   unknown, // effectivity
                                   unknown, // effectivity_total
                                   exact_number(record.normal_force),
                                   exact_number(record.max_pressure),
                                   exact_number(wall_time)};
      const char *separator = "";
      for (const std::string &cell : cells)
      {
        out << separator << cell;
        separator = ",";
      }
      out << '\n';
    }
    return out.str();
  }
} // namespace abut
