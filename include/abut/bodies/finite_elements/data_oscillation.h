// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/finite_elements/finite_element_body.h>

namespace abut
{
  /**
   * The part of the conditions and the body force that the cells are too large for, as energy norms of the
   * displacement that it makes, estimated, by active cell:
   *   - a traction less its L2 projection on the polynomials of the space's degree on each edge: a half-plane
   *     under it;
   *   - a prescribed displacement less what the nodes interpolate: a half-plane that follows it;
   *   - the body force less its projection on polynomials a degree below in each cell: a plane with waves of
   * the cell's size. Estimators look at the solution at some points of a cell, and those that compare two
   * solutions with the same data see nothing of it. Of higher order where the data are smooth.
   */
  Eigen::VectorXd data_oscillation(const FiniteElementBody &body, const Sides &sides);
} // namespace abut
