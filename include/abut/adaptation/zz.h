// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/adaptation/indicator.h>

namespace abut
{
  /**
   * Compares with a continuous stress whose value at each node is the mean of those in the cells around it,
   * by area [ZienkiewiczZhu1987].
   *
   * For smooth solutions and small cells it finds all of the error for p = 1 and sqrt(5/6) of it for p = 3 on
   * quadrilaterals. For p = 2 the averages do not see the leading part of the error: on quadrilaterals the
   * share that is found tends to 0 with the size of the cells, on triangles it is about 0.4.
   */
  class ZZIndicator : public Indicator
  {
  public:
    CellErrors estimate(const BodySolution &solution) const override;
    std::string name() const override { return "zz"; }
  };
} // namespace abut
