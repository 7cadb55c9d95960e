// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/adaptation/indicator.h>

namespace abut
{
  /**
   * Measures how far the tractions of neighbouring cells differ, and those on the boundary from what is known
   * there; for even degrees, where these jumps are of higher order, also how far the cells are out of
   * balance [Kelly1983].
   *
   * With the normal and tangential parts t_n, t_t of a jump across a face,
   *   error^2 of a cell = sum over its faces of c h int (t_n^2/(lambda + 2 mu) + t_t^2/mu)    (energy norm),
   * where h is the extent of the cell away from the face: its area over the length of the face, twice that
   * for triangles. c makes the estimate exact for rectangles and solutions of degree p + 1: c = 1/(8 (2p +
   * 1)) for odd p. A boundary residual is half a jump. For even p, |cell|/(2 p (p + 1) (2p + 1)) times the
   * like of the residual div sigma_F + f is added (twice that for triangles); how much of it stretches and
   * shears is guessed. Near nu = 1/2, where lambda + 2 mu has no bound and errors keep their volume, 4 mu
   * stands for it (from nu = 1/3 on).
   */
  class KellyIndicator : public Indicator
  {
  public:
    CellErrors estimate(const BodySolution &solution) const override;
    std::string name() const override { return "kelly"; }
  };
} // namespace abut
