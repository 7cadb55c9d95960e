// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/study/quality_table.h>
#include <abut/study/study_table.h>

#include <cmath>
#include <sstream>

namespace abut
{
  namespace
  {
    std::string shown(const std::optional<double> &value)
    {
      return value ? short_number(*value, 3) : std::string("-");
    }

    std::optional<double> stress_error(const PassRecord &pass)
    {
      return pass.true_errors.stress ? pass.true_errors.stress : pass.stress;
    }

    std::optional<double> order(const PassRecord &before, const PassRecord &pass)
    {
      const auto first = stress_error(before), second = stress_error(pass);
      if (!first || !second || before.counts.dofs == pass.counts.dofs)
        return {};
      return std::log(*first / *second) /
             std::log(static_cast<double>(pass.counts.dofs) / static_cast<double>(before.counts.dofs));
    }
    /// The stress error times the square root of the unknowns: steady at the order of degree 1.
    std::optional<double> times_root(const PassRecord &pass)
    {
      const auto error = stress_error(pass);
      if (!error)
        return {};
      return *error * std::sqrt(static_cast<double>(pass.counts.dofs));
    }
  } // namespace

  std::string study_table(const StudyRun &run)
  {
    std::vector<std::vector<std::string>> table = {{run.name, "unknowns", "seconds", "steps", "stress",
                                                    "order", "x sqrt", "energy", "pressure", "force",
                                                    "estimated", "effectivity"}};
    for (std::size_t i = 0; i < run.passes.size(); ++i)
    {
      const PassRecord &pass = run.passes[i];
      const TrueErrors &errors = pass.true_errors;
      table.push_back({"pass " + std::to_string(pass.pass), std::to_string(pass.counts.dofs),
                       short_number(pass.seconds, 3), std::to_string(pass.steps), shown(stress_error(pass)),
                       i == 0 ? "" : shown(order(run.passes[i - 1], pass)), shown(times_root(pass)),
                       shown(errors.energy), shown(errors.pressure), shown(errors.force), shown(pass.stress),
                       shown(pass.effectivity())});
    }
    return aligned(table);
  }

  std::string study_csv(const std::vector<StudyRun> &runs)
  {
    const auto cell = [](const std::optional<double> &value) {
      return value ? exact_number(*value) : std::string();
    };
    std::ostringstream out;
    out << "variant,pass,cells,dofs,steps,wall_time_s,true_error_stress,true_error_energy,true_error_"
           "pressure,"
           "true_error_force,error_stress,error_discretisation,effectivity"
        << quality_header() << '\n';
    for (const StudyRun &run : runs)
      for (const PassRecord &pass : run.passes)
        out << '"' << run.name << "\"," << pass.pass << ',' << pass.counts.cells << ',' << pass.counts.dofs
            << ',' << pass.steps << ',' << exact_number(pass.seconds) << ',' << cell(pass.true_errors.stress)
            << ',' << cell(pass.true_errors.energy) << ',' << cell(pass.true_errors.pressure) << ','
            << cell(pass.true_errors.force) << ',' << cell(pass.stress) << ',' << cell(pass.discretisation)
            << ',' << cell(pass.effectivity()) << quality_row(pass) << '\n';
    return out.str();
  }
} // namespace abut
