// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/adaptation/indicator.h>

namespace abut
{
  /**
   * Compares with polynomials of degree p fitted, around each vertex, to the stress at the superconvergent
   * points of the cells and to the known tractions on the boundary [ZienkiewiczZhu1992]. In a cell the
   * polynomials of its vertices are blended by their linear hat functions.
   */
  class SPRIndicator : public Indicator
  {
  public:
    CellErrors estimate(const BodySolution &solution) const override;
    std::string name() const override { return "spr"; }
  };
} // namespace abut
