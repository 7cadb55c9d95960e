// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/counts.h>
#include <abut/report/forces.h>
#include <abut/report/page/html.h>
#include <abut/report/page/sections.h>
#include <abut/report/svg.h>

#include <algorithm>
#include <ostream>

namespace abut
{
  namespace
  {
    const std::string unknown = "not estimated";

    void write_contact_table(std::ostream &out, const std::vector<PairResult> &pairs)
    {
      if (pairs.empty())
        return;
      HtmlTable table{
          "Contacts",
          {"contact", "normal force", "peak pressure", "contact length", "penetration", "largest sliding"},
          {}};
      for (const PairResult &pair : pairs)
        table.rows.push_back({xml_text(pair.pair->name()), html_number(pair.normal_force, 6),
                              html_number(pair.max_pressure, 5), html_number(pair.contact_length),
                              html_number(pair.max_penetration, 3), html_number(pair.max_sliding, 3)});
      write_table(out, table);
    }

    void write_body_table(std::ostream &out, const std::vector<BodyResult> &bodies)
    {
      HtmlTable table{"Bodies",
                      {"body", "cells", "unknowns", "strain energy", "largest von Mises stress",
                       "largest strain", "largest displacement"},
                      {}};
      for (const BodyResult &body : bodies)
      {
        const Counts counts = body.body->counts();
        table.rows.push_back({xml_text(body.body->name()), std::to_string(counts.cells),
                              std::to_string(counts.dofs), html_number(body.energy, 6),
                              html_number(body.peaks.von_mises.value), html_percent(body.peaks.strain.value),
                              html_number(body.peaks.displacement.value)});
      }
      write_table(out, table);
    }

    void write_forces(std::ostream &out, const Results &results)
    {
      HtmlTable table{"Forces on the bodies, by unit of thickness", {"body", "from", "x", "y"}, {}};
      for (const ForceOnBody &force : forces_on_bodies(results))
        table.rows.push_back({xml_text(force.body), xml_text(force.origin), html_number(force.force.x(), 6),
                              html_number(force.force.y(), 6)});
      if (table.rows.empty())
        return;
      write_table(out, table);
      if (!results.pairs.empty())
        out << "<p class=\"note\">A contact's force is that on its slave side; the master gets the "
               "opposite.</p>\n";
      for (const Imbalance &found : imbalances(results))
        out << "<p class=\"note\">Body " << xml_text(found.body) << " is out of balance: forces by "
            << html_percent(found.forces, 2) << " of their sizes, moments by "
            << html_percent(found.moments, 2) << ".</p>\n";
    }

    void write_points(std::ostream &out, const std::vector<PointResult> &points)
    {
      HtmlTable table{
          "Points", {"body", "x", "y", "displacement x", "displacement y", "von Mises stress"}, {}};
      for (const PointResult &point : points)
        table.rows.push_back({xml_text(point.body->name()), html_number(point.place.x()),
                              html_number(point.place.y()), html_number(point.displacement.x(), 6),
                              html_number(point.displacement.y(), 6),
                              html_number(point.stress.von_mises(), 5)});
      if (!table.rows.empty())
        write_table(out, table);
    }

    void write_budget(std::ostream &out, const PassRecord &pass, const bool has_contact)
    {
      const ErrorBudget &budget = pass.budget;
      HtmlTable table{"Parts of the error (energy norm)", {"part", "error"}, {}};
      const auto row = [&](const std::string &name, const std::optional<double> &error,
                           const std::string &otherwise = unknown) {
        table.rows.push_back({name, html_percent(error, otherwise)});
      };
      row("discretisation", budget.discretisation);
      if (has_contact)
      {
        row("contact", budget.contact);
        row("iteration", budget.iteration);
        row("penalty", budget.penalty);
      }
      row("linear algebra", budget.linear_algebra);
      row("geometry", budget.geometry);
      row("<strong>estimate of the whole</strong>", budget.estimate());
      row("<strong>bound of the whole</strong>", budget.bound(), "no bound");
      if (pass.true_errors.energy)
        row("<strong>true error</strong>", pass.true_errors.energy);
      write_table(out, table);
      if (budget.estimate() && !pass.estimate_reason.empty())
        out << "<p class=\"note\">An estimate and no bound: " << xml_text(pass.estimate_reason) << ".</p>\n";
    }

    void write_true_errors(std::ostream &out, const TrueErrors &errors)
    {
      HtmlTable table{"Against the exact solution", {"quantity", "error"}, {}};
      const auto row = [&](const std::string &name, const std::optional<double> &error) {
        if (error)
          table.rows.push_back({name, html_percent(*error)});
      };
      row("displacement, energy norm", errors.energy);
      row("stress", errors.stress);
      row("pressure", errors.pressure);
      row("force", errors.force);
      if (!table.rows.empty())
        write_table(out, table);
    }
  } // namespace

  void write_key_figures(std::ostream &out, const Results &results)
  {
    out << "<section aria-labelledby=\"figures-title\">\n<h2 id=\"figures-title\">Key figures</h2>\n"
           "<p class=\"note\">In the units of the parameter file.</p>\n";
    write_contact_table(out, results.pairs);
    write_forces(out, results);
    write_body_table(out, results.bodies);
    write_points(out, results.points);
    out << "<div class=\"beside\">\n<div>\n";
    write_budget(out, results.passes.empty() ? PassRecord() : results.passes.back(), !results.pairs.empty());
    out << "</div>\n<div>\n";
    write_true_errors(out, results.true_errors);
    out << "</div>\n</div>\n</section>\n";
  }
} // namespace abut
