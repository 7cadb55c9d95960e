// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/finite_elements/finite_element_body.h>

#include <map>
#include <vector>

namespace abut
{
  /// What the scene prescribes on the sides of a body (conditions at single points aside).
  class SideConditions
  {
  public:
    /// The body must outlive the object.
    explicit SideConditions(const FiniteElementBody &body);

    /// Independent unit directions along which supports prescribe the displacement where the outward unit
    /// normal is n: none, one, or the two axes.
    std::vector<Vector2> supported(dealii::types::boundary_id boundary, const Vector2 &normal) const;

    /// The prescribed traction at a point: force per area, world frame; zero on free sides.
    Vector2 traction(dealii::types::boundary_id boundary, const Vector2 &point, const Vector2 &normal) const;
    /// Whether one is prescribed.
    bool has_traction(dealii::types::boundary_id boundary) const;
    /// Whether that differs from place to place, but for the normal of a pressure.
    bool traction_varies(dealii::types::boundary_id boundary) const;

  private:
    const std::vector<const Condition *> &conditions(dealii::types::boundary_id boundary) const;

    const FiniteElementBody &body_;
    std::map<dealii::types::boundary_id, std::vector<const Condition *>> conditions_;
  };
} // namespace abut
