// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/mesh/rectangle.h>
#include <abut/scene/shape_entry.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

namespace abut
{
  std::vector<double> graded(const unsigned int n, const double grading)
  {
    Assert(n > 0 && grading > 0., dealii::ExcMessage("a grading of cells is a number above 0"));
    const double ratio = n > 1 ? std::pow(grading, 1. / (n - 1)) : 1.;
    std::vector<double> numbers{0.};
    double step = 1.;
    for (unsigned int i = 0; i < n; ++i, step *= ratio)
      numbers.push_back(numbers.back() + step);
    const double total = numbers.back();
    for (double &number : numbers)
      number /= total;
    return numbers;
  }

  RawMesh rectangle_below(const BodyDescription &body, const std::function<double(double x)> &height)
  {
    const auto columns = graded(body.cells[0], body.grading[0]);
    const auto rows = graded(body.cells[1], body.grading[1]);

    RawMesh mesh;
    for (const double t : rows)
      for (const double s : columns)
      {
        const double x = body.size[0] * s;
        mesh.vertices.emplace_back(x, t * height(x));
      }

    const unsigned int nx = body.cells[0], ny = body.cells[1];
    const auto index = [&](unsigned int i, unsigned int j) { return j * (nx + 1) + i; };
    mesh.add_block({{nx, ny}}, index);
    mesh.is_one_block = true;
    mesh.add_side("left", ny, [&](unsigned int j) { return index(0, j); });
    mesh.add_side("right", ny, [&](unsigned int j) { return index(nx, j); });
    mesh.add_side("bottom", nx, [&](unsigned int i) { return index(i, 0); });
    mesh.add_side("top", nx, [&](unsigned int i) { return index(i, ny); });
    return mesh;
  }

  std::array<unsigned int, 2> coarse_cells_of_rectangle(const std::vector<double> &size)
  {
    constexpr double across = 2., most = 200.;
    const double cell = std::min(size.at(0), size.at(1)) / across;
    const auto along = [&](const double length) {
      return static_cast<unsigned int>(std::lround(std::min(length / cell, most)));
    };
    return {{along(size[0]), along(size[1])}};
  }

  namespace
  {
    ShapeEntry rectangle_entry()
    {
      ShapeEntry entry{"rectangle",
                       "corner at the origin, sides left, right, bottom, top; Cells along x, along y"};
      entry.size = "width, height";
      entry.takes_grading = true;
      entry.coarse_cells = coarse_cells_of_rectangle;
      entry.make = [](const BodyDescription &body) {
        return rectangle_below(body, [&](double) { return body.size[1]; });
      };
      return entry;
    }

    const Registered<ShapeEntry> registered_rectangle(rectangle_entry());
  } // namespace
} // namespace abut
