// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/reference/pressed_layers.h>

namespace abut
{
  /**
   * The contact of LayersContact, relaxed by a penalty theta (length per stress): the layers may overlap, and
   * the pressure is p = max(0, -g)/theta for the gap g = r0 x^2 - Delta + w_1 + w_2. It minimises
   *
   *   (1/2) int p (w_1 + w_2 + theta p) dx - int p (Delta - r0 x^2) dx   over p >= 0,
   *
   * so that theta p + w_1 + w_2 = Delta - r0 x^2 on the contact [0, a], where p(a) = 0 with a finite slope.
   * The minimum is sought among the cubic splines of SplineBasis (Galerkin), at the width at which p(a) = 0.
   * Pieces are halved from 8 on until the minimum changes by less than 1e-11 of itself: 3e-6 of the energy
   * norm for the coarser spline, 16 times less for the finer one, whose error is of the fourth order. The
   * contact law holds on average over the pieces, at single points to some 1e-7 of the approach.
   */
  class PenalisedLayersContact : public PressedLayers
  {
  public:
    /**
     * Solves for the contact: some tenths of a second, seconds for thin layers. Throws UserError as
     * LayersContact does and for a penalty that is not above 0; ComputationError when 128 pieces do not
     * resolve the pressure.
     */
    PenalisedLayersContact(const LayersContactData &data, double penalty);

    /// theta
    double penalty() const { return penalty_; }

  private:
    double penalty_;
  };
} // namespace abut
