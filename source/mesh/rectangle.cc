// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/mesh/shapes.h>

#include <cmath>
#include <sstream>

namespace abut
{
  namespace
  {
    /// n + 1 numbers from 0 to 1, whose differences form a geometric progression with last = grading * first.
    std::vector<double> graded(const unsigned int n, const double grading)
    {
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

    /// The curved top is looked at in this many places a cell.
    constexpr int samples = 16;

    void check_top(const BodyDescription &body, const std::vector<double> &columns)
    {
      for (std::size_t i = 0; i + 1 < columns.size(); ++i)
        for (int k = 0; k <= samples; ++k)
        {
          const double x = body.size[0] * (columns[i] + (columns[i + 1] - columns[i]) * k / samples);
          const double y = (*body.top)(Vector2(x, 0.));
          if (!(y > 0.))
          {
            std::ostringstream message;
            message << "Body " << body.name << "/Top: the height is " << y << " at x = " << x
                    << ", it must be positive along the whole width";
            throw UserError(message.str());
          }
        }
    }
  } // namespace

  RawMesh rectangle(const BodyDescription &body)
  {
    const auto columns = graded(body.cells[0], body.grading[0]);
    const auto rows = graded(body.cells[1], body.grading[1]);
    const bool curved = body.shape == Shape::rectangle_curved_top;
    if (curved)
      check_top(body, columns);

    RawMesh mesh;
    for (const double t : rows)
      for (const double s : columns)
      {
        const double x = body.size[0] * s;
        mesh.vertices.emplace_back(x, t * (curved ? (*body.top)(Vector2(x, 0.)) : body.size[1]));
      }

    const unsigned int nx = body.cells[0], ny = body.cells[1];
    const auto index = [&](unsigned int i, unsigned int j) { return j * (nx + 1) + i; };
    mesh.add_block({{nx, ny}}, index);
    mesh.add_side("left", ny, [&](unsigned int j) { return index(0, j); });
    mesh.add_side("right", ny, [&](unsigned int j) { return index(nx, j); });
    mesh.add_side("bottom", nx, [&](unsigned int i) { return index(i, 0); });
    mesh.add_side("top", nx, [&](unsigned int i) { return index(i, ny); });
    return mesh;
  }
} // namespace abut
