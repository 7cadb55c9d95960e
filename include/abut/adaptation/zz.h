// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/adaptation/indicator.h>

namespace abut
{
  /**
   * Compares with a continuous stress whose value at each node is the mean of those in the cells around it,
   * by area; O. C. Zienkiewicz and J. Z. Zhu, Int. J. Numer. Meth. Engng 24 (1987) 337.
   */
  class ZZIndicator : public Indicator
  {
  public:
    CellErrors estimate(const BodySolution &solution) const override;
  };
} // namespace abut
