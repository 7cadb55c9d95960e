// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

#include <vector>

namespace abut
{
  /// Elements of a regular mesh are as long as each other and whole lengths apart: sizes that are compared to
  /// choose a rule are taken by this factor, so that rounding does not choose it.
  inline constexpr double beside_ties = 1. - 1e-9;

  /**
   * How the double integrals of a pair of elements are formed. Near pairs: over the larger element in closed
   * form, over the smaller one (the outer one) by Gauss points on pieces of it. Those integrals over the
   * larger element are analytic away from its two ends, so a piece may be as long as `piece_length` times its
   * distance to either end; halving stops at 2^-40 of the element. A piece that starts at a shared vertex
   * takes Gauss points in v, at the distance v^grading from the vertex, and is half as long. Far pairs: Gauss
   * points on both.
   */
  struct GalerkinRule
  {
    /// Points on an element whose partner lies at least `distance` of its own lengths away.
    struct FarPoints
    {
      double distance;
      unsigned int n_points;
    };

    /// Relative errors below 1e-13 of a pair's largest integral, for every degree.
    static GalerkinRule precise();
    /// Errors up to 1e-3, mostly below 1e-4, in a third to a half of the time: for an error estimator.
    static GalerkinRule estimating();

    unsigned int touching_points;
    unsigned int grading;
    unsigned int near_points;
    double piece_length;
    std::vector<FarPoints> far; ///< by growing distance; nearer than the first one is near

    /// For polynomials above degree 1 one more point per two degrees, at any distance.
    static unsigned int points(const unsigned int n_points, const unsigned int degree)
    {
      return n_points + degree / 2;
    }
  };

  /// Gauss points on -1 < eta < 1 and w_q P_n(eta_q), a row for every point, a column for every degree.
  struct LegendreRule
  {
    LegendreRule(unsigned int n_points, unsigned int degree);

    Eigen::ArrayXd points;
    Eigen::MatrixXd weighted;
  };
} // namespace abut
