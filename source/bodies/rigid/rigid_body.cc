// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/plane_geometry.h>
#include <abut/bodies/balance.h>
#include <abut/bodies/rigid/mode_fit.h>
#include <abut/bodies/rigid/rigid_body.h>
#include <abut/bodies/side_load.h>

#include <algorithm>
#include <limits>
#include <ostream>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    /// Any point of a rigid body can be held: the points themselves are the nodes that the conditions look
    /// for, with no unknowns of the outline.
    Nodes points_of_conditions(const BodyDescription &body)
    {
      constexpr unsigned int none = std::numeric_limits<unsigned int>::max();
      Nodes nodes;
      for (const Condition &condition : body.conditions)
        if (condition.point)
        {
          nodes.dofs.push_back({{none, none}});
          nodes.places.push_back(body.placement.point_to_world(*condition.point));
        }
      return nodes;
    }
  } // namespace

  RigidBody::RigidBody(const BodyDescription &description, const std::vector<std::string> &contact_sides)
      : Body(description), outline_(description)
  {
    for (const Condition &condition : description.conditions)
      if (!condition.point)
        sides_.try_emplace(condition.boundary, outline_.side(condition.boundary));
    for (const std::string &side : contact_sides)
      contact_sides_.push_back(outline_.side(side));
    resultant_ = find_resultant(description, sides_);
    set_up_supports();
    collect_loads();
  }

  Eigen::VectorXd RigidBody::zero_field() const
  {
    return Eigen::VectorXd::Zero(2 * static_cast<Index>(outline_.nodes().places.size()));
  }

  void RigidBody::set_up_supports()
  {
    const Nodes &nodes = outline_.nodes();
    const Vector2 centre = box_around(nodes.places).middle();
    const double size = farthest_from(centre, nodes);
    components_ =
        prescribed_components(description(), sides_, [&]() { return points_of_conditions(description()); });

    const std::vector<RigidMode> free = free_rigid_modes(components_, centre, size);
    free_modes_.resize(zero_field().size(), static_cast<Index>(free.size()));
    for (std::size_t k = 0; k < free.size(); ++k)
    {
      free_modes_.col(static_cast<Index>(k)) = field_of(free[k], nodes);
      free_rigid_motions_.push_back(free[k].description());
    }

    fixed_ = moving_ = zero_field();
    if (!components_.empty())
    {
      Eigen::VectorXd values(static_cast<Index>(components_.size())), per_unit(values);
      for (std::size_t i = 0; i < components_.size(); ++i)
      {
        values[static_cast<Index>(i)] = components_[i].value;
        per_unit[static_cast<Index>(i)] = components_[i].per_unit;
      }
      const ModeFit fit(nodes, components_, weights_of_components());
      fixed_ = fit.motion(values, name());
      moving_ = fit.motion(per_unit, name());
    }
    if (free.empty() && !resultant_)
      for (Trace &side : contact_sides_)
        side.set_supports({side.n_nodes(), Eigen::Matrix2d::Identity()});
  }

  Eigen::VectorXd RigidBody::weights_of_components() const
  {
    const std::vector<double> lengths = outline_.lengths_at_nodes();
    Eigen::VectorXd weights(static_cast<Index>(components_.size()));
    for (std::size_t i = 0; i < components_.size(); ++i)
    {
      const std::size_t node = components_[i].dofs[0] / 2;
      weights[static_cast<Index>(i)] = node < lengths.size() ? lengths[node] : 1.;
    }
    return weights;
  }

  void RigidBody::collect_loads()
  {
    load_ = zero_field();
    for (const Condition &condition : description().conditions)
      if (!is_support(condition.kind))
        add_traction(sides_.at(condition.boundary), condition, description().placement, load_);
  }

  Eigen::MatrixXd RigidBody::respond(const Eigen::MatrixXd &forces) const
  {
    AssertDimension(forces.rows(), trace_size());
    return Eigen::MatrixXd::Zero(forces.rows(), forces.cols());
  }

  LoadResponse RigidBody::respond_to_loads(const double rigid_displacement) const
  {
    return {trace_of(rigid_motion(rigid_displacement)), Eigen::VectorXd::Zero(trace_size()), 0.};
  }

  BodyMotions RigidBody::motions() const
  {
    const Index n_free = free_modes_.cols(), n = n_free + (resultant_ ? 1 : 0);
    BodyMotions result{Eigen::MatrixXd(trace_size(), n), Eigen::MatrixXd::Zero(n, n), Eigen::VectorXd(n),
                       free_rigid_motions_, load_.lpNorm<1>()};
    for (Index k = 0; k < n_free; ++k)
      result.traces.col(k) = trace_of(free_modes_.col(k));
    result.loads.head(n_free) = free_modes_.transpose() * load_;
    if (!resultant_)
      return result;
    result.traces.col(n_free) = trace_of(moving_);
    result.loads[n_free] = resultant_->force + moving_.dot(load_);
    result.names.push_back("displacement of the rigid side " + resultant_->boundary);
    return result;
  }

  Eigen::VectorXd RigidBody::free_motion(const Eigen::VectorXd &amplitudes) const
  {
    return free_modes_ * amplitudes.head(free_modes_.cols());
  }

  double RigidBody::rigid_side_displacement(const Eigen::VectorXd &amplitudes) const
  {
    return resultant_ ? amplitudes[free_modes_.cols()] : 0.;
  }

  double RigidBody::rigid_side_force(const Eigen::VectorXd &, const Eigen::VectorXd &contact_forces) const
  {
    return -moving_.dot(load_ + extended_by_zero(contact_forces));
  }

  Reactions RigidBody::reactions(const Eigen::VectorXd &, const Eigen::VectorXd &contact_forces) const
  {
    const Nodes &nodes = outline_.nodes();
    Balance balance(nodes);
    Reactions result;
    result.applied = balance.add_all(nodes, load_);
    result.contact = balance.add_all(nodes, extended_by_zero(contact_forces));
    if (!components_.empty())
    {
      const Eigen::VectorXd forces = ModeFit(nodes, components_, weights_of_components())
                                         .balancing(load_ + extended_by_zero(contact_forces));
      for (std::size_t i = 0; i < components_.size(); ++i)
      {
        const Vector2 force = forces[static_cast<Index>(i)] * components_[i].direction;
        result.by_boundary.try_emplace(components_[i].boundary, Vector2::Zero()).first->second += force;
        balance.add(components_[i].place, force);
      }
    }
    result.equilibrium_residual = balance.of_forces();
    result.moment_residual = balance.of_moments();
    return result;
  }

  Eigen::VectorXd RigidBody::trace_of(const Eigen::VectorXd &field) const
  {
    Eigen::VectorXd trace(trace_size());
    Index i = 0;
    for (const Trace &side : contact_sides_)
      for (const auto &dofs : side.node_dofs())
        for (const unsigned int dof : dofs)
          trace[i++] = field[dof];
    return trace;
  }

  Eigen::VectorXd RigidBody::extended_by_zero(const Eigen::VectorXd &trace) const
  {
    AssertDimension(trace.size(), trace_size());
    Eigen::VectorXd field = zero_field();
    Index i = 0;
    for (const Trace &side : contact_sides_)
      for (const auto &dofs : side.node_dofs())
        for (const unsigned int dof : dofs)
          field[dof] += trace[i++];
    return field;
  }

  double RigidBody::contact_depth(const std::size_t side) const
  {
    if (const auto depth = description().contact_depth)
      return description().placement.length_to_world(*depth);
    constexpr double vanishing = 1e-6;
    const Trace &trace = contact_sides_[side];
    Vector2 normal = Vector2::Zero();
    for (const abut::Segment &segment : trace.segments())
    {
      const Vector2 along = segment.points.back() - segment.points.front();
      normal += Vector2(along.y(), -along.x());
    }
    const Nodes &nodes = outline_.nodes();
    if (!(normal.norm() > vanishing * trace.length()))
      return farthest_from(box_around(nodes.places).middle(), nodes);
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    for (const Vector2 &place : nodes.places)
    {
      lowest = std::min(lowest, place.dot(normal.normalized()));
      highest = std::max(highest, place.dot(normal.normalized()));
    }
    return highest - lowest;
  }

  MeshQuality RigidBody::mesh_quality() const
  {
    const double none = std::numeric_limits<double>::quiet_NaN();
    return {none, none, none};
  }

  std::vector<BoundarySide> RigidBody::boundary() const
  {
    std::vector<BoundarySide> sides;
    for (const std::string &side : outline_.side_names())
      sides.push_back({{side}, outline_.side(side)});
    return sides;
  }

  void RigidBody::describe(std::ostream &out) const
  {
    out << "rigid, " << outline_.loops().size() << (outline_.loops().size() == 1 ? " curve" : " curves")
        << " without a mesh\n";
  }
} // namespace abut
