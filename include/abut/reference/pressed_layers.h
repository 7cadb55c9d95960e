// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

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

  /// The pressure between two layers, zero beyond its half-width.
  struct PressureBetween
  {
    LayersContactData data; ///< of finite length
    double half_width;
    std::shared_ptr<const PeriodicPressure> pressure;
  };

  /**
   * Two elastic layers under the pressure that acts between them. Frame and signs of a layer: those of
   * LayerResponse. Pressure >= 0; forces and energies per unit thickness of the plane and for 0 <= x <=
   * length (half of the symmetric contact).
   */
  class PressedLayers
  {
  public:
    virtual ~PressedLayers() = default;

    /// For infinite ends with the length that replaces infinity.
    const LayersContactData &data() const { return data_; }
    double half_width() const { return half_width_; }
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

  protected:
    explicit PressedLayers(const PressureBetween &solution);

  private:
    LayersContactData data_;
    double half_width_;
    std::shared_ptr<const PeriodicPressure> pressure_;
    std::array<LayerResponse, 2> responses_;
  };
} // namespace abut
