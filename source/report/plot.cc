// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/report/plot.h>
#include <abut/report/plot_range.h>
#include <abut/report/svg.h>

#include <algorithm>
#include <array>
#include <sstream>

namespace abut
{
  namespace
  {
    // Pixels: the frame of a diagram, and what is left free around it.
    constexpr double frame_width = 420., frame_height = 300., left_room = 86., right_room = 20.,
                     top_room = 34., bottom_room = 50., legend_line = 18.;
    const std::array<const char *, 7> curve_colours = {
        {"#1b6ca8", "#d7191c", "#2a9d4b", "#8e44ad", "#e08214", "#555", "#17a2a2"}};

    void write_axes(std::ostream &out, const Plot &plot, const PlotRange &range, const Vector2 &corner)
    {
      out << "<rect x=\"" << corner.x() << "\" y=\"" << corner.y() << "\" width=\"" << frame_width
          << "\" height=\"" << frame_height << "\" fill=\"none\" stroke=\"#333\"/>\n<g stroke=\"#ddd\">\n";
      std::ostringstream labels;
      labels.imbue(std::locale::classic());
      for (const double tick : range.x.ticks())
      {
        const double x = corner.x() + range.x.share(tick) * frame_width;
        out << "<path d=\"M" << x << ' ' << corner.y() << 'v' << frame_height << "\"/>\n";
        write_text(labels, {x, corner.y() + frame_height + 17.}, Anchor::middle, short_number(tick, 6));
      }
      for (const double tick : range.y.ticks())
      {
        const double y = corner.y() + (1. - range.y.share(tick)) * frame_height;
        out << "<path d=\"M" << corner.x() << ' ' << y << 'h' << frame_width << "\"/>\n";
        write_text(labels, {corner.x() - 6., y + 4.}, Anchor::end, short_number(tick, 6));
      }
      out << "</g>\n" << labels.str();
      write_text(out, corner + Vector2(.5 * frame_width, frame_height + 36.), Anchor::middle, plot.x.label);
      write_text(out, corner + Vector2(0., -8.), Anchor::start,
                 plot.title.empty() ? plot.y.label : plot.title + ": " + plot.y.label);
    }

    /// Colour and dashes; every colour again after seven curves.
    std::string stroke(const Curve &curve, const std::size_t index)
    {
      const bool thin = curve.style == Curve::Style::marks;
      return std::string("fill=\"none\" stroke-linejoin=\"round\" stroke=\"") +
             curve_colours[index % curve_colours.size()] + "\" stroke-width=\"" + (thin ? "1" : "1.8") +
             "\"" + (curve.style == Curve::Style::dashed ? " stroke-dasharray=\"6 4\"" : "");
    }

    void write_marks(std::ostream &out, const Polyline &places, const std::size_t index)
    {
      out << "<g fill=\"" << curve_colours[index % curve_colours.size()] << "\">\n";
      for (const Vector2 &place : places)
        out << "<circle r=\"2.6\" cx=\"" << short_number(place.x(), 5) << "\" cy=\""
            << short_number(place.y(), 5) << "\"/>\n";
      out << "</g>\n";
    }

    PageFrame page()
    {
      PageFrame frame;
      frame.scale = 1.;
      return frame;
    }

    void write_curve(std::ostream &out, const Polyline &places, const Curve &curve, const std::size_t index)
    {
      Polyline upwards; // write_path counts upwards
      for (const Vector2 &place : places)
        upwards.emplace_back(place.x(), -place.y());
      write_path(out, upwards, page(), false, stroke(curve, index));
      if (curve.style == Curve::Style::marks)
        write_marks(out, places, index);
    }

    void write_plot(std::ostream &out, const Plot &plot, const Vector2 &corner)
    {
      const PlotRange range = range_of(plot);
      write_axes(out, plot, range, corner);
      for (std::size_t i = 0; i < plot.curves.size(); ++i)
      {
        Polyline places;
        for (const Vector2 &point : plot.curves[i].points)
          if (range.shows(point))
            places.push_back(corner + Vector2(range.x.share(point.x()) * frame_width,
                                              (1. - range.y.share(point.y())) * frame_height));
        write_curve(out, places, plot.curves[i], i);
        const Vector2 line =
            corner + Vector2(0., frame_height + bottom_room + static_cast<double>(i) * legend_line);
        write_curve(out, {line, line + Vector2(30., 0.)}, plot.curves[i], i);
        write_text(out, line + Vector2(40., 4.), Anchor::start, plot.curves[i].name);
      }
    }
  } // namespace

  std::string plots(const std::vector<Plot> &diagrams)
  {
    std::size_t n_lines = 0;
    for (const Plot &plot : diagrams)
      n_lines = std::max(n_lines, plot.curves.size());
    const double column = left_room + frame_width + right_room;
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.precision(6);
    write_svg_head(
        out, Vector2(column * static_cast<double>(diagrams.size()),
                     top_room + frame_height + bottom_room + legend_line * static_cast<double>(n_lines)));
    for (std::size_t i = 0; i < diagrams.size(); ++i)
      write_plot(out, diagrams[i], Vector2(left_room + column * static_cast<double>(i), top_room));
    out << "</svg>\n";
    return out.str();
  }
} // namespace abut
