// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/reference/contact_pressure.h>
#include <abut/reference/exact_stress.h>
#include <abut/reference/layer.h>
#include <abut/vector2.h>

#include <array>
#include <vector>

namespace abut
{
  /// Two layers between rollers and the way they are pressed together; lengths in one unit.
  struct LayersSlidingData
  {
    std::array<Layer, 2> layers;
    double length;        ///< both layers fill 0 <= x <= length
    double gap_curvature; ///< r0 in the initial gap r0 x^2
    double approach;      ///< Delta: how much the two rigid faces are moved towards each other
  };

  /**
   * Frictionless contact of two elastic layers (plane strain), each on a frictionless rigid face, with
   * rollers at the ends x = 0 and x = length; the initial gap is r0 x^2 and the approach Delta of the faces
   * closes it on [0, a]. Mirror images in the rollers turn every quantity into a cosine series. With
   * lambda_k = k pi/length and p = sum_k p_k cos(lambda_k x), the surface of layer i gives way by
   *
   *   w_i(x) = p_0 H_i(1+nu_i)(1-2nu_i)/(E_i(1-nu_i))
   *
   *          + sum_{k>=1} (2(1-nu_i^2)/E_i) p_k L(lambda_k H_i)/lambda_k cos(lambda_k x),
   *
   *   L(u) = (cosh 2u - 1)/(sinh 2u + 2u),
   *
   * and w_1 + w_2 = Delta - r0 x^2 holds on [0, a] with p(a) = 0, p = 0 beyond. The pressure is expanded in
   * SineBasis, collocated at Chebyshev points; the half-plane part of every series is summed in closed form,
   * what the rigid faces change converges exponentially. (Compliance of a layer: Johnson, Contact Mechanics,
   * 1985, ch. 5.) Coefficients are refined until their tail is below 1e-13 of the largest.
   *
   * Frame of a layer: 0 <= y <= thickness, the rigid face at y = 0, contact at y = thickness. For the layer
   * that lies above the contact mirror y; xx, yy and zz are unchanged, xy changes its sign. Stress in force
   * per area, tension positive; pressure >= 0; forces and energies per unit thickness of the plane and for 0
   * <= x <= length (half of the symmetric contact).
   */
  class LayersSliding
  {
  public:
    /**
     * Solves for the contact: some hundredths of a second, ten seconds for the thinnest layers. Throws
     * UserError for data that make no sense, layers thinner than 1/400 of the length, and an approach whose
     * contact would be narrower than 1e-4 or wider than 0.99 of the length; ComputationError when 256
     * coefficients do not resolve the pressure.
     */
    explicit LayersSliding(const LayersSlidingData &data);

    const LayersSlidingData &data() const { return data_; }
    double half_width() const { return pressure_.half_width(); }
    double force() const { return pressure_.force(); }
    double pressure(double x) const { return pressure_.value(x); }
    double pressure_l2_norm() const { return pressure_.l2_norm(); }

    /// w_i(x) >= 0 where the surface of layer `body` (0 or 1) is pressed in; 0 <= x <= length.
    double displacement(unsigned int body, double x) const;
    /// Strain energy of layer `body`, int_0^length p w_i/2 dx.
    double strain_energy(unsigned int body) const;

    /// At a point (x, y) of the frame of layer `body`; about ten microseconds a point, the same at any depth.
    ExactStress stress(unsigned int body, const Vector2 &point) const;
    std::vector<ExactStress> stress(unsigned int body, const std::vector<Vector2> &points) const;
    /// sqrt(int xx^2 + yy^2 + zz^2 + 2 xy^2) over layer `body`.
    double stress_l2_norm(unsigned int body) const;

  private:
    LayersSlidingData data_;
    ContactPressure pressure_;
    std::array<Eigen::VectorXd, 2> modes_; // p_0 ... p_K with the K the rigid face of that layer is felt by
  };
} // namespace abut
