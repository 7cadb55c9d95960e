// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/sparse_cholesky.h>
#include <abut/bodies/finite_elements/floating.h>
#include <abut/bodies/finite_elements/rigid_motion.h>
#include <abut/bodies/trace_body.h>

#include <memory>
#include <optional>

namespace abut
{
  /// How often the expensive things were done.
  struct BodyCounters
  {
    unsigned int meshes = 0;
    unsigned int assemblies = 0;
    unsigned int factorisations = 0;
    unsigned int solves = 0; ///< right sides
  };

  /// Forces of the supports on the body, and how well the body is in balance.
  struct Reactions
  {
    std::map<std::string, Vector2> by_boundary;
    Vector2 applied = Vector2::Zero(); ///< resultant of tractions and body force
    Vector2 contact = Vector2::Zero(); ///< resultant of the contact forces
    double equilibrium_residual = 0.;  ///< |sum of all forces| / sum of their sizes
    /// |sum of all moments| / (diagonal of the bounding box times the sum of the forces' sizes). Round-off
    /// but where hanging nodes meet curved edges: there a rotation is no field of the finite elements.
    double moment_residual = 0.;
  };

  /**
   * An elastic body by finite elements: mesh, space, supports, stiffness and its Cholesky factor, made once
   * for each mesh and used in every step. Construction reads and checks everything, loads included
   * (UserError); the stiffness is assembled by `prepare`.
   */
  class Body : public TraceBody
  {
  public:
    /// `contact_sides`: boundaries by name, in the order of the trace vector.
    Body(const BodyDescription &description, const std::vector<std::string> &contact_sides);
    ~Body() override;

    const std::string &name() const override { return description_.name; }
    const std::vector<Trace> &contact_sides() const override { return contact_sides_; }
    Eigen::MatrixXd respond(const Eigen::MatrixXd &forces) const override;
    LoadResponse respond_to_loads(double rigid_displacement) const override;
    /// First the free rigid motions, then the rigid side with a given resultant.
    BodyMotions motions() const override;

    const BodyDescription &description() const { return description_; }
    const Space &space() const { return *space_; }
    Material material() const { return {description_.young_modulus, description_.poisson_ratio}; }
    /// See abut::projects_divergence.
    bool projects_divergence() const;
    const Supports &supports() const { return supports_; }
    const std::optional<Resultant> &resultant() const { return resultant_; }
    const std::vector<std::string> &free_rigid_motions() const { return free_rigid_motions_; }
    const BodyCounters &counters() const { return counters_; }
    /// H_a of the penalty and of the elastic layer for a contact side (world length).
    double contact_depth(std::size_t side) const;

    /// The boundary id of a contact side.
    dealii::types::boundary_id contact_boundary(std::size_t side) const;

    /**
     * Changes the mesh and carries fields over (see Space::adapt). Traces, supports and loads are those of
     * the new mesh afterwards; `prepare` has to be called again.
     */
    std::vector<Eigen::VectorXd> adapt(const CellMarks &marks, const std::vector<Eigen::VectorXd> &fields);

    /// Assembles and factorises; seconds of both. Throws ComputationError.
    struct PreparationTimes
    {
      double assemble = 0., factorise = 0.;
    };
    PreparationTimes prepare();

    /// The displacement of all nodes under loads, supports and contact forces, less the rigid motion.
    Eigen::VectorXd deformation(const Eigen::VectorXd &contact_forces, double rigid_displacement) const;
    /// The rigid motion that the supports prescribe (see RigidMotions): displacement = deformation + rigid
    /// motion.
    Eigen::VectorXd rigid_motion(double rigid_displacement) const;
    /// What amplitudes of `motions` add to the displacement of all nodes, without that of the rigid side.
    Eigen::VectorXd free_motion(const Eigen::VectorXd &amplitudes) const;
    /// The displacement of the rigid side among amplitudes of `motions`; 0 without one.
    double rigid_side_displacement(const Eigen::VectorXd &amplitudes) const;
    /// The whole displacement of all nodes, but for free rigid motions.
    Eigen::VectorXd displacement(const Eigen::VectorXd &contact_forces, double rigid_displacement) const
    {
      return deformation(contact_forces, rigid_displacement) + rigid_motion(rigid_displacement);
    }
    /// Forces of the supports, from the assembled stiffness.
    Reactions reactions(const Eigen::VectorXd &deformation, const Eigen::VectorXd &contact_forces) const;
    /// K u - f: what supports add to loads and contact forces, at every unknown; zero at hanging nodes.
    Eigen::VectorXd support_forces(const Eigen::VectorXd &deformation,
                                   const Eigen::VectorXd &contact_forces) const;
    /// Force of the rigid side on the body, along the direction of its resultant.
    double rigid_side_force(const Eigen::VectorXd &deformation, const Eigen::VectorXd &contact_forces) const;
    /// Strain energy u . K u / 2.
    double strain_energy(const Eigen::VectorXd &deformation) const;

    /// The values of a field on the contact sides, a trace vector.
    Eigen::VectorXd trace_of(const Eigen::VectorXd &field) const
    {
      return trace_to_dofs_.transpose() * field;
    }
    /// The continuous field with given values on the contact sides and zero at all other nodes but hanging
    /// ones.
    Eigen::VectorXd extended_by_zero(const Eigen::VectorXd &trace) const
    {
      return space_->hanging_node_expansion() * (trace_to_dofs_ * trace);
    }

  private:
    /// Everything that depends on the mesh but the stiffness.
    void set_up();
    void collect_sides();
    void set_up_supports();
    void tell_supports();
    void collect_loads();
    Eigen::MatrixXd solve(const Eigen::MatrixXd &reduced_loads) const;

    BodyDescription description_;
    std::unique_ptr<Space> space_;
    Sides sides_;
    std::vector<std::string> contact_side_names_;
    std::vector<Trace> contact_sides_;
    std::optional<Resultant> resultant_;
    Supports supports_; // what is prescribed less the rigid motions
    RigidMotions rigid_motions_;
    Eigen::VectorXd side_motion_; // a unit displacement of the rigid side, zero elsewhere
    std::vector<std::string> free_rigid_motions_;
    FloatingModes floating_;

    Eigen::SparseMatrix<double> trace_to_dofs_; // n_dofs x trace_size
    Eigen::SparseMatrix<double> trace_to_free_; // the same, reduced to the free directions
    Eigen::SparseMatrix<double> stiffness_;
    Eigen::VectorXd load_; // tractions and body force
    std::unique_ptr<SparseCholesky> cholesky_;
    mutable BodyCounters counters_;
  };
} // namespace abut
