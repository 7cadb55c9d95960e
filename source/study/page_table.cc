// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/report/svg.h>
#include <abut/study/page_table.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <sstream>

namespace abut
{
  namespace
  {
    bool has_content(const StudyData &data, const std::size_t column)
    {
      return std::any_of(data.rows.begin(), data.rows.end(), [&](const std::vector<StudyCell> &row) {
        const auto *const text = std::get_if<std::string>(&row[column]);
        return text != nullptr ? !text->empty() : std::isfinite(std::get<double>(row[column]));
      });
    }

    /// Whether a column is left out in print.
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
      return column == "reference" || column == "warnings" ||
             (std::holds_alternative<double>(cell) && printed.count(column) == 0);
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

    void write_table_row(std::ostream &out, const TextTable::value_type &cells, const std::string &element,
                         const std::vector<std::string> &classes)
    {
      out << "<tr>";
      for (std::size_t i = 0; i < cells.size(); ++i)
        out << '<' << element << " class=\"" << classes[i] << "\">" << cells[i] << "</" << element << '>';
      out << "</tr>\n";
    }

    /// Cells are HTML, the first row has the headings; `classes`: of the columns.
    std::string table_of(const TextTable &table, const std::vector<std::string> &classes)
    {
      std::ostringstream out;
      out << "<div class=\"scroll\"><table>\n<thead>";
      write_table_row(out, table.front(), "th", classes);
      out << "</thead>\n<tbody>\n";
      for (std::size_t i = 1; i < table.size(); ++i)
        write_table_row(out, table[i], "td", classes);
      out << "</tbody></table></div>\n";
      return out.str();
    }
  } // namespace

  std::string passes_table(const StudyData &data)
  {
    TextTable table(1 + data.rows.size());
    std::vector<std::string> classes;
    for (std::size_t column = 0; column < data.columns.size(); ++column)
    {
      if (!has_content(data, column))
        continue;
      const StudyCell &first = data.rows.front()[column];
      classes.push_back(std::string(std::holds_alternative<std::string>(first) ? "text" : "number") +
                        (is_detail(data.columns[column], first) ? " detail" : ""));
      table.front().push_back(breakable(data.columns[column]));
      for (std::size_t row = 0; row < data.rows.size(); ++row)
        table[row + 1].push_back(shown_cell(data.rows[row][column]));
    }
    return table_of(table, classes);
  }

  std::string html_table(const TextTable &table)
  {
    TextTable cells = table;
    for (auto &row : cells)
      std::transform(row.begin(), row.end(), row.begin(), xml_text);
    return table_of(cells, std::vector<std::string>(table.front().size(), "number"));
  }
} // namespace abut
