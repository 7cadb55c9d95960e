// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/comparison/hertz_reference.h>
#include <abut/comparison/scene_checks.h>
#include <abut/scene/reference_entry.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace abut
{
  namespace
  {
    /// The side of a body around the middle of the contact; own frame but for the size.
    struct HertzFace
    {
      const BodyDescription &body;
      double size; ///< of the body beside and behind the contact, in the plane
      bool is_half;
      Vector2 middle, outward;
      std::function<double(double x)> height; ///< against `outward`, at the own coordinate x

      double scale() const { return body.placement.length_to_world(1.); }
      /// How far the side falls back, in the plane, at a distance from the middle.
      double drop(const double distance) const
      {
        return scale() * (height(middle.x()) - height(middle.x() + distance / scale()));
      }
    };

    bool is_rectangle(const BodyDescription &body)
    {
      return body.shape == "rectangle" || body.shape == "rectangle with curved top";
    }

    HertzFace hertz_rectangle(const BodyDescription &body, const std::string &boundary)
    {
      const double width = body.size[0], tall = body.size[1];
      const bool is_half = find_condition(body, "left", ConditionKind::normal_displacement) != nullptr;
      const double middle = is_half ? 0. : .5 * width, side = boundary == "top" ? 1. : -1.;
      std::function<double(double)> height = [](double) { return 0.; };
      double y = boundary == "top" ? tall : 0.;
      if (body.shape == "rectangle with curved top")
      {
        height = [&body](const double x) { return (*body.top)(Vector2(x, 0.)); };
        y = height(middle);
      }
      const double size = std::min(width - middle, tall);
      return {body, size * body.placement.length_to_world(1.), is_half, {middle, y}, {0., side}, height};
    }

    HertzFace hertz_disc(const BodyDescription &body)
    {
      const double radius = body.size[0];
      return {body,
              body.placement.length_to_world(radius),
              body.shape == "quarter disc",
              {0., radius},
              {0., 1.},
              [radius](const double x) { return std::sqrt(std::max(0., radius * radius - x * x)); }};
    }

    HertzFace hertz_face(const SceneChecks &checks, const Scene &scene, const Side &side)
    {
      const BodyDescription &body = scene.bodies[scene.body_index(side.body)];
      const bool is_disc = body.shape == "disc" || body.shape == "half disc" || body.shape == "quarter disc";
      const bool holds =
          is_disc ? side.boundary == "outer"
                  : side.boundary == "top" || (body.shape == "rectangle" && side.boundary == "bottom");
      checks.require((is_disc || is_rectangle(body)) && holds,
                     side.body + ":" + side.boundary +
                         " must be the top or bottom of a rectangle, the top of a rectangle with curved top "
                         "or `outer` of a disc, half disc or quarter disc");
      for (const Condition &condition : body.conditions)
        checks.require(
            condition.boundary != side.boundary && !condition.exact &&
                condition.kind != ConditionKind::traction && condition.kind != ConditionKind::pressure,
            "`" + condition.boundary + ": " + to_string(condition.kind) + "` of body " + body.name +
                " is not allowed: what presses is a displacement or a resultant, away from the "
                "contact");
      return is_disc ? hertz_disc(body) : hertz_rectangle(body, side.boundary);
    }

    void check_hertz_places(const SceneChecks &checks, const HertzFace &slave, const HertzFace &master)
    {
      checks.require(slave.is_half == master.is_half,
                     "either both bodies or none must be halves with rollers on `left`");
      if (slave.is_half)
        for (const HertzFace *const face : {&slave, &master})
          checks.require_roller(face->body, "left");
      const auto world = [](const HertzFace &face, const Vector2 &own) -> Vector2 {
        return face.body.placement.direction_to_world(own);
      };
      const Vector2 normal = world(slave, slave.outward), along(normal.y(), -normal.x());
      const Vector2 between = slave.body.placement.point_to_world(slave.middle) -
                              master.body.placement.point_to_world(master.middle);
      const bool same_half =
          !slave.is_half || world(slave, Vector2::UnitX()).dot(world(master, Vector2::UnitX())) > 0.;
      checks.require((normal + world(master, master.outward)).norm() <= 1e-9 && same_half &&
                         std::abs(between.dot(along)) <= 1e-9 * slave.size,
                     "the bodies must face one another, the middles of the contact sides opposite");
    }

    /// The gap at some places of the contact against x^2/(2R), but for terms of the order (a/size)^2.
    void check_parabola(const SceneChecks &checks, const ContactDescription &contact, const HertzFace &slave,
                        const HertzFace &master, const double half_width, const double radius)
    {
      const auto gap = [&](const double x) {
        const Vector2 own(slave.middle.x() + x / slave.scale(), slave.middle.y());
        return contact.gap ? slave.scale() * (*contact.gap)(own) : slave.drop(x) + master.drop(x);
      };
      const double size = std::min(slave.size, master.size), edge = .5 * half_width * half_width / radius;
      const double allowed = edge * (1e-9 + std::pow(half_width / size, 2));
      for (const double share : {.25, .5, .75, 1., -.5, -1.})
      {
        if (slave.is_half && share < 0.)
          continue;
        const double x = share * half_width, grows = gap(x) - gap(0.), needed = .5 * x * x / radius;
        std::ostringstream text;
        text << "the gap grows by " << grows << " from the middle of the contact to x = " << x
             << ", it must grow by x^2/(2R) = " << needed;
        checks.require(std::abs(grows - needed) <= allowed, text.str());
      }
    }

    void check_hertz_force(const SceneChecks &checks, const BodyDescription &body, const double force)
    {
      for (const Condition &condition : body.conditions)
      {
        if (condition.kind != ConditionKind::resultant)
          continue;
        double received = std::abs(checks.constant(body, condition));
        if (condition.expressions.size() == 2)
          received = std::hypot(received, checks.constant(body, condition, 1));
        std::ostringstream text;
        text.precision(10);
        text << "the resultant of " << body.name << ":" << condition.boundary << " is " << received
             << ", it must be that of Reference/Force, here " << force;
        checks.require(agree(received, force), text.str());
      }
    }

    HertzLineContact make_hertz(const Scene &scene)
    {
      const SceneChecks checks(scene.reference);
      checks.require_pair(scene);
      const ContactDescription &contact = scene.contacts.front();
      const HertzFace slave = hertz_face(checks, scene, contact.slave);
      const HertzFace master = hertz_face(checks, scene, contact.master);
      check_hertz_places(checks, slave, master);
      const BodyDescription &a = slave.body, &b = master.body;
      const double force = scene.reference.datum("Force"), radius = scene.reference.datum("Radius");
      const HertzLineContact hertz(
          force, radius,
          composite_modulus(a.young_modulus, a.poisson_ratio, b.young_modulus, b.poisson_ratio));
      std::ostringstream text;
      text << "the half-width of the contact, " << hertz.half_width() << ", must be below the bodies' size, "
           << std::min(slave.size, master.size);
      checks.require(hertz.half_width() < std::min(slave.size, master.size), text.str());
      check_parabola(checks, contact, slave, master, hertz.half_width(), radius);
      for (const BodyDescription *const body : {&a, &b})
        check_hertz_force(checks, *body, (slave.is_half ? .5 : 1.) * force);
      return hertz;
    }
  } // namespace

  HertzReference::HertzReference(const Scene &scene) : solution_(make_hertz(scene))
  {
    const HertzFace slave = hertz_face(SceneChecks(scene.reference), scene, scene.contacts.front().slave);
    middle_ = slave.middle.x();
    scale_ = slave.scale();
    force_ = (slave.is_half ? .5 : 1.) * scene.reference.datum("Force") / scale_;
  }

  std::function<double(const Vector2 &)> HertzReference::pressure() const
  {
    return
        [this](const Vector2 &own_point) { return solution_.pressure(scale_ * (own_point.x() - middle_)); };
  }

  namespace
  {
    ReferenceEntry hertz_entry()
    {
      ReferenceEntry entry{"hertz", "contact of half-planes, the pressure and its resultant"};
      entry.data = {{"Force", pressing_force, "Force / thickness"},
                    {"Radius", "R of 1/R = 1/R_1 + 1/R_2, in the plane; the gap is x^2/(2R)", "Length"}};
      entry.make = [](const Scene &scene) -> std::unique_ptr<ExactSolution> {
        return std::make_unique<HertzReference>(scene);
      };
      return entry;
    }

    const Registered<ReferenceEntry> registered_hertz(hertz_entry());
  } // namespace
} // namespace abut
