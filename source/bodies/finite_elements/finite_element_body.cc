// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/bodies/finite_elements/body_force.h>
#include <abut/bodies/finite_elements/finite_element_body.h>
#include <abut/bodies/finite_elements/glue.h>
#include <abut/bodies/finite_elements/locking.h>
#include <abut/bodies/finite_elements/nodes.h>
#include <abut/bodies/finite_elements/projected_divergence.h>
#include <abut/bodies/side_load.h>

#include <algorithm>
#include <map>
#include <utility>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    /// Places trace vectors into vectors of all unknowns.
    Eigen::SparseMatrix<double> trace_embedding(const TraceBody &body, const Index n_dofs)
    {
      std::vector<Eigen::Triplet<double>> entries;
      for (std::size_t side = 0; side < body.contact_sides().size(); ++side)
      {
        const auto &dofs = body.contact_sides()[side].node_dofs();
        for (std::size_t node = 0; node < dofs.size(); ++node)
          for (int component = 0; component < 2; ++component)
            entries.emplace_back(
                static_cast<int>(dofs[node][static_cast<std::size_t>(component)]),
                static_cast<int>(body.trace_offset(side) + 2 * static_cast<Index>(node)) + component, 1.);
      }
      Eigen::SparseMatrix<double> embedding(n_dofs, body.trace_size());
      embedding.setFromTriplets(entries.begin(), entries.end());
      return embedding;
    }

    Vector2 centre_of(const Nodes &nodes)
    {
      Vector2 sum = Vector2::Zero();
      for (const Vector2 &place : nodes.places)
        sum += place;
      return sum / static_cast<double>(nodes.places.size());
    }

    double extent_of(const Nodes &nodes, const Vector2 &centre)
    {
      double extent = 0.;
      for (const Vector2 &place : nodes.places)
        extent = std::max(extent, (place - centre).norm());
      return extent;
    }
  } // namespace

  namespace
  {
    /// The mesh with the sides that the scene names.
    std::unique_ptr<BodyMesh> mesh_of(const BodyDescription &description,
                                      const std::vector<std::string> &contact_sides,
                                      const std::shared_ptr<Processes> &processes)
    {
      auto mesh = make_mesh(description, processes);
      unite_named_sides(*mesh, description);
      for (const std::string &side : contact_sides)
        unite_sides(*mesh, side);
      split_to_size(*mesh);
      return mesh;
    }
  } // namespace

  FiniteElementBody::FiniteElementBody(const BodyDescription &description,
                                       const std::vector<std::string> &contact_sides,
                                       const std::shared_ptr<Processes> &processes)
      : Body(description), space_(std::make_unique<Space>(mesh_of(description, contact_sides, processes),
                                                          description.degree, description.joints)),
        contact_side_names_(contact_sides)
  {
    if (auto glued = find_glue(*space_, description, contact_sides); !glued.empty())
      space_->glue(std::move(glued));
    set_up();
    refuse_locking(description, *space_, supports_);
  }

  FiniteElementBody::~FiniteElementBody() = default;

  bool FiniteElementBody::projects_divergence() const
  {
    return abut::projects_divergence(space_->mesh().cell_type, description().largest_poisson_ratio());
  }

  void FiniteElementBody::set_up()
  {
    counters_.meshes = space_->n_meshes();
    counters_.mortars = space_->n_mortars();
    n_boundary_dofs_ = n_boundary_dofs();
    collect_sides();
    resultant_ = find_resultant(description(), sides_);
    set_up_supports();
    trace_to_dofs_ = trace_embedding(*this, space_->n_dofs());
    trace_to_free_ = supports_.free_directions.transpose() * trace_to_dofs_;
    collect_loads();
  }

  void FiniteElementBody::collect_sides()
  {
    sides_.clear();
    contact_sides_.clear();
    std::map<dealii::types::boundary_id, std::string> called;
    const auto side = [&](const std::string &boundary) -> const Trace & {
      const auto id = boundary_id(space_->mesh(), boundary);
      if (const std::string &name = called.try_emplace(id, boundary).first->second; name != boundary)
        throw UserError("Body " + this->name() + ": the scene calls one of its sides both `" + name +
                        "` and `" + boundary + "`, allowed is one of the two");
      return sides_.try_emplace(boundary, space_->trace(id)).first->second;
    };
    for (const Condition &condition : description().conditions)
      if (!condition.point)
        side(condition.boundary);
    for (const std::string &boundary : contact_side_names_)
      contact_sides_.push_back(side(boundary));
  }

  void FiniteElementBody::set_up_supports()
  {
    free_nodes_ = free_nodes(*space_);
    const Nodes &nodes = free_nodes_;
    const std::vector<PrescribedComponent> components =
        prescribed_components(description(), sides_, [&]() { return nodes; });
    const Vector2 centre = centre_of(nodes);
    const auto free_modes = free_rigid_modes(components, centre, extent_of(nodes, centre));
    free_rigid_motions_.clear();
    for (const RigidMode &mode : free_modes)
      free_rigid_motions_.push_back(mode.description());
    supports_ = make_supports(name(), nodes.dofs, space_->n_dofs(), components);
    floating_ =
        free_modes.empty() ? FloatingModes() : FloatingModes(nodes, free_modes, supports_.free_directions);
    side_motion_ = supports_.moving;
    tell_supports();
    rigid_motions_ = split_off_rigid_motions(nodes, supports_);
    if (!space_->has_constraints())
      return;
    const auto &expand = space_->expansion();
    supports_.free_directions = expand * supports_.free_directions;
    for (Eigen::VectorXd *const field :
         {&supports_.fixed, &supports_.moving, &side_motion_, &rigid_motions_.fixed, &rigid_motions_.moving})
      *field = expand * *field;
  }

  /// Tells the contact sides where the scene's supports hold them: not along the motion of a rigid side.
  void FiniteElementBody::tell_supports()
  {
    std::map<unsigned int, Eigen::Matrix2d> held; // by the first unknown of a node
    for (const SupportNode &node : supports_.nodes)
    {
      const Vector2 moving(side_motion_[node.dofs[0]], side_motion_[node.dofs[1]]);
      Eigen::Matrix2d projection = Eigen::Matrix2d::Identity();
      if (node.directions.size() == 1)
        projection = node.directions[0] * node.directions[0].transpose();
      if (moving.norm() > 0.)
        projection -=
            projection * moving * moving.transpose() * projection / (projection * moving).squaredNorm();
      held[node.dofs[0]] = projection;
    }
    for (Trace &side : contact_sides_)
    {
      std::vector<Eigen::Matrix2d> projections;
      for (const auto &dofs : side.node_dofs())
      {
        const auto node = held.find(dofs[0]);
        projections.push_back(node == held.end() ? Eigen::Matrix2d::Zero() : node->second);
      }
      side.set_supports(std::move(projections));
    }
  }

  void FiniteElementBody::collect_loads()
  {
    load_ = Eigen::VectorXd::Zero(space_->n_dofs());
    add_body_force(*space_, description(), load_);
    for (const Condition &condition : description().conditions)
      if (condition.kind == ConditionKind::traction || condition.kind == ConditionKind::pressure)
        add_traction(sides_.at(condition.boundary), condition, description().placement, load_);
  }

  std::vector<Eigen::VectorXd> FiniteElementBody::adapt(const CellMarks &marks,
                                                        const std::vector<Eigen::VectorXd> &fields)
  {
    const unsigned int before = mesh_version();
    std::vector<Eigen::VectorXd> carried = space_->adapt(marks, fields);
    if (mesh_version() == before)
      return carried;
    if (!processes()) // else `prepare` does, where all of them come by
      stiffness_.reset();
    set_up();
    return carried;
  }

  dealii::types::boundary_id FiniteElementBody::contact_boundary(const std::size_t side) const
  {
    return boundary_id(space_->mesh(), contact_side_names_[side]);
  }

  double FiniteElementBody::contact_depth(const std::size_t side) const
  {
    return abut::contact_depth(description(), space_->mesh(), contact_boundary(side));
  }

  LoadResponse FiniteElementBody::respond_to_loads(const double rigid_displacement) const
  {
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(trace_size());
    const Eigen::VectorXd deformed = deformation(zero, rigid_displacement);
    LoadResponse response;
    response.displacement = trace_to_dofs_.transpose() * (deformed + rigid_motion(rigid_displacement));
    response.energy_product = 2. * strain_energy(deformed);
    if (load_.isZero(0.))
      response.force_displacement = zero;
    else
      response.force_displacement =
          trace_to_free_.transpose() * solve(supports_.free_directions.transpose() * load_);
    return response;
  }

  Eigen::VectorXd FiniteElementBody::deformation(const Eigen::VectorXd &contact_forces,
                                                 const double rigid_displacement) const
  {
    const auto &t = supports_.free_directions;
    const Eigen::VectorXd prescribed = supports_.fixed + rigid_displacement * supports_.moving;
    return t * solve(t.transpose() *
                     (load_ + trace_to_dofs_ * contact_forces - stiffness_->times(prescribed))) +
           prescribed;
  }

  Eigen::VectorXd FiniteElementBody::rigid_motion(const double rigid_displacement) const
  {
    return rigid_motions_.fixed + rigid_displacement * rigid_motions_.moving;
  }

  double FiniteElementBody::strain_energy(const Eigen::VectorXd &deformation) const
  {
    return .5 * deformation.dot(stiffness_->times(deformation));
  }
} // namespace abut
