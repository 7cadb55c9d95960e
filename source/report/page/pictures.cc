// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/report/comb.h>
#include <abut/report/page/cell_paths.h>
#include <abut/report/page/path_data.h>
#include <abut/report/page/pictures.h>
#include <abut/report/page/stress_bar.h>

#include <algorithm>
#include <locale>
#include <numeric>
#include <sstream>

namespace abut
{
  namespace
  {
    // The pictures' own unit is a quarter of a pixel.
    constexpr int units_a_pixel = 4;
    constexpr double picture_width = 3840., largest_picture_height = 2560.;
    constexpr std::size_t most_picture_bytes = 2200000, fewest_pictures = 4;
    constexpr int fine_square = 2, coarsest_square = 32; // pixels

    /// What all pictures have in common; the frame of a drawing follows from its own box, for rigid motions
    /// are exaggerated too.
    struct PictureScale
    {
      std::vector<Box> boxes; ///< of the drawings
      StressRange range;
      double units = 1.; ///< of the picture, by unit of length
      Vector2 size = Vector2::Zero();

      PageFrame frame(const std::size_t drawing) const
      {
        const Vector2 middle = .5 * (boxes[drawing].low + boxes[drawing].high);
        return {units, Vector2(.5 * size.x() - units * middle.x(), .5 * size.y() + units * middle.y())};
      }
    };

    PictureScale scale_of(const std::vector<PassDrawing> &drawings)
    {
      PictureScale scale;
      scale.range = stress_range_of(drawings);
      Vector2 extent = Vector2::Zero();
      for (const PassDrawing &drawing : drawings)
      {
        scale.boxes.push_back(box_around(drawing.scene, combs_of(drawing.scene)));
        extent = extent.cwiseMax(scale.boxes.back().size());
      }
      const Vector2 margins = Vector2::Constant(4. * units_a_pixel);
      scale.units =
          (Vector2(picture_width, largest_picture_height) - margins).cwiseQuotient(extent).minCoeff();
      scale.size = (scale.units * extent + margins).array().ceil();
      return scale;
    }

    void write_page_combs(std::ostream &out, const DrawnScene &scene, const PageFrame &frame)
    {
      for (const Comb &comb : combs_of(scene))
      {
        Polyline area = comb.base;
        area.insert(area.end(), comb.tips.rbegin(), comb.tips.rend());
        out << "<path class=\"comb\" d=\"" << short_path(area, frame, true)
            << "\"/>\n<path class=\"tips\" d=\"" << short_path(comb.tips, frame, false) << "\"/>\n";
      }
    }

    std::string picture_element(const PassDrawing &drawing, const PictureScale &scale, const PageFrame &frame,
                                const int square)
    {
      std::ostringstream out;
      out.imbue(std::locale::classic());
      out << "<svg class=\"bodies\" role=\"img\" aria-label=\"Deformed bodies of pass " << drawing.pass
          << ", coloured by von Mises stress\" viewBox=\"0 0 " << scale.size.x() << ' ' << scale.size.y()
          << "\">\n";
      write_cell_paths(out, drawing.scene, scale.range.colours, frame, square * units_a_pixel);
      write_page_combs(out, drawing.scene, frame);
      out << "</svg>\n";
      return out.str();
    }

    struct Pictures
    {
      std::vector<std::size_t> drawings; ///< those that are shown
      int square = 1;                    ///< pixels; what is smaller is drawn together
      std::vector<std::string> elements;
    };

    /// Whether there is room for all of them.
    bool draw(const std::vector<PassDrawing> &drawings, const PictureScale &scale, Pictures &pictures)
    {
      std::size_t bytes = 0;
      pictures.elements.clear();
      for (const std::size_t i : pictures.drawings)
      {
        pictures.elements.push_back(picture_element(drawings[i], scale, scale.frame(i), pictures.square));
        bytes += pictures.elements.back().size();
      }
      return bytes <= most_picture_bytes;
    }

    /// Every second one, the last one among them.
    std::vector<std::size_t> every_second(const std::vector<std::size_t> &drawings)
    {
      std::vector<std::size_t> kept;
      for (std::size_t i = 1 - drawings.size() % 2; i < drawings.size(); i += 2)
        kept.push_back(drawings[i]);
      return kept;
    }

    /// As fine as the room for them allows: first less of what can hardly be seen, then fewer passes, then
    /// coarser.
    Pictures draw_pictures(const std::vector<PassDrawing> &drawings, const PictureScale &scale)
    {
      Pictures pictures;
      pictures.drawings.resize(drawings.size());
      std::iota(pictures.drawings.begin(), pictures.drawings.end(), std::size_t(0));
      while (!draw(drawings, scale, pictures) && pictures.square < coarsest_square)
        if (pictures.square < fine_square || pictures.drawings.size() <= fewest_pictures)
          pictures.square *= 2;
        else
          pictures.drawings = every_second(pictures.drawings);
      return pictures;
    }

    std::string pass_caption(const PassRecord &record, const DrawnScene &scene)
    {
      return "Pass " + std::to_string(record.pass) + ": " + std::to_string(record.counts.cells) + " cells, " +
             std::to_string(record.counts.dofs) + " unknowns. Deformed: " + deformation_caption(scene) + ".";
    }

    void write_slider(std::ostream &out)
    {
      out << "<div id=\"chooser\" class=\"screen\" hidden=\"hidden\">\n"
             "<button type=\"button\" id=\"back\" aria-label=\"Picture before\">◀</button>\n"
             "<label for=\"slider\">Pass</label>\n"
             "<input type=\"range\" id=\"slider\" min=\"0\" step=\"1\"/>\n"
             "<output id=\"shown\" for=\"slider\"></output>\n"
             "<button type=\"button\" id=\"on\" aria-label=\"Next picture\">▶</button>\n</div>\n";
    }

    void write_what_is_missing(std::ostream &out, const Results &results,
                               const std::vector<PassDrawing> &drawings, const PictureScale &scale,
                               const Pictures &pictures)
    {
      std::size_t together = 0;
      for (const std::size_t i : pictures.drawings)
        together += small_cells(drawings[i].scene, scale.frame(i), pictures.square * units_a_pixel);
      const std::size_t missing = results.passes.size() - pictures.drawings.size();
      if (missing > 0)
        out << "<p class=\"note\" id=\"passes-left-out\">" << missing << " of " << results.passes.size()
            << " passes are not drawn.</p>\n";
      if (together > 0)
        out << "<p class=\"note\" id=\"cells-left-out\">" << together
            << " cells, in all pictures together, are smaller than " << pictures.square
            << (pictures.square == 1 ? " pixel" : " pixels")
            << " and drawn as squares of that size with the mean stress of those that they stand for.</p>\n";
    }
  } // namespace

  void write_pictures(std::ostream &out, const Results &results, const std::vector<PassDrawing> &drawings)
  {
    out << "<section aria-labelledby=\"bodies-title\">\n<h2 id=\"bodies-title\">Deformed bodies</h2>\n";
    if (drawings.empty())
    {
      out << "<p class=\"note\">Not drawn: too many cells for a picture. solution.pvd has all fields.</p>\n"
             "</section>\n";
      return;
    }
    const PictureScale scale = scale_of(drawings);
    const Pictures pictures = draw_pictures(drawings, scale);
    write_slider(out);
    out << "<div id=\"passes\">\n";
    for (std::size_t i = 0; i < pictures.elements.size(); ++i)
    {
      const PassDrawing &drawing = drawings[pictures.drawings[i]];
      out << "<details class=\"pass\" data-pass=\"" << drawing.pass << '"'
          << (i + 1 == pictures.elements.size() ? " open=\"open\"" : "") << ">\n<summary>Pass "
          << drawing.pass << "</summary>\n<figure>\n"
          << pictures.elements[i] << "<figcaption>"
          << pass_caption(results.passes[drawing.pass], drawing.scene)
          << "</figcaption>\n</figure>\n</details>\n";
    }
    out << "</div>\n";
    write_stress_bar(out, scale.range);
    if (!results.pairs.empty())
      out << "<p class=\"note\"><span class=\"comb-key\"></span> contact pressure, drawn along the normal of "
             "the "
             "side; its largest value in each picture is a tenth of the scene's size.</p>\n";
    write_what_is_missing(out, results, drawings, scale, pictures);
    out << "</section>\n";
  }
} // namespace abut
