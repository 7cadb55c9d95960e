// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/bodies/prescribed.h>

#include <algorithm>
#include <sstream>

namespace abut
{
  namespace
  {
    /// One direction, own value and share in delta, at a place whose outward normal is given.
    struct DirectedValue
    {
      Vector2 direction;
      double value;
      double per_unit;
    };

    std::vector<DirectedValue> directed_values(const Condition &condition, const Placement &placement,
                                               const Vector2 &point, const Vector2 &normal,
                                               const std::optional<Resultant> &resultant)
    {
      const std::vector<Vector2> directions = supported_directions(condition, placement, normal, resultant);
      if (condition.kind == ConditionKind::resultant)
        return {{directions.front(), 0., 1.}};
      const Vector2 own = placement.point_to_own(point);
      std::vector<DirectedValue> values;
      for (std::size_t i = 0; i < directions.size(); ++i)
        values.push_back({directions[i], placement.length_to_world(condition.expressions[i](own)), 0.});
      return values;
    }

    /// The node at a given place, which must be one within 1e-6 of the body's size.
    std::size_t node_at(const BodyDescription &body, const Condition &condition, const Nodes &nodes)
    {
      const Vector2 place = body.placement.point_to_world(*condition.point);
      std::size_t nearest = 0;
      double size = 0.;
      for (std::size_t i = 0; i < nodes.places.size(); ++i)
      {
        size = std::max(size, (nodes.places[i] - nodes.places[0]).norm());
        if ((nodes.places[i] - place).norm() < (nodes.places[nearest] - place).norm())
          nearest = i;
      }
      if ((nodes.places[nearest] - place).norm() > 1e-6 * size)
      {
        const Vector2 own = body.placement.point_to_own(nodes.places[nearest]);
        std::ostringstream text;
        text << "Body " << body.name << "/Conditions: there is no node of the mesh at the point "
             << condition.boundary << "; the nearest one is at (" << own.x() << ", " << own.y() << ")";
        throw UserError(text.str());
      }
      return nearest;
    }

    /// The common outward normal of a straight side.
    Vector2 straight_normal(const BodyDescription &body, const std::string &boundary, const Trace &side)
    {
      for (const Vector2 &normal : side.node_normals())
        if ((normal - side.node_normals().front()).norm() > 1e-8)
          throw UserError("Body " + body.name +
                          "/Conditions: 'resultant' with one expression needs a straight side, but '" +
                          boundary + "' is curved; give the force as a vector of two expressions");
      return side.node_normals().front();
    }
  } // namespace

  std::vector<Vector2> supported_directions(const Condition &condition, const Placement &placement,
                                            const Vector2 &normal, const std::optional<Resultant> &resultant)
  {
    const Vector2 x = placement.direction_to_world(Vector2::UnitX());
    const Vector2 y = placement.direction_to_world(Vector2::UnitY());
    switch (condition.kind)
    {
    case ConditionKind::displacement:
      return {x, y};
    case ConditionKind::displacement_x:
      return {x};
    case ConditionKind::displacement_y:
      return {y};
    case ConditionKind::normal_displacement:
      return {normal};
    case ConditionKind::tangential_displacement:
      return {Vector2(-normal.y(), normal.x())};
    case ConditionKind::resultant:
      return {resultant->direction};
    case ConditionKind::traction:
    case ConditionKind::pressure:
      break;
    }
    return {};
  }

  Vector2 prescribed_displacement(const Condition &condition, const Placement &placement,
                                  const Vector2 &point, const Vector2 &normal)
  {
    Vector2 sum = Vector2::Zero();
    for (const DirectedValue &v : directed_values(condition, placement, point, normal, {}))
      sum += v.value * v.direction;
    return sum;
  }

  std::optional<Resultant> find_resultant(const BodyDescription &body, const Sides &sides)
  {
    for (const Condition &condition : body.conditions)
    {
      if (condition.kind != ConditionKind::resultant)
        continue;
      const Vector2 origin = Vector2::Zero();
      if (condition.expressions.size() == 1)
        return Resultant{condition.boundary,
                         straight_normal(body, condition.boundary, sides.at(condition.boundary)),
                         condition.expressions[0](origin)};
      const Vector2 force = body.placement.direction_to_world(
          Vector2(condition.expressions[0](origin), condition.expressions[1](origin)));
      if (force.norm() == 0.)
        throw UserError("Body " + body.name + "/Conditions: the resultant on '" + condition.boundary +
                        "' is the zero vector, which has no direction; leave the side free or give one "
                        "expression (the force along the normal)");
      return Resultant{condition.boundary, force.normalized(), force.norm()};
    }
    return {};
  }

  std::vector<PrescribedComponent> prescribed_components(const BodyDescription &body, const Sides &sides,
                                                         const std::function<Nodes()> &nodes)
  {
    const std::optional<Resultant> resultant = find_resultant(body, sides);
    std::optional<Nodes> at_points;
    std::vector<PrescribedComponent> components;
    for (const Condition &condition : body.conditions)
    {
      const auto add = [&](const std::array<unsigned int, 2> &dofs, const Vector2 &place,
                           const Vector2 &normal) {
        for (const DirectedValue &v : directed_values(condition, body.placement, place, normal, resultant))
          components.push_back({dofs, place, v.direction, v.value, v.per_unit, condition.boundary});
      };
      if (condition.point)
      {
        if (!at_points)
          at_points = nodes();
        const std::size_t node = node_at(body, condition, *at_points);
        add(at_points->dofs[node], at_points->places[node], Vector2::Zero());
      }
      else
      {
        const Trace &side = sides.at(condition.boundary);
        for (std::size_t i = 0; i < side.n_nodes(); ++i)
          for (const Vector2 &normal : side.normals_at(i))
            add(side.node_dofs()[i], side.node_points()[i], normal);
      }
    }
    return components;
  }
} // namespace abut
