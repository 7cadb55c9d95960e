// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/study/quality_table.h>
#include <abut/study/study_data.h>
#include <abut/study/study_warnings.h>
#include <abut/study/sweeps.h>
#include <abut/study/variants.h>

#include <algorithm>
#include <functional>
#include <limits>

namespace abut
{
  namespace
  {
    using CellOf = std::function<StudyCell(const StudyRun &run, const StudyPass &pass)>;

    struct StudyColumn
    {
      std::string name;
      CellOf cell;
    };
    using StudyColumns = std::vector<StudyColumn>;

    StudyCell cell_of(const std::optional<double> &value)
    {
      return value.value_or(std::numeric_limits<double>::quiet_NaN());
    }

    template <typename Value> StudyColumn of_record(const std::string &name, const Value &value)
    {
      return {name, [value](const StudyRun &, const StudyPass &pass) { return cell_of(value(pass.record)); }};
    }

    template <typename Value> StudyColumn of_pass(const std::string &name, const Value &value)
    {
      return {name, [value](const StudyRun &, const StudyPass &pass) { return cell_of(value(pass)); }};
    }

    StudyColumns error_columns()
    {
      using Record = const PassRecord &;
      return {{"variant", [](const StudyRun &run, const StudyPass &) { return run.name(); }},
              of_record("pass", [](Record pass) { return pass.pass; }),
              of_record("cells", [](Record pass) { return pass.counts.cells; }),
              of_record("dofs", [](Record pass) { return pass.counts.dofs; }),
              of_record("steps", [](Record pass) { return pass.steps; }),
              of_record("wall_time_s", [](Record pass) { return pass.seconds; }),
              of_record("true_error_stress", [](Record pass) { return pass.true_errors.stress; }),
              of_record("true_error_energy", [](Record pass) { return pass.true_errors.energy; }),
              of_record("true_error_pressure", [](Record pass) { return pass.true_errors.pressure; }),
              of_record("true_error_force", [](Record pass) { return pass.true_errors.force; }),
              of_record("error_stress", [](Record pass) { return pass.stress; }),
              of_record("error_discretisation", [](Record pass) { return pass.discretisation; }),
              of_record("effectivity", [](Record pass) { return pass.effectivity(); })};
    }

    StudyColumns quality_columns()
    {
      StudyColumns columns;
      const std::vector<std::string> names = quality_names();
      for (std::size_t i = 0; i < names.size(); ++i)
        columns.push_back(
            of_record(names[i], [i](const PassRecord &pass) { return quality_values(pass)[i]; }));
      return columns;
    }

    StudyColumns quantity_columns()
    {
      StudyColumns columns;
      for (const NamedQuantity &quantity : named_quantities())
        columns.push_back(of_pass(quantity.name, [value = quantity.value](const StudyPass &pass) {
          return std::optional<double>(value(pass.quantities));
        }));
      return columns;
    }

    StudyColumns budget_columns()
    {
      using Record = const PassRecord &;
      return {of_record("budget_discretisation", [](Record pass) { return pass.budget.discretisation; }),
              of_record("budget_contact", [](Record pass) { return pass.budget.contact; }),
              of_record("budget_iteration", [](Record pass) { return pass.budget.iteration; }),
              of_record("budget_penalty", [](Record pass) { return pass.budget.penalty; }),
              of_record("budget_linear_algebra", [](Record pass) { return pass.budget.linear_algebra; }),
              of_record("budget_geometry", [](Record pass) { return pass.budget.geometry; }),
              of_record("budget_estimate", [](Record pass) { return pass.budget.estimate(); }),
              of_record("budget_bound", [](Record pass) { return pass.budget.bound(); })};
    }

    StudyColumns reference_columns()
    {
      return {
          {"reference", [](const StudyRun &run, const StudyPass &) { return run.reference; }},
          {"reference_error",
           [](const StudyRun &run, const StudyPass &) { return cell_of(run.reference_error); }},
          of_pass("true_error_peak_pressure", [](const StudyPass &pass) { return pass.peak_pressure_error; }),
          of_pass("true_error_strain_energy",
                  [](const StudyPass &pass) { return pass.strain_energy_error; })};
    }

    /// Of one contact; a variant need not have it.
    StudyColumn contact_column(const std::string &name, const std::string &contact,
                               double ContactQuantities::*value)
    {
      return of_pass(name + '_' + contact, [contact, value](const StudyPass &pass) {
        for (const ContactQuantities &quantities : pass.quantities.contacts)
          if (quantities.name == contact)
            return std::optional<double>(quantities.*value);
        return std::optional<double>();
      });
    }

    StudyColumns contact_columns(const std::vector<StudyRun> &runs)
    {
      StudyColumns columns;
      for (const std::string &contact : contact_names(runs))
      {
        columns.push_back(contact_column("contact_force", contact, &ContactQuantities::force));
        columns.push_back(contact_column("max_pressure", contact, &ContactQuantities::max_pressure));
        columns.push_back(contact_column("contact_length", contact, &ContactQuantities::contact_length));
      }
      return columns;
    }

    using PointValue = std::function<double(const PointQuantities &)>;

    /// Of one point; a variant need not have it.
    StudyColumn point_column(const std::string &name, const std::string &point, const PointValue &value)
    {
      return of_pass(name + '_' + point, [point, value](const StudyPass &pass) {
        for (const PointQuantities &quantities : pass.quantities.points)
          if (quantities.name == point)
            return std::optional<double>(value(quantities));
        return std::optional<double>();
      });
    }

    StudyColumns point_columns(const std::vector<StudyRun> &runs)
    {
      using At = const PointQuantities &;
      StudyColumns columns;
      for (const std::string &point : point_names(runs))
      {
        columns.push_back(point_column("von_mises", point, [](At at) { return at.von_mises; }));
        columns.push_back(point_column("displacement_x", point, [](At at) { return at.displacement.x(); }));
        columns.push_back(point_column("displacement_y", point, [](At at) { return at.displacement.y(); }));
      }
      return columns;
    }

    StudyColumns swept_columns(const std::vector<StudyRun> &runs)
    {
      StudyColumns columns;
      if (std::any_of(runs.begin(), runs.end(),
                      [](const StudyRun &run) { return !run.variant.load_case.empty(); }))
        columns.push_back(
            {"load_case", [](const StudyRun &run, const StudyPass &) { return run.variant.load_case; }});
      for (const std::string &parameter : swept_parameters(runs))
        columns.push_back({parameter, [parameter](const StudyRun &run, const StudyPass &) {
                             return swept_value(run.variant, parameter);
                           }});
      return columns;
    }

    StudyColumns warning_columns()
    {
      return {{"warnings", [](const StudyRun &run, const StudyPass &) { return codes_of(run.warnings); }}};
    }

    StudyColumns joined(const std::vector<StudyColumns> &groups)
    {
      StudyColumns columns;
      for (const StudyColumns &group : groups)
        columns.insert(columns.end(), group.begin(), group.end());
      return columns;
    }

    StudyColumns without(StudyColumns columns, const std::string &name)
    {
      columns.erase(std::remove_if(columns.begin(), columns.end(),
                                   [&](const StudyColumn &column) { return column.name == name; }),
                    columns.end());
      return columns;
    }

    StudyData data_of(const StudyColumns &columns, const std::vector<StudyRun> &runs)
    {
      StudyData data;
      for (const StudyColumn &column : columns)
        data.columns.push_back(column.name);
      for (const StudyRun &run : runs)
        for (const StudyPass &pass : run.passes)
        {
          data.rows.emplace_back();
          for (const StudyColumn &column : columns)
            data.rows.back().push_back(column.cell(run, pass));
        }
      return data;
    }

    std::string quoted(const std::string &text)
    {
      std::string result = "\"";
      for (const char c : text)
        result += c == '"' ? std::string("\"\"") : std::string(1, c);
      return result + '"';
    }

    std::string written(const StudyCell &cell)
    {
      if (const auto *const text = std::get_if<std::string>(&cell))
        return text->empty() ? "" : quoted(*text);
      return exact_number(std::get<double>(cell));
    }

    /// A line of CSV.
    template <typename Cells, typename Write> std::string line_of(const Cells &cells, const Write &write)
    {
      std::string line;
      for (const auto &cell : cells)
        line += (&cell == &cells.front() ? "" : ",") + write(cell);
      return line + '\n';
    }
  } // namespace

  StudyData study_data(const std::vector<StudyRun> &runs)
  {
    return data_of(
        joined({error_columns(), quality_columns(), quantity_columns(), budget_columns(), reference_columns(),
                contact_columns(runs), point_columns(runs), swept_columns(runs), warning_columns()}),
        runs);
  }

  StudyData shown_data(const std::vector<StudyRun> &runs)
  {
    const bool has_names = std::any_of(runs.begin(), runs.end(),
                                       [](const StudyRun &run) { return !choice_of(run.variant).empty(); });
    const bool has_sums = contact_names(runs).size() > 1;
    return data_of(
        joined({swept_columns(runs), has_names ? error_columns() : without(error_columns(), "variant"),
                quality_columns(), quantity_columns(), without(budget_columns(), "budget_discretisation"),
                reference_columns(), has_sums ? contact_columns(runs) : StudyColumns(), point_columns(runs),
                warning_columns()}),
        runs);
  }

  std::string csv(const StudyData &data)
  {
    const auto name = [](const std::string &column) {
      return column.find_first_of(",\"\n") == std::string::npos ? column : quoted(column);
    };
    std::string text = line_of(data.columns, name);
    for (const std::vector<StudyCell> &row : data.rows)
      text += line_of(row, written);
    return text;
  }
} // namespace abut
