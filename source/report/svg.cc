// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/report/svg.h>

#include <cmath>
#include <ostream>

namespace abut
{
  namespace
  {
    double hundredths(const double value)
    {
      return std::round(100. * value) / 100.;
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
    out << "<path " << attributes << " d=\"";
    char command = 'M';
    for (const Vector2 &point : points)
    {
      const Vector2 place = frame(point);
      out << command << hundredths(place.x()) << ' ' << hundredths(place.y());
      command = 'L';
    }
    out << (closed ? "Z" : "") << "\"/>\n";
  }

  void write_text(std::ostream &out, const Vector2 &place, const Anchor anchor, const std::string &text)
  {
    const char *const words[] = {"start", "middle", "end"};
    out << "<text x=\"" << hundredths(place.x()) << "\" y=\"" << hundredths(place.y()) << "\" text-anchor=\""
        << words[static_cast<int>(anchor)] << "\">" << xml_text(text) << "</text>\n";
  }
} // namespace abut
