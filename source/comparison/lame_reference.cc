// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/comparison/lame_reference.h>
#include <abut/comparison/scene_checks.h>
#include <abut/scene/reference_entry.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace abut
{
  namespace
  {
    bool is_quarter(const BodyDescription &body)
    {
      return body.shape == "quarter disc" || body.shape == "quarter ring";
    }

    /// The body on one side of the fit.
    const BodyDescription &fitted_body(const SceneChecks &checks, const Scene &scene, const bool inner)
    {
      const ContactDescription &contact = scene.contacts.front();
      const std::string boundary = inner ? "outer" : "inner";
      const bool on_slave = contact.slave.boundary == boundary;
      checks.require(on_slave != (contact.master.boundary == boundary),
                     "the contact must join an `outer` side with an `inner` one");
      const BodyDescription &body =
          scene.bodies[scene.body_index(on_slave ? contact.slave.body : contact.master.body)];
      const bool is_ring = body.shape == "ring" || body.shape == "quarter ring";
      const bool is_disc = body.shape == "disc" || body.shape == "quarter disc";
      checks.require(is_ring || (inner && is_disc),
                     "body " + body.name +
                         " must be a ring or quarter ring, the inner one a disc or quarter disc or these");
      return body;
    }

    /// Radii in the plane: where the body meets the other one, and the free one (0: solid).
    std::array<double, 2> fit_radii(const BodyDescription &body, const bool inner)
    {
      const bool solid = body.size.size() == 1;
      const double small = solid ? 0. : body.size[0], large = body.size.back();
      const auto world = [&](const double radius) { return body.placement.length_to_world(radius); };
      return {{world(inner ? large : small), world(inner ? small : large)}};
    }

    void check_fit_places(const SceneChecks &checks, const BodyDescription &inner,
                          const BodyDescription &outer)
    {
      const double size = outer.placement.length_to_world(outer.size.back());
      const Vector2 origin = Vector2::Zero(), diagonal = Vector2::Ones();
      checks.require(
          (inner.placement.point_to_world(origin) - outer.placement.point_to_world(origin)).norm() <=
              1e-9 * size,
          "bodies " + inner.name + " and " + outer.name + " must have the same centre");
      checks.require(is_quarter(inner) == is_quarter(outer) &&
                         (!is_quarter(inner) || (inner.placement.direction_to_world(diagonal) -
                                                 outer.placement.direction_to_world(diagonal))
                                                        .norm() <= 1e-9),
                     "bodies " + inner.name + " and " + outer.name + " must cover the same angle");
    }

    bool is_roller(const SceneChecks &checks, const BodyDescription &body, const Condition &condition)
    {
      return is_quarter(body) && (condition.boundary == "left" || condition.boundary == "bottom") &&
             condition.kind == ConditionKind::normal_displacement && checks.constant(body, condition) == 0.;
    }

    /// Whether a point is held where the solution has it.
    bool holds_exactly(const Condition &condition, const Vector2 &exact, const double interference)
    {
      std::vector<int> components = {0, 1};
      if (condition.kind != ConditionKind::displacement)
        components = {condition.kind == ConditionKind::displacement_x ? 0 : 1};
      for (std::size_t i = 0; i < components.size(); ++i)
        if (std::abs(condition.expressions[i](*condition.point) - exact[components[i]]) > 1e-9 * interference)
          return false;
      return true;
    }

    ShrinkFitData make_fit(const Scene &scene)
    {
      const SceneChecks checks(scene.reference);
      checks.require_pair(scene);
      const BodyDescription &inner = fitted_body(checks, scene, true),
                            &outer = fitted_body(checks, scene, false);
      check_fit_places(checks, inner, outer);
      const ContactDescription &contact = scene.contacts.front();
      const BodyDescription &slave = scene.bodies[scene.body_index(contact.slave.body)];
      const auto inner_radii = fit_radii(inner, true), outer_radii = fit_radii(outer, false);
      double interference = inner_radii[0] - outer_radii[0];
      if (contact.gap)
      {
        const std::string entry = "Contact " + contact.name + "/Gap";
        checks.require(contact.gap->is_constant(), entry + " must be a constant or that of the geometry");
        checks.require(agree(inner_radii[0], outer_radii[0]),
                       "the radii must be the same where " + entry + " tells the interference");
        interference = -slave.placement.length_to_world((*contact.gap)(Vector2::Zero()));
      }
      std::ostringstream text;
      text << "the interference is " << interference << ", it must be above 0";
      checks.require(interference > 0., text.str());
      const double radius = (&slave == &inner ? inner_radii : outer_radii)[0];
      return {{inner.young_modulus, inner.poisson_ratio, inner_radii[1] * radius / inner_radii[0]},
              {outer.young_modulus, outer.poisson_ratio, outer_radii[1] * radius / outer_radii[0]},
              radius,
              interference};
    }

    void check_fit_conditions(const Scene &scene, const LameReference &solution, const std::size_t index,
                              const std::string &contact_side)
    {
      const SceneChecks checks(scene.reference);
      const BodyDescription &body = scene.bodies[index];
      const double interference = make_fit(scene).interference / body.placement.length_to_world(1.);
      for (const Condition &condition : body.conditions)
      {
        const bool at_point = condition.point && !condition.exact;
        const bool holds =
            condition.boundary != contact_side &&
            (condition.exact || is_roller(checks, body, condition) ||
             (at_point &&
              holds_exactly(condition, solution.displacement(index)(*condition.point), interference)));
        checks.require(holds, "`" + condition.boundary + ": " + to_string(condition.kind) + "` of body " +
                                  body.name +
                                  " is neither a roller (normal displacement: 0) on a cut nor `exact` "
                                  "nor a point held where the solution has it");
      }
      for (const std::string cut : {"left", "bottom"})
        if (is_quarter(body) && find_condition(body, cut, ConditionKind::displacement) == nullptr)
          checks.require_roller(body, cut);
    }
  } // namespace

  LameReference::LameReference(const Scene &scene) : solution_(make_fit(scene))
  {
    const ContactDescription &contact = scene.contacts.front();
    const BodyDescription &slave = scene.bodies[scene.body_index(contact.slave.body)];
    const double radius = fit_radii(slave, contact.slave.boundary == "outer")[0];
    for (const Side &side : {contact.slave, contact.master})
    {
      const std::size_t index = scene.body_index(side.body);
      const bool inner = side.boundary == "outer";
      const BodyDescription &body = scene.bodies[index];
      parts_[index] = {inner ? ShrinkFit::Part::inner : ShrinkFit::Part::outer,
                       body.placement.length_to_world(1.), radius / fit_radii(body, inner)[0]};
    }
    for (const Side &side : {contact.slave, contact.master})
      check_fit_conditions(scene, *this, scene.body_index(side.body), side.boundary);
    const double angle = (is_quarter(slave) ? .5 : 2.) * std::acos(-1.);
    force_ = solution_.pressure() * angle * radius / slave.placement.length_to_world(1.);
  }

  OwnStress LameReference::stress(const std::size_t body) const
  {
    const Part part = parts_.at(body);
    return [this, part](const Vector2 &own_point) -> Stress {
      const Vector2 n = own_point.normalized();
      const PolarStress s = solution_.stress(part.part, part.stretched * part.scale * own_point.norm());
      return {part.stretched * (s.radial * n.x() * n.x() + s.hoop * n.y() * n.y()),
              part.stretched * (s.radial * n.y() * n.y() + s.hoop * n.x() * n.x()),
              part.stretched * (s.radial - s.hoop) * n.x() * n.y(), part.stretched * s.axial};
    };
  }

  std::function<Vector2(const Vector2 &)> LameReference::displacement(const std::size_t body) const
  {
    const Part part = parts_.at(body);
    return [this, part](const Vector2 &own_point) -> Vector2 {
      const double r = part.stretched * part.scale * own_point.norm();
      if (!(r > 0.))
        return Vector2::Zero();
      return solution_.radial_displacement(part.part, r) / part.scale * own_point.normalized();
    };
  }

  std::function<double(const Vector2 &)> LameReference::pressure() const
  {
    return [this](const Vector2 &) { return solution_.pressure(); };
  }

  namespace
  {
    ReferenceEntry lame_entry()
    {
      ReferenceEntry entry{"lame", "a disc or ring shrunk into a ring"};
      entry.make = [](const Scene &scene) -> std::unique_ptr<ExactSolution> {
        return std::make_unique<LameReference>(scene);
      };
      return entry;
    }

    const Registered<ReferenceEntry> registered_lame(lame_entry());
  } // namespace
} // namespace abut
