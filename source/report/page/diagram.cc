// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/report/page/diagram.h>
#include <abut/report/plot_range.h>
#include <abut/report/svg.h>

#include <algorithm>
#include <ostream>

namespace abut
{
  namespace
  {
    // Units of the element's own.
    constexpr double diagram_width = 440., area_width = 350., area_height = 220., area_left = 74.,
                     area_top = 26., legend_top = area_top + area_height + 54., legend_step = 18.;
    constexpr std::size_t most_titles = 80; // of a curve
    constexpr std::size_t n_curve_classes = 8;

    class DiagramFrame
    {
    public:
      explicit DiagramFrame(const PlotRange &range) : range_(range) {}
      double x(const double value) const { return area_left + area_width * range_.x.share(value); }
      double y(const double value) const { return area_top + area_height * (1. - range_.y.share(value)); }
      bool shows(const Vector2 &point) const { return range_.shows(point); }
      std::vector<double> x_ticks() const { return range_.x.ticks(); }
      std::vector<double> y_ticks() const { return range_.y.ticks(); }

    private:
      PlotRange range_;
    };

    std::string place(const double value)
    {
      return short_number(value, 5);
    }

    void write_grid(std::ostream &out, const Plot &plot, const DiagramFrame &frame)
    {
      const double bottom = area_top + area_height;
      out << "<g class=\"grid\">";
      for (const double tick : frame.x_ticks())
        out << "<path d=\"M" << place(frame.x(tick)) << ' ' << area_top << 'v' << area_height << "\"/>";
      for (const double tick : frame.y_ticks())
        out << "<path d=\"M" << area_left << ' ' << place(frame.y(tick)) << 'h' << area_width << "\"/>";
      out << "</g>\n<rect class=\"frame\" x=\"" << area_left << "\" y=\"" << area_top << "\" width=\""
          << area_width << "\" height=\"" << area_height << "\"/>\n";
      for (const double tick : frame.x_ticks())
        write_text(out, {frame.x(tick), bottom + 16.}, Anchor::middle, short_number(tick, 6));
      for (const double tick : frame.y_ticks())
        write_text(out, {area_left - 6., frame.y(tick) + 4.}, Anchor::end, short_number(tick, 6));
      write_text(out, {area_left + .5 * area_width, bottom + 34.}, Anchor::middle, plot.x.label);
      write_text(out, {area_left, area_top - 9.}, Anchor::start, plot.y.label);
    }

    void write_line(std::ostream &out, const Curve &curve, const DiagramFrame &frame)
    {
      out << "<path d=\"";
      char command = 'M';
      for (const Vector2 &point : curve.points)
        if (frame.shows(point))
        {
          out << command << place(frame.x(point.x())) << ' ' << place(frame.y(point.y()));
          command = 'L';
        }
        else
          command = 'M';
      out << "\"/>\n";
    }

    void write_points(std::ostream &out, const Curve &curve, const DiagramFrame &frame)
    {
      const std::size_t every = curve.points.size() / most_titles + 1;
      for (std::size_t i = 0; i < curve.points.size(); i += every)
      {
        const Vector2 &point = curve.points[i];
        if (frame.shows(point))
          out << "<circle class=\"" << (curve.style == Curve::Style::marks ? "mark" : "spot")
              << "\" r=\"3\" cx=\"" << place(frame.x(point.x())) << "\" cy=\"" << place(frame.y(point.y()))
              << "\"><title>" << xml_text(curve.name) << ": " << short_number(point.y(), 5) << " at "
              << short_number(point.x(), 5) << "</title></circle>\n";
      }
    }

    void write_legend_entry(std::ostream &out, const Curve &curve, const std::size_t position)
    {
      const double y = legend_top + legend_step * static_cast<double>(position / 2),
                   x = area_left + .5 * area_width * static_cast<double>(position % 2);
      out << "<path d=\"M" << x << ' ' << y << "h32\"/>\n";
      if (curve.style == Curve::Style::marks)
        out << "<circle class=\"mark\" r=\"3\" cx=\"" << x + 16. << "\" cy=\"" << y << "\"/>\n";
      write_text(out, {x + 38., y + 4.}, Anchor::start, curve.name);
    }
  } // namespace

  void write_diagram(std::ostream &out, const Plot &plot)
  {
    const DiagramFrame frame(range_of(plot));
    const auto n_curves = std::count_if(plot.curves.begin(), plot.curves.end(),
                                        [](const Curve &curve) { return !curve.points.empty(); });
    out << "<svg class=\"diagram\" role=\"img\" aria-label=\"" << xml_text(plot.title) << "\" viewBox=\"0 0 "
        << diagram_width << ' ' << legend_top - 6. + legend_step * static_cast<double>((n_curves + 1) / 2)
        << "\">\n";
    write_grid(out, plot, frame);
    std::size_t position = 0;
    for (std::size_t i = 0; i < plot.curves.size(); ++i)
    {
      if (plot.curves[i].points.empty())
        continue;
      out << "<g class=\"curve c" << i % n_curve_classes << "\">\n";
      write_line(out, plot.curves[i], frame);
      write_points(out, plot.curves[i], frame);
      write_legend_entry(out, plot.curves[i], position++);
      out << "</g>\n";
    }
    out << "</svg>\n";
  }

  Polyline thinned(const Polyline &points, const std::size_t n)
  {
    if (points.size() <= 2 * n)
      return points;
    const auto below = [](const Vector2 &a, const Vector2 &b) { return a.y() < b.y(); };
    const auto size = static_cast<std::ptrdiff_t>(points.size() / n + 1);
    Polyline result;
    for (auto begin = points.begin(); begin != points.end();)
    {
      const auto end = begin + std::min(size, points.end() - begin);
      auto [low, high] = std::minmax_element(begin, end, below);
      result.push_back(*std::min(low, high));
      if (low != high)
        result.push_back(*std::max(low, high));
      begin = end;
    }
    return result;
  }
} // namespace abut
