// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/report/colour_map.h>
#include <abut/report/page/cell_paths.h>
#include <abut/report/page/path_data.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>
#include <vector>

namespace abut
{
  namespace
  {
    constexpr double edge_shade = .6;

    /// Of a point from the line through two.
    double distance_from_line(const UnitPoint &point, const UnitPoint &a, const UnitPoint &b)
    {
      const UnitPoint line = b - a, to = point - a;
      const double length = std::hypot(line.x, line.y);
      if (length == 0.)
        return std::hypot(to.x, to.y);
      return std::abs(static_cast<double>(line.x) * to.y - static_cast<double>(line.y) * to.x) / length;
    }

    /// Marks those points between two that are needed for a line within a unit of all (Douglas and Peucker).
    void mark_needed(const UnitPoints &all, const std::size_t first, const std::size_t last,
                     std::vector<bool> &needed)
    {
      double largest = 1.;
      std::size_t farthest = last;
      for (std::size_t i = first + 1; i < last; ++i)
        if (const double d = distance_from_line(all[i], all[first], all[last % all.size()]); d > largest)
        {
          largest = d;
          farthest = i;
        }
      if (farthest == last)
        return;
      needed[farthest] = true;
      mark_needed(all, first, farthest, needed);
      mark_needed(all, farthest, last, needed);
    }

    /// An outline without the points that it does not need.
    UnitPoints corners_of(const UnitPoints &all)
    {
      std::vector<bool> needed(all.size(), false);
      needed[0] = true;
      mark_needed(all, 0, all.size(), needed);
      UnitPoints corners;
      for (std::size_t i = 0; i < all.size(); ++i)
        if (needed[i])
          corners.push_back(all[i]);
      return corners;
    }

    struct UnitBox
    {
      Vector2 low, high;
      bool is_below(const int size) const { return (high - low).maxCoeff() < size; }
    };

    UnitBox unit_box(const Polyline &outline, const PageFrame &frame)
    {
      UnitBox box{frame(outline.front()), frame(outline.front())};
      for (const Vector2 &point : outline)
      {
        box.low = box.low.cwiseMin(frame(point));
        box.high = box.high.cwiseMax(frame(point));
      }
      return box;
    }

    unsigned int colour_class(const ColourRange &range, const double value)
    {
      const double share = range.high > range.low ? (value - range.low) / (range.high - range.low) : 0.;
      return static_cast<unsigned int>(
          std::clamp(share * n_colour_classes, 0., static_cast<double>(n_colour_classes - 1)));
    }

    /// A colour #rrggbb with its channels times `shade`.
    std::string darker(const std::string &colour, const double shade)
    {
      std::string result = "#";
      for (std::size_t channel = 1; channel < colour.size(); channel += 2)
      {
        const int value = static_cast<int>(shade * std::stoi(colour.substr(channel, 2), nullptr, 16));
        result += "0123456789abcdef"[value / 16];
        result += "0123456789abcdef"[value % 16];
      }
      return result;
    }

    /// A path for each class of colours.
    class ColourPaths
    {
    public:
      void add(const unsigned int colour, const UnitPoints &outline) { paths_[colour].add_closed(outline); }
      /// `shade`: brightness of the edges, against that of the cells. Edges hide the seams of neighbours.
      void write(std::ostream &out, const double shade) const
      {
        for (const auto &[colour, path] : paths_)
        {
          const std::string fill = viridis((colour + .5) / n_colour_classes);
          out << "<path fill=\"" << fill << "\" stroke=\"" << darker(fill, shade) << "\" d=\"" << path.text()
              << "\"/>\n";
        }
      }

    private:
      std::map<unsigned int, PathData> paths_;
    };

    /// Means over the squares of a grid.
    class SquareMeans
    {
    public:
      explicit SquareMeans(const int size) : size_(size) {}

      void add(const UnitBox &box, const double value)
      {
        const Vector2 middle = .5 * (box.low + box.high) / size_;
        const double area = std::max((box.high - box.low).prod(), 1e-12);
        Mean &mean =
            means_[{static_cast<int>(std::floor(middle.y())), static_cast<int>(std::floor(middle.x()))}];
        mean.area += area;
        mean.sum += area * value;
      }
      /// Neighbours in a row that have one colour make one rectangle.
      void paint(const ColourRange &range, ColourPaths &paths) const
      {
        for (auto begin = means_.begin(); begin != means_.end();)
        {
          const auto [row, column] = begin->first;
          const unsigned int colour = colour_class(range, begin->second.value());
          int end = column + 1;
          auto next = std::next(begin);
          while (next != means_.end() && next->first == std::pair(row, end) &&
                 colour_class(range, next->second.value()) == colour)
          {
            ++next;
            ++end;
          }
          const int left = column * size_, right = end * size_, top = row * size_, bottom = top + size_;
          paths.add(colour, {{left, top}, {right, top}, {right, bottom}, {left, bottom}});
          begin = next;
        }
      }

    private:
      struct Mean
      {
        double area = 0., sum = 0.;
        double value() const { return sum / area; }
      };
      int size_;
      std::map<std::pair<int, int>, Mean> means_; ///< by row and column
    };
  } // namespace

  void write_cell_paths(std::ostream &out, const DrawnScene &scene, const ColourRange &range,
                        const PageFrame &frame, const int square)
  {
    for (const DrawnBody &body : scene.bodies)
    {
      ColourPaths cells, squares;
      SquareMeans means(square);
      for (std::size_t i = 0; i < body.von_mises.size(); ++i)
      {
        const UnitBox box = unit_box(body.cells[i], frame);
        const UnitPoints outline = corners_of(unit_points(body.cells[i], frame));
        if (box.is_below(square) || outline.size() < 3)
          means.add(box, body.von_mises[i]);
        else
          cells.add(colour_class(range, body.von_mises[i]), outline);
      }
      means.paint(range, squares);
      if (body.is_rigid)
        for (const Polyline &area : body.cells)
          out << "<path class=\"rigid\" d=\"" << short_path(area, frame, true) << "\"/>\n";
      out << "<g class=\"cells\">\n";
      squares.write(out, 1.);
      cells.write(out, edge_shade);
      out << "</g>\n";
    }
  }

  std::size_t small_cells(const DrawnScene &scene, const PageFrame &frame, const int square)
  {
    std::size_t n = 0;
    for (const DrawnBody &body : scene.bodies)
      for (std::size_t i = 0; i < body.von_mises.size(); ++i)
        n += unit_box(body.cells[i], frame).is_below(square) ? 1 : 0;
    return n;
  }
} // namespace abut
