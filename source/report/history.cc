// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/report/history.h>
#include <abut/report/reference/csv_files.h>

#include <sstream>

namespace abut
{
  namespace
  {
    std::string cell(const std::optional<double> &value)
    {
      return value ? exact_number(*value) : std::string();
    }

    void write_row(const std::vector<std::string> &row, std::ostream &out)
    {
      for (std::size_t i = 0; i < row.size(); ++i)
        out << (i == 0 ? "" : ",") << row[i];
      out << '\n';
    }
  } // namespace

  void History::end_pass(const PassRecord &record)
  {
    if (!rows_.empty() && rows_.back().pass == record.pass)
      rows_.back().found = record;
  }

  std::vector<std::string> History::cells(const Row &row)
  {
    const PassRecord found = row.found.value_or(PassRecord());
    const auto &estimate = row.estimate;
    const std::optional<double> none;
    return {std::to_string(row.pass),
            std::to_string(row.step.step),
            std::to_string(row.counts.dofs),
            std::to_string(row.counts.boundary_dofs),
            std::to_string(row.counts.cells),
            cell(found.eta_max),
            exact_number(row.step.increment),
            cell(found.discretisation),
            cell(found.budget.penalty),
            exact_number(row.step.bound),
            cell(found.total),
            cell(found.true_errors.energy),
            cell(found.true_errors.stress),
            cell(found.effectivity()),
            cell(found.effectivity_total),
            exact_number(row.step.normal_force),
            exact_number(row.step.max_pressure),
            exact_number(row.wall_time),
            cell(found.true_errors.pressure),
            cell(found.true_errors.force),
            cell(found.stress),
            cell(found.change),
            estimate ? exact_number(estimate->discretisation) : std::string(),
            cell(estimate ? estimate->bound : none),
            cell(estimate ? estimate->true_error : none),
            cell(estimate ? estimate->ratio : none),
            cell(estimate ? estimate->bound_ratio : none),
            cell(found.budget.contact),
            cell(found.budget.linear_algebra),
            cell(found.budget.geometry),
            cell(found.budget.bound()),
            cell(found.budget.estimate()),
            cell(found.pressure)};
  }

  std::string History::csv() const
  {
    std::ostringstream out;
    out << csv_header("history.csv");
    for (const Row &row : rows_)
      write_row(cells(row), out);
    return out.str();
  }
} // namespace abut
