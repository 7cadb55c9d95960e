// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/report/colour_bar.h>
#include <abut/report/mesh_figure.h>
#include <abut/report/svg.h>

#include <limits>
#include <sstream>

namespace abut
{
  namespace
  {
    // Pixels.
    constexpr double figure_width = 880., figure_margin = 16., panel_caption = 26., scale_room = 70.;

    struct PanelBox
    {
      Vector2 low = Vector2::Constant(std::numeric_limits<double>::infinity());
      Vector2 high = -low;
    };

    PanelBox box_of(const std::vector<MeshPanel> &panels)
    {
      PanelBox box;
      for (const MeshPanel &panel : panels)
        for (const Polyline &cell : panel.body->cells)
          for (const Vector2 &point : cell)
          {
            box.low = box.low.cwiseMin(point);
            box.high = box.high.cwiseMax(point);
          }
      return box;
    }

    void write_panel(std::ostream &out, const MeshPanel &panel, const ColourRange &range,
                     const PageFrame &frame)
    {
      out << "<g fill=\"none\" stroke=\"#000\" stroke-linejoin=\"round\" stroke-width=\""
          << (panel.coloured ? "0.2" : "0.5") << "\">\n";
      for (std::size_t i = 0; i < panel.body->cells.size(); ++i)
        write_path(out, panel.body->cells[i], frame, true,
                   panel.coloured ? "fill=\"" + range.colour(panel.body->von_mises[i]) + "\""
                                  : std::string());
      out << "</g>\n";
    }
  } // namespace

  std::string mesh_figure(const std::vector<MeshPanel> &panels)
  {
    ColourRange range;
    bool coloured = false;
    for (const MeshPanel &panel : panels)
      if (panel.coloured)
      {
        range.include(panel.body->von_mises);
        coloured = true;
      }
    const PanelBox box = box_of(panels);
    PageFrame frame;
    frame.scale = (figure_width - 2. * figure_margin) / (box.high.x() - box.low.x());
    const double mesh_height = frame.scale * (box.high.y() - box.low.y());
    const double panel_height = panel_caption + mesh_height + figure_margin;
    const double height = panel_height * static_cast<double>(panels.size());

    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.precision(6);
    write_svg_head(out, Vector2(figure_width, height + (coloured ? scale_room : 0.)));
    for (std::size_t i = 0; i < panels.size(); ++i)
    {
      const double top = panel_height * static_cast<double>(i);
      write_text(out, Vector2(figure_margin, top + 18.), Anchor::start, panels[i].caption);
      frame.origin = Vector2(figure_margin - frame.scale * box.low.x(),
                             top + panel_caption + frame.scale * box.high.y());
      write_panel(out, panels[i], range, frame);
    }
    if (coloured)
      write_colour_bar(out, range, Vector2(figure_margin + 20., height + 22.),
                       "von Mises stress, mean of each cell");
    out << "</svg>\n";
    return out.str();
  }
} // namespace abut
