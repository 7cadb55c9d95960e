// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/elasticity/material.h>
#include <abut/reference/layers_contact.h>
#include <abut/scene/scene.h>

#include <array>

namespace abut
{
  /**
   * LayersContact seen from the bodies of a scene: everything in a body's own frame, where the body is a
   * rectangle whose top or bottom is the contact side.
   */
  class LayersReference
  {
  public:
    /// Throws UserError when the scene is not that of two such layers.
    explicit LayersReference(const Scene &scene);

    Stress stress(std::size_t body, const Vector2 &own_point) const;
    /// At a point of the slave side in its body's own frame.
    double pressure(const Vector2 &own_point) const { return solution_.pressure(own_point.x()); }
    /// Resultant, own lengths.
    double force() const { return solution_.force(); }
    const LayersContact &solution() const { return solution_; }

  private:
    std::array<bool, 2> contact_on_top_;
    std::array<double, 2> thickness_;
    LayersContact solution_;
  };
} // namespace abut
