// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/report/json.h>
#include <abut/report/page/sections.h>
#include <abut/report/plot.h>
#include <abut/report/svg.h>
#include <abut/study/page_assets.h>
#include <abut/study/page_table.h>
#include <abut/study/study_data.h>
#include <abut/study/study_page.h>
#include <abut/study/study_warnings.h>
#include <abut/study/sweeps.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <sstream>

namespace abut
{
  namespace
  {
    Json json_of(const std::vector<StudyAxis> &axes)
    {
      Json json = Json::array();
      for (const StudyAxis &axis : axes)
        json.push_back({{"name", axis.name}, {"label", axis.label}});
      return json;
    }

    Json json_of(const StudyLine &line, const std::vector<StudyAxis> &errors)
    {
      Json points = Json::array(), orders = Json::object();
      for (const auto &point : line.points)
        points.push_back(point);
      for (const StudyAxis &error : errors)
        for (const StudyAxis &cost : study_costs())
          orders[error.name][cost.name] = number(line.order(error.name, cost.name));
      return {{"title", line.title()},
              {"program", line.program},
              {"name", line.name},
              {"points", points},
              {"order", orders}};
    }

    /// Without other programs, and without orders.
    Json json_of(const Sweep &sweep)
    {
      Json lines = Json::array();
      for (const StudyLine &line : sweep.lines)
        lines.push_back({{"title", line.title()}, {"points", line.points}});
      return {{"name", sweep.parameter.name}, {"label", sweep.parameter.label}, {"lines", lines}};
    }

    Json json_of(const StudyCell &cell)
    {
      if (const auto *const text = std::get_if<std::string>(&cell))
        return text->empty() ? Json(nullptr) : Json(*text);
      return number(std::get<double>(cell));
    }

    Json json_of(const StudyData &data)
    {
      Json rows = Json::array();
      for (const std::vector<StudyCell> &row : data.rows)
      {
        rows.push_back(Json::array());
        for (const StudyCell &cell : row)
          rows.back().push_back(json_of(cell));
      }
      return rows;
    }

    /// Within an element `script`, whose end it must not hold.
    std::string script_json(const Json &json)
    {
      std::string text;
      for (const char c : json.dump(-1, ' ', true, Json::error_handler_t::replace))
        text += c == '<' ? std::string("\\u003c") : std::string(1, c);
      return text;
    }

    /// Within the page: without the head of an XML file.
    std::string static_figure(const std::vector<Plot> &diagrams, const std::string &what,
                              const std::string &name)
    {
      std::string figure = "<figure class=\"static\" data-" + what + "=\"" + xml_text(name) + "\">\n";
      for (const Plot &plot : diagrams)
      {
        const std::string svg = plots({plot});
        figure += svg.substr(svg.find("<svg"));
      }
      return figure + "</figure>\n";
    }

    Plot plot_of(const std::vector<StudyLine> &lines, const StudyAxis &x, const StudyAxis &y,
                 const bool logarithmic)
    {
      Plot plot{"", {x.label, logarithmic}, {y.label, logarithmic}, {}};
      for (const StudyLine &line : lines)
      {
        const double order = logarithmic ? line.order(y.name, x.name) : std::nan("");
        Curve curve{line.title() + (std::isfinite(order) ? ", order " + short_number(order, 2) : ""),
                    {},
                    Curve::Style::marks};
        for (const auto &point : line.points)
          if (point.count(y.name) > 0 && point.count(x.name) > 0)
            curve.points.emplace_back(point.at(x.name), point.at(y.name));
        if (!curve.points.empty())
          plot.curves.push_back(curve);
      }
      return plot;
    }

    /// For every error a figure of all costs.
    std::string error_figures(const std::vector<StudyLine> &lines, const std::vector<StudyAxis> &errors)
    {
      std::string figures;
      for (const StudyAxis &error : errors)
      {
        std::vector<Plot> diagrams;
        for (const StudyAxis &cost : study_costs())
          diagrams.push_back(plot_of(lines, cost, error, true));
        figures += static_figure(diagrams, "error", error.name);
      }
      return figures;
    }

    /// For every quantity a figure of all sweeps.
    std::string quantity_figures(const std::vector<Sweep> &sweeps, const std::vector<StudyAxis> &quantities)
    {
      std::string figures;
      for (const StudyAxis &quantity : quantities)
      {
        std::vector<Plot> diagrams;
        for (const Sweep &sweep : sweeps)
          diagrams.push_back(plot_of(sweep.lines, sweep.parameter, quantity, false));
        figures += static_figure(diagrams, "quantity", quantity.name);
      }
      return figures;
    }

    /// What the errors are against, one sentence.
    std::string reference_text(const StudyData &data)
    {
      const auto column = static_cast<std::size_t>(
          std::find(data.columns.begin(), data.columns.end(), "reference") - data.columns.begin());
      std::set<std::string> references;
      for (const std::vector<StudyCell> &row : data.rows)
        references.insert(std::get<std::string>(row.at(column)));
      std::string text;
      for (const std::string &reference : references)
        if (!reference.empty())
          text +=
              (text.empty() ? "" : ", ") + (reference == fine_run_name ? "a fine run of the same scene"
                                                                       : "the exact solution " + reference);
      return text.empty() ? "No reference is named: errors are estimated."
                          : "Errors are relative, against " + text + ".";
    }

    /// Of a diagram of study.js.
    std::string controls(const std::string &name, const std::string &note)
    {
      const auto box = [&](const std::string &label, const std::string &axis) {
        return "<label>" + label + " <select id=\"" + name + axis + "\"></select></label>\n";
      };
      return "<div class=\"controls interactive\">\n" + box("Show", "-y") + box("against", "-x") +
             "</div>\n<div class=\"interactive\"><div class=\"chart\" id=\"" + name +
             "-chart\"><div class=\"tip\" id=\"" + name + "-tip\"></div></div>\n<ul class=\"legend\" id=\"" +
             name + "-legend\"></ul>\n<p>" + note +
             "A line of the legend shows or hides its curve; marking a part of the diagram enlarges it, a "
             "double click shows all.</p></div>\n";
    }

    std::string quantity_section(const std::vector<StudyRun> &runs, const std::vector<Sweep> &sweeps)
    {
      const std::string diagrams =
          sweeps.empty() ? "" : controls("quantity", "") + quantity_figures(sweeps, known_quantities(runs));
      return "<h2>Quantities</h2>\n" + diagrams + "<p>" + xml_text(quantity_title(runs)) + ".</p>\n" +
             html_table(quantity_table(runs));
    }

    std::string error_section(const StudyData &data, const std::vector<StudyLine> &lines)
    {
      const std::vector<StudyAxis> errors = known_errors(lines);
      if (errors.empty())
        return "";
      return "<h2>Errors</h2>\n<p>" + xml_text(reference_text(data)) + "</p>\n" +
             controls("error", "Orders are those of straight lines through all points, by least squares. ") +
             error_figures(lines, errors);
    }

    Json page_data(const std::string &name, const std::vector<StudyRun> &runs, const StudyData &data,
                   const std::vector<StudyLine> &lines)
    {
      const std::vector<StudyAxis> errors = known_errors(lines);
      Json line_list = Json::array(), sweep_list = Json::array();
      for (const StudyLine &line : lines)
        line_list.push_back(json_of(line, errors));
      for (const Sweep &sweep : sweeps(runs))
        sweep_list.push_back(json_of(sweep));
      return {{"scene", name},
              {"version", ABUT_VERSION},
              {"costs", json_of(study_costs())},
              {"errors", json_of(errors)},
              {"lines", line_list},
              {"quantities", json_of(known_quantities(runs))},
              {"sweeps", sweep_list},
              {"columns", data.columns},
              {"rows", json_of(data)}};
    }
  } // namespace

  std::string study_page(const Scene &scene, const std::vector<StudyRun> &runs,
                         const std::vector<StudyLine> &peers)
  {
    const std::vector<StudyLine> lines = study_lines(runs, peers);
    const StudyData data = study_data(runs);
    const std::string name = std::filesystem::path(scene.file).stem().string();
    std::ostringstream out;
    out << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        << "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        << "<title>Study of " << xml_text(name) << "</title>\n<style>" << uplot_style << study_style
        << "</style>\n</head>\n<body>\n<h1>Study of " << xml_text(name) << "</h1>\n"
        << "<p>" << xml_text(scene.file) << ", abut " ABUT_VERSION ".</p>\n";
    write_warnings(out, study_warnings(runs));
    out << quantity_section(runs, sweeps(runs)) << error_section(data, lines) << "<h2>All passes</h2>\n"
        << passes_table(shown_data(runs)) << "<script type=\"application/json\" id=\"study-data\">"
        << script_json(page_data(name, runs, data, lines)) << "</script>\n<script>\n/*\n"
        << uplot_license << "*/\n"
        << uplot_script << "</script>\n<script>" << study_script << "</script>\n</body>\n</html>\n";
    return out.str();
  }
} // namespace abut
