// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/table.h>
#include <abut/report/page/diagram.h>
#include <abut/report/page/html.h>
#include <abut/report/page/sections.h>
#include <abut/report/svg.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <ostream>

namespace abut
{
  namespace
  {
    constexpr std::size_t most_marked_passes = 60;
    using OfPass = std::function<std::optional<double>(const PassRecord &)>;

    struct ErrorCurve
    {
      std::string name;
      OfPass error;
    };

    const std::vector<ErrorCurve> &error_curves()
    {
      static const std::vector<ErrorCurve> curves = {
          {"discretisation", [](const PassRecord &pass) { return pass.budget.discretisation; }},
          {"contact", [](const PassRecord &pass) { return pass.budget.contact; }},
          {"iteration", [](const PassRecord &pass) { return pass.budget.iteration; }},
          {"penalty", [](const PassRecord &pass) { return pass.budget.penalty; }},
          {"linear algebra", [](const PassRecord &pass) { return pass.budget.linear_algebra; }},
          {"geometry", [](const PassRecord &pass) { return pass.budget.geometry; }},
          {"estimate", [](const PassRecord &pass) { return pass.budget.estimate(); }},
          {"bound", [](const PassRecord &pass) { return pass.budget.bound(); }},
          {"true error", [](const PassRecord &pass) { return pass.true_errors.energy; }}};
      return curves;
    }

    /// What curves do not go below: a thousandth of the smallest estimate, true error or, without these,
    /// part.
    double lowest_shown(const std::vector<PassRecord> &passes)
    {
      double whole = std::numeric_limits<double>::infinity();
      for (const PassRecord &pass : passes)
        for (const auto &error : {pass.budget.estimate(), pass.true_errors.energy})
          if (error && *error > 0.)
            whole = std::min(whole, *error);
      return std::isfinite(whole) ? 1e-3 * whole : 0.;
    }

    std::vector<Curve> curves_against(const std::vector<PassRecord> &passes,
                                      const std::function<double(const PassRecord &)> &abscissa)
    {
      const auto style = passes.size() <= most_marked_passes ? Curve::Style::marks : Curve::Style::line;
      const double lowest = lowest_shown(passes);
      std::vector<Curve> curves;
      for (const ErrorCurve &curve : error_curves())
      {
        curves.push_back({curve.name, {}, style});
        for (const PassRecord &pass : passes)
          if (const auto error = curve.error(pass); error && *error > lowest && std::isfinite(*error))
            curves.back().points.emplace_back(abscissa(pass), *error);
      }
      return curves;
    }

    void write_error_diagrams(std::ostream &out, const std::vector<PassRecord> &passes)
    {
      const Plot by_pass{
          "Error against the pass",
          {"pass"},
          {"relative error, energy norm", true},
          curves_against(passes, [](const PassRecord &pass) { return static_cast<double>(pass.pass); })};
      const Plot by_seconds{"Error against seconds",
                            {"seconds since the run began", true},
                            by_pass.y,
                            curves_against(passes, [](const PassRecord &pass) { return pass.seconds; })};
      if (std::all_of(by_pass.curves.begin(), by_pass.curves.end(),
                      [](const Curve &curve) { return curve.points.empty(); }))
      {
        out << "<p class=\"note\">No error was estimated.</p>\n";
        return;
      }
      out << "<figure class=\"beside\">\n";
      write_diagram(out, by_pass);
      write_diagram(out, by_seconds);
      out << "<figcaption>The parts of the error and the whole, pass by pass; not drawn: what was not "
             "estimated, and what is below a thousandth of the whole.</figcaption>\n</figure>\n";
    }

    /// Without columns that have no number in any row.
    HtmlTable without_empty_columns(const HtmlTable &table)
    {
      TextTable cells{table.columns};
      cells.insert(cells.end(), table.rows.begin(), table.rows.end());
      cells = abut::without_empty_columns(cells);
      return {table.caption, cells.front(), {cells.begin() + 1, cells.end()}};
    }

    std::string total_cell(const PassRecord &pass)
    {
      return pass.total ? (pass.error_is_bound() ? "≤ " : "~ ") + html_percent(*pass.total) : "-";
    }

    void write_pass_table(std::ostream &out, const std::vector<PassRecord> &passes, const bool has_contact)
    {
      HtmlTable table{"Passes; errors are relative",
                      {"pass", "cells", "unknowns", "steps", "eta max", "estimated", "iteration", "total",
                       "pressure", "true, energy", "true, stress", "true, pressure", "effectivity",
                       "of total", "normal force", "peak pressure", "seconds"},
                      {}};
      for (const PassRecord &pass : passes)
        table.rows.push_back(
            {std::to_string(pass.pass), std::to_string(pass.counts.cells), std::to_string(pass.counts.dofs),
             has_contact ? std::to_string(pass.steps) : "-", html_number(pass.eta_max, "-", 3),
             html_percent(pass.discretisation, "-"), has_contact ? html_percent(pass.iteration) : "-",
             total_cell(pass), html_percent(pass.pressure, "-"), html_percent(pass.true_errors.energy, "-"),
             html_percent(pass.true_errors.stress, "-"), html_percent(pass.true_errors.pressure, "-"),
             html_number(pass.effectivity(), "-", 3), html_number(pass.effectivity_total, "-", 3),
             has_contact ? html_number(pass.normal_force, 6) : "-",
             has_contact ? html_number(pass.max_pressure, 5) : "-", html_number(pass.seconds, 3)});
      write_table(out, without_empty_columns(table));
    }
  } // namespace

  void write_errors(std::ostream &out, const Results &results)
  {
    out << "<section aria-labelledby=\"passes-title\">\n<h2 id=\"passes-title\">Errors, pass by pass</h2>\n";
    if (results.passes.size() > 1)
      write_error_diagrams(out, results.passes);
    write_pass_table(out, results.passes, !results.pairs.empty());
    if (results.adaptation_end)
      out << "<p>The adaptation ended by: " << xml_text(results.adaptation_end->stopped_by) << ".</p>\n";
    out << "</section>\n";
  }
} // namespace abut
