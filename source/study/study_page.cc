// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/report/json.h>
#include <abut/report/plot.h>
#include <abut/report/svg.h>
#include <abut/study/page_assets.h>
#include <abut/study/study_page.h>

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

    std::string static_figure(const std::vector<StudyLine> &lines, const StudyAxis &error,
                              const StudyAxis &cost)
    {
      Plot plot{"", {cost.label, true}, {error.label, true}, {}};
      for (const StudyLine &line : lines)
      {
        const double order = line.order(error.name, cost.name);
        Curve curve{line.title() + (std::isfinite(order) ? ", order " + short_number(order, 2) : ""),
                    {},
                    Curve::Style::marks};
        for (const auto &point : line.points)
          if (point.count(error.name) > 0 && point.count(cost.name) > 0)
            curve.points.emplace_back(point.at(cost.name), point.at(error.name));
        if (!curve.points.empty())
          plot.curves.push_back(curve);
      }
      const std::string svg = plots({plot});
      return svg.substr(svg.find("<svg")); // without the head of an XML file
    }

    /// For every error a figure of all costs.
    std::string static_figures(const std::vector<StudyLine> &lines, const std::vector<StudyAxis> &errors)
    {
      std::ostringstream out;
      for (const StudyAxis &error : errors)
      {
        out << "<figure class=\"static\" data-error=\"" << xml_text(error.name) << "\">\n";
        for (const StudyAxis &cost : study_costs())
          out << static_figure(lines, error, cost);
        out << "</figure>\n";
      }
      return out.str();
    }

    bool has_content(const StudyData &data, const std::size_t column)
    {
      for (const std::vector<StudyCell> &row : data.rows)
      {
        const auto *const text = std::get_if<std::string>(&row[column]);
        if (text != nullptr ? !text->empty() : std::isfinite(std::get<double>(row[column])))
          return true;
      }
      return false;
    }

    /// Whether a column is left out in print, which has no room for all of them.
    bool is_detail(const std::string &column, const StudyCell &cell)
    {
      static const std::set<std::string> printed = {"pass",
                                                    "cells",
                                                    "dofs",
                                                    "steps",
                                                    "wall_time_s",
                                                    "true_error_stress",
                                                    "true_error_energy",
                                                    "true_error_pressure",
                                                    "true_error_force",
                                                    "error_stress",
                                                    "budget_estimate",
                                                    "contact_force",
                                                    "max_pressure",
                                                    "contact_length",
                                                    "max_von_mises"};
      return column == "reference" || (std::holds_alternative<double>(cell) && printed.count(column) == 0);
    }

    /// The name of a column, which may go on in another line behind an underscore.
    std::string breakable(const std::string &column)
    {
      std::string text;
      for (const char c : xml_text(column))
        text += c == '_' ? std::string("_<wbr>") : std::string(1, c);
      return text;
    }

    std::string shown_cell(const StudyCell &cell)
    {
      if (const auto *const text = std::get_if<std::string>(&cell))
        return xml_text(*text);
      const double value = std::get<double>(cell);
      const bool is_count = std::floor(value) == value && std::abs(value) < 1e15;
      return short_number(value, is_count ? 15 : 4);
    }

    /// The columns that hold something.
    std::string table_of(const StudyData &data)
    {
      std::ostringstream out;
      const auto write_row = [&](const auto &shown, const std::string &element) {
        out << "<tr>";
        for (std::size_t i = 0; i < data.columns.size(); ++i)
          if (has_content(data, i))
          {
            const StudyCell &first = data.rows.front()[i];
            const bool is_text = std::holds_alternative<std::string>(first);
            out << '<' << element << " class=\"" << (is_text ? "text" : "number")
                << (is_detail(data.columns[i], first) ? " detail" : "") << "\">" << shown(i) << "</"
                << element << '>';
          }
        out << "</tr>\n";
      };
      out << "<div class=\"scroll\"><table>\n<thead>";
      write_row([&](const std::size_t i) { return breakable(data.columns[i]); }, "th");
      out << "</thead>\n<tbody>\n";
      for (const std::vector<StudyCell> &row : data.rows)
        write_row([&](const std::size_t i) { return shown_cell(row[i]); }, "td");
      out << "</tbody></table></div>\n";
      return out.str();
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

    constexpr auto controls = R"(<div class="controls interactive">
<label>Show <select id="error"></select></label>
<label>against <select id="cost"></select></label>
</div>
<div class="interactive"><div class="chart" id="chart"><div class="tip" id="tip"></div></div>
<ul class="legend" id="legend"></ul>
<p>Orders are those of straight lines through all points, by least squares. A line of the legend shows or hides its curve;
marking a part of the diagram enlarges it, a double click shows all.</p></div>
)";
  } // namespace

  std::string study_page(const Scene &scene, const StudyData &data, const std::vector<StudyLine> &lines)
  {
    const std::vector<StudyAxis> errors = known_errors(lines);
    const std::string name = std::filesystem::path(scene.file).stem().string();
    Json line_list = Json::array();
    for (const StudyLine &line : lines)
      line_list.push_back(json_of(line, errors));
    const Json json = {{"scene", name},
                       {"version", ABUT_VERSION},
                       {"costs", json_of(study_costs())},
                       {"errors", json_of(errors)},
                       {"lines", line_list},
                       {"columns", data.columns},
                       {"rows", json_of(data)}};
    std::ostringstream out;
    out << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        << "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        << "<title>Study of " << xml_text(name) << "</title>\n<style>" << uplot_style << study_style
        << "</style>\n</head>\n<body>\n<h1>Study of " << xml_text(name) << "</h1>\n"
        << "<p>" << xml_text(scene.file) << ", abut " ABUT_VERSION ". " << xml_text(reference_text(data))
        << "</p>\n"
        << controls << static_figures(lines, errors) << "<h2>All passes</h2>\n"
        << table_of(data) << "<script type=\"application/json\" id=\"study-data\">" << script_json(json)
        << "</script>\n<script>\n/*\n"
        << uplot_license << "*/\n"
        << uplot_script << "</script>\n<script>" << study_script << "</script>\n</body>\n</html>\n";
    return out.str();
  }
} // namespace abut
