// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bem/galerkin_rule.h>
#include <abut/bem/pair_integrals.h>

namespace abut
{
  /// Integrals of elements close to each other, down to sharing a vertex: see GalerkinRule.
  class NearPairs
  {
  public:
    NearPairs(const GalerkinRule &rule, unsigned int degree);

    /**
     * x on `outer`, by points; y on `inner`, in closed form. Exact to the rule's accuracy if `inner` is not
     * the shorter one. `flat`: both lie on one line.
     */
    PairIntegrals integrate(const BoundaryElement &outer, const BoundaryElement &inner, bool flat) const;

  private:
    double piece_length_;
    unsigned int degree_;
    Eigen::VectorXd plain_points_, plain_weights_;   // on 0 < t < 1
    Eigen::VectorXd graded_points_, graded_weights_; // dense at t = 0
  };
} // namespace abut
