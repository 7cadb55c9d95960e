// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/study/quality_table.h>
#include <abut/study/study_data.h>

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
      using Pass = const StudyPass &;
      return {of_pass("contact_force", [](Pass pass) { return pass.quantities.force(); }),
              of_pass("max_pressure", [](Pass pass) { return pass.quantities.max_pressure(); }),
              of_pass("contact_length", [](Pass pass) { return pass.quantities.contact_length(); }),
              of_pass("max_von_mises", [](Pass pass) { return pass.quantities.max_von_mises; }),
              of_pass("strain_energy", [](Pass pass) { return pass.quantities.strain_energy; })};
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

    void add_once(std::vector<std::string> &names, const std::string &name)
    {
      if (std::find(names.begin(), names.end(), name) == names.end())
        names.push_back(name);
    }

    StudyColumns contact_columns(const std::vector<StudyRun> &runs)
    {
      std::vector<std::string> contacts;
      for (const StudyRun &run : runs)
        for (const StudyPass &pass : run.passes)
          for (const ContactQuantities &contact : pass.quantities.contacts)
            add_once(contacts, contact.name);
      StudyColumns columns;
      for (const std::string &contact : contacts)
      {
        columns.push_back(contact_column("contact_force", contact, &ContactQuantities::force));
        columns.push_back(contact_column("max_pressure", contact, &ContactQuantities::max_pressure));
        columns.push_back(contact_column("contact_length", contact, &ContactQuantities::contact_length));
      }
      return columns;
    }

    std::string value_of(const StudyRun &run, const std::string &parameter)
    {
      for (const auto &[swept, value] : run.variant.swept)
        if (swept == parameter)
          return value;
      return {};
    }

    StudyColumns swept_columns(const std::vector<StudyRun> &runs)
    {
      std::vector<std::string> parameters;
      bool has_load_cases = false;
      for (const StudyRun &run : runs)
      {
        has_load_cases = has_load_cases || !run.variant.load_case.empty();
        for (const auto &[parameter, value] : run.variant.swept)
          add_once(parameters, parameter);
      }
      StudyColumns columns;
      if (has_load_cases)
        columns.push_back(
            {"load_case", [](const StudyRun &run, const StudyPass &) { return run.variant.load_case; }});
      for (const std::string &parameter : parameters)
        columns.push_back({parameter, [parameter](const StudyRun &run, const StudyPass &) {
                             return value_of(run, parameter);
                           }});
      return columns;
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
    StudyColumns columns;
    for (const StudyColumns &more : {error_columns(), quality_columns(), quantity_columns(), budget_columns(),
                                     reference_columns(), contact_columns(runs), swept_columns(runs)})
      columns.insert(columns.end(), more.begin(), more.end());
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
