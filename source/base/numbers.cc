// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace abut
{
  namespace
  {
    std::string formatted(const double value, const int digits)
    {
      std::ostringstream out;
      out.imbue(std::locale::classic());
      out << std::setprecision(digits) << value;
      return out.str();
    }
  } // namespace

  std::string exact_number(const double value)
  {
    return std::isfinite(value) ? formatted(value, std::numeric_limits<double>::max_digits10) : "";
  }

  std::string short_number(const double value, const int digits)
  {
    return std::isfinite(value) ? formatted(value, digits) : "-";
  }

  std::string aligned(const std::vector<std::vector<std::string>> &rows)
  {
    std::vector<std::size_t> widths;
    for (const auto &row : rows)
    {
      widths.resize(std::max(widths.size(), row.size()), 0);
      for (std::size_t column = 0; column < row.size(); ++column)
        widths[column] = std::max(widths[column], row[column].size());
    }
    std::ostringstream out;
    for (const auto &row : rows)
    {
      for (std::size_t column = 0; column < row.size(); ++column)
      {
        const std::string padding(widths[column] - row[column].size(), ' ');
        if (column == 0)
          out << "  " << row[column] << (row.size() > 1 ? padding : "");
        else
          out << "  " << padding << row[column];
      }
      out << '\n';
    }
    return out.str();
  }
} // namespace abut
