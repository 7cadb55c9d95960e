// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/report/colour_bar.h>
#include <abut/report/comb.h>
#include <abut/report/picture.h>
#include <abut/report/svg.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

namespace abut
{
  namespace
  {
    constexpr unsigned int most_cells = 40000;
    // Pixels.
    constexpr double page_width = 1000., largest_height = 700., margin = 24., caption_height = 64.,
                     legend_height = 76.;

    std::string stress_title(const Results &results)
    {
      double largest = 0.;
      for (const BodyResult &body : results.bodies)
        largest = std::max(largest, body.peaks.von_mises.value);
      return "von Mises stress, mean of each cell; at a point at most " + short_number(largest);
    }

    ColourRange stress_range(const DrawnScene &scene)
    {
      ColourRange range;
      for (const DrawnBody &body : scene.bodies)
        range.include(body.von_mises);
      return range;
    }

    void write_cells(std::ostream &out, const DrawnScene &scene, const ColourRange &range,
                     const PageFrame &frame, const Box &box)
    {
      std::size_t n_cells = 0;
      for (const DrawnBody &body : scene.bodies)
        n_cells += body.cells.size();
      const double cell_width = frame.scale * std::sqrt(box.size().prod() / static_cast<double>(n_cells));
      out << "<g stroke=\"#000\" stroke-opacity=\"0.4\" stroke-linejoin=\"round\" stroke-width=\""
          << short_number(std::clamp(.04 * cell_width, .15, .8), 3) << "\">\n";
      for (const DrawnBody &body : scene.bodies) // behind the others
        if (body.is_rigid)
          for (const Polyline &area : body.cells)
            write_path(out, area, frame, true, "fill=\"#bbb\" stroke=\"none\"");
      for (const DrawnBody &body : scene.bodies)
        for (std::size_t i = 0; i < body.von_mises.size(); ++i)
          write_path(out, body.cells[i], frame, true, "fill=\"" + range.colour(body.von_mises[i]) + "\"");
      out << "</g>\n";
    }

    void write_combs(std::ostream &out, const std::vector<Comb> &combs, const PageFrame &frame)
    {
      for (const Comb &comb : combs)
      {
        Polyline area = comb.base;
        area.insert(area.end(), comb.tips.rbegin(), comb.tips.rend());
        write_path(out, area, frame, true, "fill=\"#fff\" fill-opacity=\"0.35\"");
        const std::size_t every = comb.base.size() / 50 + 1;
        for (std::size_t i = 0; i < comb.base.size(); i += every)
          write_path(out, {comb.base[i], comb.tips[i]}, frame, false,
                     "stroke=\"#d7191c\" stroke-width=\"0.7\"");
        write_path(out, comb.tips, frame, false,
                   "fill=\"none\" stroke=\"#d7191c\" stroke-width=\"1.8\" stroke-linejoin=\"round\"");
      }
    }

    void write_pressure_legend(std::ostream &out, const Results &results, const Vector2 &corner)
    {
      double largest = 0.;
      for (const PairResult &pair : results.pairs)
        largest = std::max(largest, pair.max_pressure);
      if (largest == 0.)
        return;
      out << "<path stroke=\"#d7191c\" stroke-width=\"1.8\" d=\"M" << corner.x() << ' '
          << corner.y() + .5 * colour_bar_height << "h40\"/>\n";
      write_text(out, corner + Vector2(50., colour_bar_height - 2.), Anchor::start,
                 "contact pressure, at most " + short_number(largest));
    }

    void write_caption(std::ostream &out, const Results &results, const DrawnScene &scene)
    {
      out << "<g font-size=\"17\" font-weight=\"bold\">\n";
      write_text(out, Vector2(margin, margin + 8.), Anchor::start,
                 std::filesystem::path(results.scene->file).filename().string());
      out << "</g>\n";
      write_text(out, Vector2(margin, margin + 30.), Anchor::start,
                 "deformed: " + deformation_caption(scene));
    }
  } // namespace

  bool fits_a_picture(const Results &results)
  {
    std::size_t n_cells = 0;
    for (const BodyResult &body : results.bodies)
      n_cells += body.body->counts().cells;
    return n_cells <= most_cells;
  }

  std::string picture(const Results &results, const DrawnScene &scene)
  {
    const std::vector<Comb> combs = combs_of(scene);
    const Box box = box_around(scene, combs);

    PageFrame frame;
    frame.scale = std::min((page_width - 2. * margin) / box.size().x(), largest_height / box.size().y());
    const double height = frame.scale * box.size().y();
    frame.origin = Vector2(.5 * (page_width - frame.scale * (box.low.x() + box.high.x())),
                           caption_height + frame.scale * box.high.y());
    const double page_height = caption_height + height + legend_height;
    const double legend_top = caption_height + height + 34.;

    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.precision(8);
    write_svg_head(out, Vector2(page_width, page_height));
    write_caption(out, results, scene);
    const ColourRange range = stress_range(scene);
    write_cells(out, scene, range, frame, box);
    write_combs(out, combs, frame);
    write_colour_bar(out, range, Vector2(margin + 20., legend_top), stress_title(results));
    write_pressure_legend(out, results, Vector2(margin + 20. + colour_bar_width + 60., legend_top));
    out << "</svg>\n";
    return out.str();
  }
} // namespace abut
