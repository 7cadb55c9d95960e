// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/study/mesh_measures.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace abut
{
  Vector2 cell_centre(const Polyline &cell)
  {
    Assert(!cell.empty(), dealii::ExcMessage("a cell has corners"));
    Vector2 sum = Vector2::Zero();
    for (const Vector2 &point : cell)
      sum += point;
    return sum / static_cast<double>(cell.size());
  }

  unsigned int finest_level(const ObservedPass &pass)
  {
    Assert(!pass.levels.empty(), dealii::ExcMessage("a mesh without cells has no finest level"));
    return *std::max_element(pass.levels.begin(), pass.levels.end());
  }

  Refinement refinement(const ObservedPass &pass, const double half_width)
  {
    Assert(half_width >= 0., dealii::ExcMessage("a half-width is not negative"));
    AssertDimension(pass.levels.size(), pass.drawing.cells.size());
    Refinement result;
    if (pass.levels.empty())
      return result;
    result.finest = finest_level(pass);
    double top = -std::numeric_limits<double>::infinity();
    for (const Polyline &cell : pass.drawing.cells)
      for (const Vector2 &point : cell)
        top = std::max(top, point.y());
    double n_finest = 0., area = 0.;
    for (std::size_t i = 0; i < pass.levels.size(); ++i)
    {
      const Vector2 place = cell_centre(pass.drawing.cells[i]);
      const double distance = std::hypot(std::max(0., place.x() - half_width), top - place.y());
      const double share = std::pow(.25, pass.levels[i]); // of an initial cell's area
      result.all += share * distance;
      area += share;
      if (pass.levels[i] == result.finest)
      {
        result.distance += distance;
        ++n_finest;
      }
    }
    result.all /= area;
    result.distance /= n_finest;
    return result;
  }

  std::size_t unknowns_of_uniform_mesh(const ObservedPass &pass, const BodyDescription &body)
  {
    AssertDimension(body.size.size(), 2);
    const unsigned int finest = finest_level(pass);
    const std::size_t nx = std::size_t(body.cells[0]) << finest, ny = std::size_t(body.cells[1]) << finest;
    const std::size_t elements = 2 * (nx + ny);
    const std::size_t boundary =
        pass.boundary_elements == 0 ? 0 : elements * pass.boundary_unknowns / pass.boundary_elements;
    return 2 * (nx + 1) * (ny + 1) + boundary;
  }
} // namespace abut
