// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bodies/finite_elements/side_conditions.h>
#include <abut/bodies/prescribed.h>
#include <abut/bodies/side_load.h>

#include <algorithm>
#include <cmath>

namespace abut
{
  SideConditions::SideConditions(const FiniteElementBody &body) : body_(body)
  {
    for (const Condition &condition : body.description().conditions)
      if (!condition.point)
        conditions_[boundary_id(body.space().mesh(), condition.boundary)].push_back(&condition);
  }

  const std::vector<const Condition *> &
  SideConditions::conditions(const dealii::types::boundary_id boundary) const
  {
    static const std::vector<const Condition *> none;
    const auto found = conditions_.find(boundary);
    return found == conditions_.end() ? none : found->second;
  }

  std::vector<Vector2> SideConditions::supported(const dealii::types::boundary_id boundary,
                                                 const Vector2 &normal) const
  {
    constexpr double parallel = 1e-6;
    std::vector<Vector2> all;
    for (const Condition *const condition : conditions(boundary))
      if (is_support(condition->kind))
      {
        const auto directions =
            supported_directions(*condition, body_.description().placement, normal, body_.resultant());
        all.insert(all.end(), directions.begin(), directions.end());
      }
    for (const Vector2 &other : all)
      if (std::abs(all.front().x() * other.y() - all.front().y() * other.x()) > parallel)
        return {Vector2::UnitX(), Vector2::UnitY()};
    return all.empty() ? all : std::vector<Vector2>{all.front()};
  }

  Vector2 SideConditions::traction(const dealii::types::boundary_id boundary, const Vector2 &point,
                                   const Vector2 &normal) const
  {
    Vector2 sum = Vector2::Zero();
    for (const Condition *const condition : conditions(boundary))
      if (!is_support(condition->kind))
        sum += prescribed_traction(*condition, body_.description().placement, point, normal);
    return sum;
  }

  bool SideConditions::has_traction(const dealii::types::boundary_id boundary) const
  {
    const std::vector<const Condition *> &all = conditions(boundary);
    return std::any_of(all.begin(), all.end(),
                       [](const Condition *condition) { return !is_support(condition->kind); });
  }

  bool SideConditions::traction_varies(const dealii::types::boundary_id boundary) const
  {
    const std::vector<const Condition *> &all = conditions(boundary);
    return std::any_of(all.begin(), all.end(), [](const Condition *condition) {
      return !is_support(condition->kind) && varies(*condition);
    });
  }
} // namespace abut
