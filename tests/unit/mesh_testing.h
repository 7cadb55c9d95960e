// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/user_error.h>
#include <abut/mesh/body_mesh.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace abut
{
  inline const double pi = std::acos(-1.);

  inline BodyDescription make_body(const std::string &shape, const std::vector<double> &size,
                                   const std::array<unsigned int, 2> &cells)
  {
    BodyDescription body;
    body.name = "block";
    body.shape = shape;
    body.size = size;
    body.cells = cells;
    return body;
  }

  /// Area of all cells under the mesh's mapping.
  double area(const BodyMesh &mesh, unsigned int degree);

  /// Length of a side under the mesh's mapping.
  double side_length(const BodyMesh &mesh, const std::string &side, unsigned int degree);

  /// The smallest Jacobian on a lattice in each cell, over the cell's straight area.
  double smallest_jacobian(const BodyMesh &mesh, unsigned int degree);

  /// Calls `visit` with the own-frame ends of every edge of a side; fails the test when there is none.
  void for_each_edge(const BodyDescription &body, const BodyMesh &mesh, const std::string &side,
                     const std::function<void(const Vector2 &, const Vector2 &)> &visit);

  /// Every boundary edge must belong to a named side.
  void expect_all_sides_named(const BodyMesh &mesh);

  /// `action` must throw a UserError whose text contains `part`.
  void expect_refused(const std::function<void()> &action, const std::string &part);
} // namespace abut
