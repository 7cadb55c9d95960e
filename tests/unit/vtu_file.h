// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/vector2.h>

#include <map>
#include <string>
#include <vector>

namespace abut::testing
{
  /// A field of a VTU file; vectors have three components.
  struct VtuField
  {
    std::size_t n_components = 1;
    std::vector<double> values; ///< as many for each point or cell, one after the other

    double operator()(const std::size_t index, const std::size_t component = 0) const
    {
      return values.at(n_components * index + component);
    }
  };

  /// A VTU file: base 64, zlib, one piece. Fails the test where it is not what its header says.
  struct VtuFile
  {
    explicit VtuFile(const std::string &text);

    /// A field of cells; deal.II writes it as one of points, which no two cells share. Fails the test where a
    /// cell's points differ.
    std::vector<double> in_cells(const std::string &name) const;
    /// The mean of the cell's points.
    Vector2 middle(std::size_t cell) const;
    /// Of the polygon through the cell's corners, positive counter-clockwise.
    double area(std::size_t cell) const;

    std::vector<Vector2> points;
    std::vector<std::vector<std::size_t>> cells; ///< points; corners first
    std::vector<int> types;                      ///< VTK's: 9 quadrilateral, 5 and 22 triangles
    std::map<std::string, VtuField> fields;      ///< of points
  };
} // namespace abut::testing
