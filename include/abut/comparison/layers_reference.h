// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/comparison/exact_solution.h>
#include <abut/reference/pressed_layers.h>

#include <array>
#include <memory>

namespace abut
{
  /**
   * LayersContact, or PenalisedLayersContact with the penalty of the scene's pair, seen from the bodies of a
   * scene (`layers sliding`, `layers bonded`): everything in a body's own frame, where the body is a
   * rectangle whose top or bottom is the contact side.
   */
  class LayersReference : public ExactSolution
  {
  public:
    /// Throws UserError when the scene is not that of two such layers.
    LayersReference(const Scene &scene, Layer::Ends ends, Layer::Base base);

    /// In the frames of the layers.
    const PressedLayers &solution() const { return *solution_; }

    OwnStress stress(std::size_t body) const override;
    std::function<double(const Vector2 &)> pressure() const override;
    std::optional<double> force() const override { return solution_->force(); }
    OwnStress response(std::size_t body, const BodyResult &result) const override;

  private:
    /// A field of the layer's frame, contact above, in the body's own frame.
    template <typename Field> OwnStress in_own_frame(std::size_t body, const Field &field) const;

    std::array<bool, 2> contact_on_top_;
    std::array<double, 2> thickness_;
    std::unique_ptr<const PressedLayers> solution_;
  };
} // namespace abut
