// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/trace/trace.h>

namespace abut
{
  /**
   * How little the normal of a side says about the direction of contact: its convex curvature. The other
   * side's normal counts that much (see CommonNormal), so that a flat or concave side gives the direction,
   * whatever presses on it.
   *
   *     W = max(0, kappa) + c + eps / d,   1 / length
   *
   * kappa: turning of the averaged normals per length, averaged by length at vertices, linear between; c: at
   * a convex corner or a free end, whose curvature is concentrated, 1 / r there and falling to zero over the
   * distance r, the length of its segment or of the other side's shortest one; d: the distance along the side
   * from the nearest of these. The last term decides between sides that are both straight. Ends that supports
   * hold along the side, and not across it, are planes of symmetry.
   */
  class NormalWeight
  {
  public:
    /// The side must outlive the object. `longest_reach`: of its corners.
    NormalWeight(const Trace &side, double longest_reach);

    double at(std::size_t segment, double s) const;

  private:
    struct Corner
    {
      double arc_length, reach;
    };

    void measure_curvature();
    void find_corners(double longest_reach);

    const Trace &side_;
    std::vector<std::array<double, 2>> curvatures_; ///< at the ends of segments
    std::vector<Corner> corners_;
  };
} // namespace abut
