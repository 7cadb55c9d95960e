// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/comparison/layers_reference.h>
#include <abut/comparison/scene_checks.h>
#include <abut/reference/layers_contact.h>
#include <abut/reference/penalised_layers_contact.h>
#include <abut/reference/piecewise_pressure.h>
#include <abut/results/results.h>
#include <abut/scene/reference_entry.h>
#include <abut/trace/applied_traction.h>

#include <deal.II/base/exceptions.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace abut
{
  namespace
  {
    /// The inward displacement of a face that slides, one number all along it.
    double sliding_approach(const SceneChecks &checks, const BodyDescription &body, const std::string &face)
    {
      if (const auto *const condition = find_condition(body, face, ConditionKind::displacement_y))
        return (face == "top" ? -1. : 1.) * checks.constant(body, *condition);
      const auto *const condition = find_condition(body, face, ConditionKind::normal_displacement);
      checks.require(condition != nullptr,
                     "the sliding face " + body.name + ":" + face +
                         " needs the condition 'displacement y' or 'normal displacement'");
      return -checks.constant(body, *condition);
    }

    /// The same for a face that is held along itself.
    double bonded_approach(const SceneChecks &checks, const BodyDescription &body, const std::string &face)
    {
      const auto *const condition = find_condition(body, face, ConditionKind::displacement);
      checks.require(condition != nullptr && checks.constant(body, *condition) == 0.,
                     "the bonded face " + body.name + ":" + face +
                         " needs the condition 'displacement' (0 along x)");
      return (face == "top" ? -1. : 1.) * checks.constant(body, *condition, 1);
    }

    void check_layer(const SceneChecks &checks, const BodyDescription &body, const std::string &contact_side,
                     const bool infinite)
    {
      checks.require(body.shape == "rectangle" && (contact_side == "top" || contact_side == "bottom"),
                     "body " + body.name + " must be a rectangle with contact on its top or bottom");
      checks.require_roller(body, "left");
      if (!infinite)
        checks.require_roller(body, "right");
      checks.require_no_further_conditions(body, infinite ? 2 : 3);
    }

    /// The contact side of a body from its end x = 0 to the other one, in the plane.
    std::array<Vector2, 2> contact_line(const Scene &scene, const Side &side)
    {
      const BodyDescription &body = scene.bodies[scene.body_index(side.body)];
      const double y = side.boundary == "top" ? body.size[1] : 0.;
      return {{body.placement.point_to_world(Vector2(0., y)),
               body.placement.point_to_world(Vector2(body.size[0], y))}};
    }

    void check_places(const SceneChecks &checks, const Scene &scene, const ContactDescription &contact)
    {
      const auto slave = contact_line(scene, contact.slave), master = contact_line(scene, contact.master);
      const double distance = std::max((slave[0] - master[0]).norm(), (slave[1] - master[1]).norm());
      checks.require(distance <= 1e-9 * (slave[1] - slave[0]).norm(),
                     "the two contact sides must lie on one another, x = 0 on x = 0");
    }

    void check_gap(const SceneChecks &checks, const Scene &scene, const LayersContactData &data)
    {
      const ContactDescription &contact = scene.contacts.front();
      checks.require(contact.gap.has_value(), "Contact " + contact.name + "/Gap must be an expression");
      const double y =
          contact.slave.boundary == "top" ? scene.bodies[scene.body_index(contact.slave.body)].size[1] : 0.;
      for (const double share : {0., .13, .5, .77, 1.})
      {
        const double x = share * data.length;
        checks.require(std::abs((*contact.gap)(Vector2(x, y)) - data.gap_curvature * x * x) <=
                           1e-9 * data.approach,
                       "Contact " + contact.name + "/Gap differs from Reference/Gap curvature x^2");
      }
    }

    LayersContactData make_data(const Scene &scene, const Layer::Ends ends, const Layer::Base base)
    {
      const SceneChecks checks(scene.reference);
      checks.require_pair(scene);
      const ContactDescription &contact = scene.contacts.front();
      LayersContactData data{};
      data.ends = ends;
      double approach = 0.;
      for (const Side &side : {contact.slave, contact.master})
      {
        const std::size_t index = scene.body_index(side.body);
        const BodyDescription &body = scene.bodies[index];
        check_layer(checks, body, side.boundary, ends == Layer::Ends::infinite);
        const bool bonded = base == Layer::Base::bonded;
        data.layers[index] = {body.young_modulus, body.poisson_ratio, body.size[1], base};
        const std::string face = side.boundary == "top" ? "bottom" : "top";
        approach += bonded ? bonded_approach(checks, body, face) : sliding_approach(checks, body, face);
      }
      data.length = scene.bodies[0].size[0];
      checks.require(agree(data.length, scene.bodies[1].size[0]), "the two bodies must have the same width");
      check_places(checks, scene, contact);
      data.gap_curvature = scene.reference.datum("Gap curvature");
      data.approach = scene.reference.datum("Approach");
      checks.require(agree(approach, data.approach),
                     "the faces approach by " + std::to_string(approach) +
                         ", not by Reference/Approach = " + std::to_string(data.approach));
      check_gap(checks, scene, data);
      return data;
    }

    /// H_a/E_a of a side as its pair has it: behind the top or bottom of a rectangle H_a is the height.
    double side_flexibility(const Scene &scene, const Side &side)
    {
      const BodyDescription &body = scene.bodies[scene.body_index(side.body)];
      return body.placement.length_to_world(body.contact_depth.value_or(body.size[1])) / body.young_modulus;
    }

    /// theta in the bodies' own lengths.
    double own_penalty(const Scene &scene)
    {
      const ContactDescription &contact = scene.contacts.front();
      const Placement &slave = scene.bodies[scene.body_index(contact.slave.body)].placement;
      return contact.penalty_between(side_flexibility(scene, contact.slave),
                                     side_flexibility(scene, contact.master)) /
             slave.length_to_world(1.);
    }

    std::unique_ptr<const PressedLayers> solve_layers(const Scene &scene, const Layer::Ends ends,
                                                      const Layer::Base base)
    {
      const LayersContactData data = make_data(scene, ends, base);
      if (scene.reference.contact == ReferenceParameters::Contact::penalised)
        return std::make_unique<const PenalisedLayersContact>(data, own_penalty(scene));
      return std::make_unique<const LayersContact>(data);
    }

    /// The polynomial with these values at the nodes of a basis on [0, 1], by powers.
    std::array<double, 4> powers(const LagrangeBasis &basis, const Eigen::VectorXd &values)
    {
      const Eigen::Index n = values.size();
      Eigen::MatrixXd matrix(n, n);
      for (Eigen::Index j = 0; j < n; ++j)
        matrix.col(j) = basis.nodes().array().pow(static_cast<double>(j));
      const Eigen::VectorXd solution = matrix.partialPivLu().solve(values);
      std::array<double, 4> result{};
      std::copy(solution.begin(), solution.end(), result.begin());
      return result;
    }

    /// The pressure that was applied to a body's contact side, over x of its own frame.
    std::vector<PressurePiece> pressure_pieces(const BodyResult &result, const double length)
    {
      AssertDimension(result.body->contact_sides().size(), 1);
      const Trace &side = result.body->contact_sides().front();
      const Placement &placement = result.body->description().placement;
      const Eigen::VectorXd traction = applied_traction(side, result.estimate_forces);
      const auto own_x = [&](const unsigned int node) {
        return std::clamp(placement.point_to_own(side.node_points()[node]).x(), 0., length);
      };
      std::vector<PressurePiece> pieces;
      for (const Segment &segment : side.segments())
      {
        Eigen::VectorXd values(static_cast<Eigen::Index>(segment.nodes.size()));
        for (Eigen::Index i = 0; i < values.size(); ++i)
        {
          const unsigned int node = segment.nodes[static_cast<std::size_t>(i)];
          values[i] = -traction.segment<2>(2 * node).dot(side.node_normals()[node]);
        }
        const double first = own_x(segment.nodes.front()), last = own_x(segment.nodes.back());
        if (first > last)
          values.reverseInPlace();
        pieces.push_back({std::min(first, last), std::max(first, last), powers(side.basis(), values)});
      }
      return pieces;
    }
  } // namespace

  LayersReference::LayersReference(const Scene &scene, const Layer::Ends ends, const Layer::Base base)
      : solution_(solve_layers(scene, ends, base))
  {
    const ContactDescription &contact = scene.contacts.front();
    for (const Side &side : {contact.slave, contact.master})
    {
      const std::size_t index = scene.body_index(side.body);
      contact_on_top_[index] = side.boundary == "top";
      thickness_[index] = scene.bodies[index].size[1];
    }
  }

  template <typename Field>
  OwnStress LayersReference::in_own_frame(const std::size_t body, const Field &field) const
  {
    const bool upright = contact_on_top_[body];
    const double thickness = thickness_[body];
    return [field, upright, thickness](const Vector2 &own_point) -> Stress {
      const ExactStress s =
          field(Vector2(own_point.x(), upright ? own_point.y() : thickness - own_point.y()));
      return {s.xx, s.yy, upright ? s.xy : -s.xy, s.zz};
    };
  }

  OwnStress LayersReference::stress(const std::size_t body) const
  {
    return in_own_frame(body, [this, body](const Vector2 &point) {
      return solution_->stress(static_cast<unsigned int>(body), point);
    });
  }

  OwnStress LayersReference::response(const std::size_t body, const BodyResult &result) const
  {
    const double length = solution_->data().length;
    if (solution_->data().ends == Layer::Ends::infinite)
      return {}; // the scene has ends
    const auto pressure = std::make_shared<PiecewisePressure>(length, pressure_pieces(result, length));
    const auto layer = std::make_shared<LayerResponse>(solution_->data().layers.at(body), pressure);
    return in_own_frame(body, [layer](const Vector2 &point) { return layer->stress(point); });
  }

  std::function<double(const Vector2 &)> LayersReference::pressure() const
  {
    return [this](const Vector2 &own_point) { return solution_->pressure(own_point.x()); };
  }

  namespace
  {
    template <Layer::Ends ends, Layer::Base base>
    std::unique_ptr<ExactSolution> make_layers(const Scene &scene)
    {
      return std::make_unique<LayersReference>(scene, ends, base);
    }

    ReferenceEntry layers_entry(const std::string &name, const std::string &documentation,
                                std::unique_ptr<ExactSolution> (*make)(const Scene &))
    {
      ReferenceEntry entry{name, documentation};
      entry.data = {{"Approach", "how far the outer faces approach each other", "Length"},
                    {"Gap curvature", "r of the gap r x^2", "1 / length"}};
      entry.make = make;
      return entry;
    }

    /// Layers with ends, which are known for both contact laws.
    ReferenceEntry finite_layers_entry(const std::string &name, const std::string &documentation,
                                       std::unique_ptr<ExactSolution> (*make)(const Scene &))
    {
      ReferenceEntry entry = layers_entry(name, documentation, make);
      entry.can_be_penalised = true;
      return entry;
    }

    using Ends = Layer::Ends;
    using Base = Layer::Base;

    const Registered<ReferenceEntry> registered_layers_sliding(finite_layers_entry(
        "layers sliding",
        "two layers with sliding faces and roller ends, pressed together over a quadratic gap",
        make_layers<Ends::rollers, Base::sliding>));
    const Registered<ReferenceEntry> registered_layers_bonded(
        finite_layers_entry("layers bonded", "as layers sliding, with faces that do not slide",
                            make_layers<Ends::rollers, Base::bonded>));
    const Registered<ReferenceEntry> registered_infinite_layers_sliding(
        layers_entry("infinite layers sliding",
                     "layers without an end, for scenes whose right ends are free; the ends make a "
                     "difference",
                     make_layers<Ends::infinite, Base::sliding>));
    const Registered<ReferenceEntry> registered_infinite_layers_bonded(
        layers_entry("infinite layers bonded", "as infinite layers sliding, with faces that do not slide",
                     make_layers<Ends::infinite, Base::bonded>));
  } // namespace
} // namespace abut
