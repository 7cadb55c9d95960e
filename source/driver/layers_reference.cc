// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/driver/layers_reference.h>
#include <abut/user_error.h>

#include <algorithm>
#include <cmath>

namespace abut
{
  namespace
  {
    void require(const bool holds, const std::string &what)
    {
      if (!holds)
        throw UserError("Reference/Exact solution = layers sliding does not belong to this scene: " + what);
    }

    bool agree(const double a, const double b)
    {
      return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b));
    }

    const Condition *find(const BodyDescription &body, const std::string &boundary, const ConditionKind kind)
    {
      for (const Condition &condition : body.conditions)
        if (condition.boundary == boundary && condition.kind == kind)
          return &condition;
      return nullptr;
    }

    /// The inward displacement of a face, one number all along it.
    double face_approach(const BodyDescription &body, const std::string &face)
    {
      double inward = face == "top" ? -1. : 1.;
      const Condition *condition = find(body, face, ConditionKind::displacement_y);
      if (condition == nullptr)
      {
        condition = find(body, face, ConditionKind::normal_displacement);
        inward = -1.;
      }
      require(condition != nullptr, "the face " + body.name + ":" + face +
                                        " needs the condition 'displacement y' or 'normal displacement'");
      const Expression &value = condition->expressions.front();
      require(value.is_constant(), "the displacement of " + body.name + ":" + face + " must be a constant");
      return inward * value(Vector2::Zero());
    }

    void check_body(const BodyDescription &body, const std::string &contact_side)
    {
      require(body.shape == Shape::rectangle && (contact_side == "top" || contact_side == "bottom"),
              "body " + body.name + " must be a rectangle with contact on its top or bottom");
      require(body.body_force.empty(), "body " + body.name + " has a body force");
      for (const std::string side : {"left", "right"})
      {
        const Condition *const roller = find(body, side, ConditionKind::normal_displacement);
        require(roller != nullptr && roller->expressions.front().is_constant() &&
                    roller->expressions.front()(Vector2::Zero()) == 0.,
                body.name + ":" + side + " needs a roller (normal displacement: 0)");
      }
      require(body.conditions.size() == 3, "body " + body.name + " has further conditions");
    }

    /// The contact side of a body from its end x = 0 to the other one, in the plane.
    std::array<Vector2, 2> contact_line(const Scene &scene, const Side &side)
    {
      const BodyDescription &body = scene.bodies[scene.body_index(side.body)];
      const double y = side.boundary == "top" ? body.size[1] : 0.;
      return {{body.placement.point_to_world(Vector2(0., y)),
               body.placement.point_to_world(Vector2(body.size[0], y))}};
    }

    void check_places(const Scene &scene, const ContactDescription &contact)
    {
      const auto slave = contact_line(scene, contact.slave), master = contact_line(scene, contact.master);
      const double distance = std::max((slave[0] - master[0]).norm(), (slave[1] - master[1]).norm());
      require(distance <= 1e-9 * (slave[1] - slave[0]).norm(),
              "the two contact sides must lie on one another, x = 0 on x = 0");
    }

    LayersContactData make_data(const Scene &scene)
    {
      require(scene.bodies.size() == 2 && scene.contacts.size() == 1, "it needs two bodies and one contact");
      const ContactDescription &contact = scene.contacts.front();
      LayersContactData data{};
      double approach = 0.;
      for (const Side &side : {contact.slave, contact.master})
      {
        const std::size_t index = scene.body_index(side.body);
        const BodyDescription &body = scene.bodies[index];
        check_body(body, side.boundary);
        data.layers[index] = {body.young_modulus, body.poisson_ratio, body.size[1]};
        approach += face_approach(body, side.boundary == "top" ? "bottom" : "top");
      }
      data.length = scene.bodies[0].size[0];
      require(agree(data.length, scene.bodies[1].size[0]), "the two bodies must have the same width");
      check_places(scene, contact);
      data.gap_curvature = scene.reference.gap_curvature;
      data.approach = scene.reference.approach;
      require(agree(approach, data.approach),
              "the faces approach by " + std::to_string(approach) +
                  ", not by Reference/Approach = " + std::to_string(data.approach));
      require(contact.gap.has_value(), "Contact " + contact.name + "/Gap must be an expression");
      const double y =
          contact.slave.boundary == "top" ? scene.bodies[scene.body_index(contact.slave.body)].size[1] : 0.;
      for (const double share : {0., .13, .5, .77, 1.})
      {
        const double x = share * data.length;
        require(std::abs((*contact.gap)(Vector2(x, y)) - data.gap_curvature * x * x) <= 1e-9 * data.approach,
                "Contact " + contact.name + "/Gap differs from Reference/Gap curvature x^2");
      }
      return data;
    }
  } // namespace

  LayersReference::LayersReference(const Scene &scene) : solution_(make_data(scene))
  {
    const ContactDescription &contact = scene.contacts.front();
    for (const Side &side : {contact.slave, contact.master})
    {
      const std::size_t index = scene.body_index(side.body);
      contact_on_top_[index] = side.boundary == "top";
      thickness_[index] = scene.bodies[index].size[1];
    }
  }

  Stress LayersReference::stress(const std::size_t body, const Vector2 &own_point) const
  {
    const bool upright = contact_on_top_[body];
    const Vector2 point(own_point.x(), upright ? own_point.y() : thickness_[body] - own_point.y());
    const ExactStress s = solution_.stress(static_cast<unsigned int>(body), point);
    return {s.xx, s.yy, upright ? s.xy : -s.xy, s.zz};
  }
} // namespace abut
