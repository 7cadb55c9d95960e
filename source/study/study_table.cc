// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/study/study_table.h>

#include <cmath>

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
    std::vector<std::vector<std::string>> table = {{run.name(), "unknowns", "seconds", "steps", "stress",
                                                    "order", "x sqrt", "energy", "pressure", "force",
                                                    "estimated", "effectivity"}};
    for (std::size_t i = 0; i < run.passes.size(); ++i)
    {
      const PassRecord &pass = run.passes[i].record;
      const TrueErrors &errors = pass.true_errors;
      table.push_back({"pass " + std::to_string(pass.pass), std::to_string(pass.counts.dofs),
                       short_number(pass.seconds, 3), std::to_string(pass.steps), shown(stress_error(pass)),
                       i == 0 ? "" : shown(order(run.passes[i - 1].record, pass)), shown(times_root(pass)),
                       shown(errors.energy), shown(errors.pressure), shown(errors.force), shown(pass.stress),
                       shown(pass.effectivity())});
    }
    return aligned(table);
  }
} // namespace abut
