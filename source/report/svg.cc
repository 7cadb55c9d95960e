// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/report/svg.h>

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <ostream>

namespace abut
{
  namespace
  {
    /// To a hundredth, in as few digits as that takes.
    std::string hundredths(const double value)
    {
      std::array<char, std::numeric_limits<double>::max_exponent10 + 8> digits;
      const std::to_chars_result end =
          std::to_chars(digits.data(), digits.data() + digits.size(), std::round(100. * value) / 100.,
                        std::chars_format::fixed);
      return std::string(digits.data(), end.ptr);
    }
  } // namespace

  std::string xml_text(const std::string &text)
  {
    std::string result;
    for (const char c : text)
      switch (c)
      {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
      }
    return result;
  }

  void write_svg_head(std::ostream &out, const Vector2 &size)
  {
    out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
           "viewBox=\"0 0 "
        << size.x() << ' ' << size.y() << "\" width=\"" << size.x() << "\" height=\"" << size.y()
        << "\" font-family=\"sans-serif\" font-size=\"13\" fill=\"#222\">\n"
        << "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
  }

  void write_path(std::ostream &out, const Polyline &points, const PageFrame &frame, const bool closed,
                  const std::string &attributes)
  {
    std::string data;
    for (const Vector2 &point : points)
    {
      const Vector2 place = frame(point);
      data += data.empty() ? 'M' : 'L';
      data += hundredths(place.x());
      data += ' ';
      data += hundredths(place.y());
    }
    out << "<path " << attributes << " d=\"" << data << (closed ? "Z" : "") << "\"/>\n";
  }

  void write_text(std::ostream &out, const Vector2 &place, const Anchor anchor, const std::string &text)
  {
    const char *const words[] = {"start", "middle", "end"};
    out << "<text x=\"" << hundredths(place.x()) << "\" y=\"" << hundredths(place.y()) << "\" text-anchor=\""
        << words[static_cast<int>(anchor)] << "\">" << xml_text(text) << "</text>\n";
  }
} // namespace abut
