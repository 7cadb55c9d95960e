// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/reference/contact_pressure.h>
#include <abut/reference/layer_response.h>

#include <array>
#include <memory>
#include <vector>

namespace abut
{
  /// Two layers and the way they are pressed together; lengths in one unit.
  struct LayersContactData
  {
    std::array<Layer, 2> layers;
    double length;        ///< both layers fill 0 <= x <= length; not used for infinite ends
    double gap_curvature; ///< r0 in the initial gap r0 x^2
    double approach;      ///< Delta: how much the two rigid faces are moved towards each other
    Layer::Ends ends = Layer::Ends::rollers;
  };

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
   *
   * Frame and signs of a layer: those of LayerResponse. Pressure >= 0; forces and energies per unit thickness
   * of the plane and for 0 <= x <= length (half of the symmetric contact).
   */
  class LayersContact
  {
  public:
    /**
     * Solves for the contact: some hundredths of a second, ten seconds for the thinnest layers. Throws
     * UserError for data that make no sense, layers thinner than 1/400 of the length, and an approach whose
     * contact would be narrower than 1e-4 or wider than 0.99 of the length; ComputationError when 256
     * coefficients do not resolve the pressure.
     */
    explicit LayersContact(const LayersContactData &data);

    /// For infinite ends with the length that replaces infinity.
    const LayersContactData &data() const { return data_; }
    double half_width() const { return pressure_->half_width(); }
    double force() const { return pressure_->force(); }
    double pressure(double x) const { return pressure_->value(x); }
    double pressure_l2_norm() const { return pressure_->l2_norm(); }

    /// Layer `body` (0 or 1) under the contact pressure.
    const LayerResponse &response(unsigned int body) const { return responses_.at(body); }
    /// w_i(x) >= 0 where the surface of layer `body` is pressed in; 0 <= x <= length.
    double displacement(unsigned int body, double x) const { return response(body).displacement(x); }
    /// Strain energy of layer `body`, int_0^length p w_i/2 dx.
    double strain_energy(unsigned int body) const { return response(body).strain_energy(); }
    /// At a point (x, y) of the frame of layer `body`; about ten microseconds a point, the same at any depth.
    ExactStress stress(unsigned int body, const Vector2 &point) const { return response(body).stress(point); }
    std::vector<ExactStress> stress(unsigned int body, const std::vector<Vector2> &points) const
    {
      return response(body).stress(points);
    }
    /// sqrt(int xx^2 + yy^2 + zz^2 + 2 xy^2) over layer `body`.
    double stress_l2_norm(unsigned int body) const { return response(body).stress_l2_norm(); }

  private:
    LayersContactData data_;
    std::shared_ptr<const ContactPressure> pressure_;
    std::array<LayerResponse, 2> responses_;
  };
} // namespace abut
