// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/vector2.h>
#include <abut/reference/exact_stress.h>
#include <abut/reference/layer.h>
#include <abut/reference/periodic_pressure.h>

#include <memory>
#include <vector>

namespace abut
{
  /**
   * What a given pressure does to one elastic layer in plane strain, 0 <= x <= l of the pressure, 0 <= y <=
   * thickness: a frictionless pressure on y = thickness, a rigid face (sliding or bonded) at y = 0, mirror
   * images in x = 0 and x = l. The half-plane part of every cosine series is summed in closed form, what the
   * rigid face changes converges exponentially; the mean pressure acts as Layer::Ends says.
   *
   * For a layer that lies above the pressed face mirror y; xx, yy and zz are unchanged, xy changes its sign.
   * Stress in force per area, tension positive; energies per unit thickness of the plane, for 0 <= x <= l.
   */
  class LayerResponse
  {
  public:
    /// Throws UserError when the data of the layer make no sense.
    LayerResponse(const Layer &layer, std::shared_ptr<const PeriodicPressure> pressure,
                  Layer::Ends ends = Layer::Ends::rollers);

    const Layer &layer() const { return layer_; }
    const PeriodicPressure &pressure() const { return *pressure_; }

    /// Depth w(x) > 0 by which the surface is pressed in; 0 <= x <= l.
    double displacement(double x) const;
    /// int_0^l p w/2 dx
    double strain_energy() const;
    /// At a point 0 <= y <= thickness; cost and accuracy are the same at any depth. Not finite only where the
    /// pressure is not.
    ExactStress stress(const Vector2 &point) const;
    std::vector<ExactStress> stress(const std::vector<Vector2> &points) const;
    /// sqrt(int xx^2 + yy^2 + zz^2 + 2 xy^2) over the layer.
    double stress_l2_norm() const;

  private:
    ExactStress face_stress(double x, double height) const;

    Layer layer_;
    std::shared_ptr<const PeriodicPressure> pressure_;
    Layer::Ends ends_;
    Eigen::VectorXd modes_;         // p_0 ... p_K with the K the rigid face is felt by
    std::vector<AiryWave> changes_; // p_k times the change of wave k = 1 ... K
  };
} // namespace abut
