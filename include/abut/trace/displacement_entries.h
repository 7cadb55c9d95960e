// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/trace/trace.h>

#include <Eigen/SparseCore>

namespace abut
{
  /// Appends the entries of one row of a matrix that acts on trace displacements: factor times the
  /// displacement along a direction at a point of a segment, with the values of its shape functions there.
  void add_displacement(Eigen::Index row, double factor, const Segment &segment,
                        const Eigen::VectorXd &values, const Vector2 &direction,
                        std::vector<Eigen::Triplet<double>> &entries);
} // namespace abut
