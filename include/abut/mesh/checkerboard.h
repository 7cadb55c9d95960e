// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/grid/tria.h>

#include <Eigen/Core>

namespace abut
{
  /**
   * The part of a number per active cell that alternates from cell to cell like a checkerboard. Around a
   * vertex where four quadrilaterals meet, it is a quarter of the alternating sum; in a cell, the mean over
   * such vertices of its own. All of a checkerboard, also in corners; O(h^2) of smooth values, O(h^4) away
   * from the boundary. Zero in cells without such a vertex.
   */
  Eigen::VectorXd checkerboard(const dealii::Triangulation<2> &triangulation, const Eigen::VectorXd &values);
} // namespace abut
