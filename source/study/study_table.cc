// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/base/table.h>
#include <abut/study/study_table.h>

#include <algorithm>
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
    TextTable table = {{run.name(), "unknowns", "seconds", "steps", "stress", "energy", "pressure", "force",
                        "estimated", "effectivity", "order", "x sqrt(unknowns)"}};
    for (std::size_t i = 0; i < run.passes.size(); ++i)
    {
      const PassRecord &pass = run.passes[i].record;
      const TrueErrors &errors = pass.true_errors;
      const bool has_contact = !run.passes[i].quantities.contacts.empty();
      table.push_back({"pass " + std::to_string(pass.pass), std::to_string(pass.counts.dofs),
                       short_number(pass.seconds, 3), has_contact ? std::to_string(pass.steps) : "-",
                       shown(errors.stress), shown(errors.energy), shown(errors.pressure),
                       shown(errors.force), shown(pass.stress), shown(pass.effectivity()),
                       i == 0 ? "-" : shown(order(run.passes[i - 1].record, pass)), shown(times_root(pass))});
    }
    return aligned(without_empty_columns(table));
  }

  std::string study_table_legend(const std::vector<StudyRun> &runs)
  {
    const bool has_errors = std::any_of(runs.begin(), runs.end(), [](const StudyRun &run) {
      return std::any_of(run.passes.begin(), run.passes.end(),
                         [](const StudyPass &pass) { return stress_error(pass.record).has_value(); });
    });
    return has_errors
               ? "  Errors are relative: true ones of stress (L2), energy norm, pressure (L2) and contact "
                 "force; estimated: of the\n  stress. order: with which power of the unknowns the "
                 "stress error (else the estimated one) has fallen since the\n  pass before; x "
                 "sqrt(unknowns): that error times the root of the unknowns, steady at order 1/2\n"
               : "";
  }
} // namespace abut
