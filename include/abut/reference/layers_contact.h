// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/reference/pressed_layers.h>

namespace abut
{
  /**
   * Frictionless contact of two elastic layers (plane strain), each on a rigid face (sliding or bonded); the
   * initial gap is r0 x^2 and the approach Delta of the faces closes it on [0, a]. Rollers at the ends x = 0
   * and x = length mirror the layers, which turns every quantity into a cosine series. With lambda_k = k
   * pi/length and p = sum_k p_k cos(lambda_k x), the surface of layer i gives way by
   *
   *   w_i(x) = C_i p_0 + sum_{k>=1} (2(1-nu_i^2)/E_i) p_k L_i(lambda_k H_i)/lambda_k cos(lambda_k x)
   *
   * with C and L of Layer, and w_1 + w_2 = Delta - r0 x^2 holds on [0, a] with p(a) = 0, p = 0 beyond. The
   * pressure is expanded in SineBasis, collocated at Chebyshev points; the half-plane part of every series is
   * summed in closed form, what the rigid faces change converges exponentially. Coefficients are refined
   * until their tail is below 1e-13 of the largest.
   *
   * Infinite layers are computed with a length of 25 thicknesses and more beyond the contact: images act by
   * exp(-0.7 x/H) at the distance x or less, below 1e-14 in the contact. What is asked for at x has images
   * at the distance 2 length - x.
   */
  class LayersContact : public PressedLayers
  {
  public:
    /**
     * Solves for the contact: some hundredths of a second, ten seconds for the thinnest layers. Throws
     * UserError for data that make no sense, layers thinner than 1/400 of the length, and an approach whose
     * contact would be narrower than 1e-4 or wider than 0.99 of the length; ComputationError when 256
     * coefficients do not resolve the pressure.
     */
    explicit LayersContact(const LayersContactData &data);
  };
} // namespace abut
