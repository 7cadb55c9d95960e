// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/report/page/html.h>
#include <abut/report/svg.h>

#include <cmath>
#include <ostream>

namespace abut
{
  namespace
  {
    constexpr std::size_t shown_at_an_end = 100, // rows
        many_columns = 9;                        // small type from there on

    /// 1.5e-05 as 1.5·10⁻⁵.
    std::string with_power(const std::string &number)
    {
      const std::size_t e = number.find('e');
      if (e == std::string::npos)
        return number;
      const int exponent = std::stoi(number.substr(e + 1));
      return number.substr(0, e) + "·10<sup>" + (exponent < 0 ? "−" : "") +
             std::to_string(std::abs(exponent)) + "</sup>";
    }

    std::string data_element(const double value, const std::string &text)
    {
      return std::isfinite(value) ? "<data value=\"" + exact_number(value) + "\">" + text + "</data>" : "-";
    }

    void write_row(std::ostream &out, const std::vector<std::string> &row)
    {
      out << "<tr>";
      for (std::size_t i = 0; i < row.size(); ++i)
        if (i == 0)
          out << "<th scope=\"row\">" << row[i] << "</th>";
        else
          out << "<td>" << row[i] << "</td>";
      out << "</tr>\n";
    }

    void write_rows(std::ostream &out, const HtmlTable &table)
    {
      const std::size_t n = table.rows.size();
      for (std::size_t i = 0; i < n; ++i)
      {
        write_row(out, table.rows[i]);
        if (n <= 2 * shown_at_an_end || i + 1 != shown_at_an_end)
          continue;
        const std::size_t left_out = n - 2 * shown_at_an_end;
        out << "<tr><td class=\"note\" colspan=\"" << table.columns.size() << "\">" << left_out
            << " rows are left out here</td></tr>\n";
        i += left_out;
      }
    }
  } // namespace

  std::string html_number(const double value, const int digits)
  {
    return data_element(value, with_power(short_number(value, digits)));
  }

  std::string html_number(const std::optional<double> &value, const std::string &otherwise, const int digits)
  {
    return value ? html_number(*value, digits) : otherwise;
  }

  std::string html_percent(const double share, const int digits)
  {
    return data_element(share, with_power(short_number(100. * share, digits)) + " %");
  }

  std::string html_percent(const std::optional<double> &share, const std::string &otherwise, const int digits)
  {
    return share ? html_percent(*share, digits) : otherwise;
  }

  void write_table(std::ostream &out, const HtmlTable &table)
  {
    out << "<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"" << xml_text(table.caption)
        << "\">\n<table" << (table.columns.size() > many_columns ? " class=\"many\"" : "") << ">\n<caption>"
        << xml_text(table.caption) << "</caption>\n<thead><tr>";
    for (const std::string &column : table.columns)
      out << "<th scope=\"col\">" << column << "</th>";
    out << "</tr></thead>\n<tbody>\n";
    write_rows(out, table);
    out << "</tbody>\n</table>\n</div>\n";
  }
} // namespace abut
