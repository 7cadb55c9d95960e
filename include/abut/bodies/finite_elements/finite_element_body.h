// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/body.h>
#include <abut/bodies/finite_elements/floating.h>
#include <abut/bodies/finite_elements/rigid_motion.h>
#include <abut/bodies/finite_elements/space.h>
#include <abut/bodies/finite_elements/stiffness.h>
#include <abut/bodies/finite_elements/supports.h>

namespace abut
{
  /**
   * An elastic body by finite elements: mesh, space, supports, stiffness and its Cholesky factor, made once
   * for each mesh and used in every step. Construction reads and checks everything, loads included
   * (UserError); the stiffness is assembled by `prepare`.
   */
  class FiniteElementBody : public Body
  {
  public:
    /// `contact_sides`: boundaries by name, in the order of the trace vector.
    /// `processes` share its mesh: all of them make the body and do with it the same things in the same
    /// order; null: this one has the mesh for itself.
    FiniteElementBody(const BodyDescription &description, const std::vector<std::string> &contact_sides,
                      const std::shared_ptr<Processes> &processes = nullptr);
    ~FiniteElementBody() override;

    const std::vector<Trace> &contact_sides() const override { return contact_sides_; }
    Eigen::MatrixXd respond(const Eigen::MatrixXd &forces) const override;
    LoadResponse respond_to_loads(double rigid_displacement) const override;
    /// First the free rigid motions, then the rigid side with a given resultant.
    BodyMotions motions() const override;

    const std::optional<Resultant> &resultant() const override { return resultant_; }
    const std::vector<std::string> &free_rigid_motions() const override { return free_rigid_motions_; }
    bool is_supported() const override { return !supports_.nodes.empty(); }
    double contact_depth(std::size_t side) const override;
    Material material_behind(std::size_t side) const override;
    LostLoad lost_load(const std::string &side) const override;
    void describe(std::ostream &out) const override;
    const std::vector<Warning> &mesh_warnings() const override { return space_->mesh().warnings; }
    std::optional<SideFacets> facets(const std::string &side) const override;
    Counts counts() const override;
    BodyCounters counters() const override { return counters_; }
    void count_from(const BodyCounters &counters) override { counters_ = counters; }

    unsigned int mesh_version() const override { return space_->n_meshes(); }
    std::vector<CellInfo> cells() const override;
    MeshQuality mesh_quality() const override;
    std::vector<BoundarySide> boundary() const override;
    std::vector<unsigned int> crowded_cells() const override;
    std::vector<Vector2> singular_vertices() const override;
    std::string why_no_bound() const override;
    /// See Space::adapt.
    std::vector<Eigen::VectorXd> adapt(const CellMarks &marks,
                                       const std::vector<Eigen::VectorXd> &fields) override;

    PreparationTimes prepare() override;
    Eigen::VectorXd deformation(const Eigen::VectorXd &contact_forces,
                                double rigid_displacement) const override;
    /// See RigidMotions.
    Eigen::VectorXd rigid_motion(double rigid_displacement) const override;
    Eigen::VectorXd free_motion(const Eigen::VectorXd &amplitudes) const override;
    double rigid_side_displacement(const Eigen::VectorXd &amplitudes) const override;
    /// From the assembled stiffness.
    Reactions reactions(const Eigen::VectorXd &deformation,
                        const Eigen::VectorXd &contact_forces) const override;
    double rigid_side_force(const Eigen::VectorXd &deformation,
                            const Eigen::VectorXd &contact_forces) const override;
    double condition() const override;
    /// u . K u / 2.
    double strain_energy(const Eigen::VectorXd &deformation) const override;
    double round_off_energy(const Eigen::VectorXd &deformation,
                            const Eigen::VectorXd &contact_forces) const override;
    Eigen::VectorXd data_oscillation() const override;
    double geometry_energy(const Eigen::VectorXd &deformation) const override;
    double lost_area() const override;

    Eigen::VectorXd trace_of(const Eigen::VectorXd &field) const override
    {
      return trace_to_dofs_.transpose() * field;
    }
    /// But for constrained unknowns, which follow the others.
    Eigen::VectorXd extended_by_zero(const Eigen::VectorXd &trace) const override
    {
      return space_->expansion() * (trace_to_dofs_ * trace);
    }
    Eigen::VectorXd prescribed_trace() const override { return trace_of(supports_.fixed + rigid_motion(0.)); }
    void visit_displacement(const Eigen::VectorXd &field, SamplePoints points,
                            const DisplacementVisitor &visitor) const override;
    void visit_stress(const Eigen::VectorXd &deformation, SamplePoints points,
                      const StressVisitor &visitor) const override;
    void visit_corner_stress(const Eigen::VectorXd &deformation, const StressVisitor &visitor) const override;
    Vector2 displacement_at(const Eigen::VectorXd &displacement, const Vector2 &point) const override;
    std::vector<unsigned int> cells_at(const Vector2 &point) const override;
    std::vector<MaterialStress> stresses_at(const Eigen::VectorXd &deformation,
                                            const Vector2 &point) const override;
    OutputPatches output_patches(const OutputFields &fields) const override;

    const Space &space() const { return *space_; }
    /// See abut::projects_divergence.
    bool projects_divergence() const;
    const Supports &supports() const { return supports_; }
    /// The boundary id of a contact side.
    dealii::types::boundary_id contact_boundary(std::size_t side) const;
    /// K u - f: what supports add to loads and contact forces, at every unknown; zero at hanging nodes.
    Eigen::VectorXd support_forces(const Eigen::VectorXd &deformation,
                                   const Eigen::VectorXd &contact_forces) const;

    /// What the glue of each of the space's glued_sides() adds to loads, contact forces and supports at the
    /// nodes of both sides, at every unknown. One by one: a corner of a part may be glued on either side.
    std::vector<Eigen::VectorXd> glue_forces(const Eigen::VectorXd &deformation,
                                             const Eigen::VectorXd &contact_forces) const;

  private:
    /// K u - f, what is missing to balance at every unknown.
    Eigen::VectorXd missing_forces(const Eigen::VectorXd &deformation,
                                   const Eigen::VectorXd &contact_forces) const;
    /// Everything that depends on the mesh but the stiffness.
    void set_up();
    std::size_t n_boundary_dofs() const;
    void collect_sides();
    void set_up_supports();
    void tell_supports();
    void collect_loads();
    Eigen::MatrixXd solve(const Eigen::MatrixXd &reduced_loads) const;
    /// Displacements of the contact sides by solves for the whole body.
    Eigen::MatrixXd respond_by_solves(const Eigen::MatrixXd &forces) const;
    void refuse_infinite(const Eigen::MatrixXd &solution) const;

    std::unique_ptr<Space> space_;
    std::size_t n_boundary_dofs_ = 0;
    Sides sides_;
    std::vector<std::string> contact_side_names_;
    std::vector<Trace> contact_sides_;
    std::optional<Resultant> resultant_;
    Nodes free_nodes_;  // to move
    Supports supports_; // what is prescribed less the rigid motions
    RigidMotions rigid_motions_;
    Eigen::VectorXd side_motion_; // a unit displacement of the rigid side, zero elsewhere
    std::vector<std::string> free_rigid_motions_;
    FloatingModes floating_;

    Eigen::SparseMatrix<double> trace_to_dofs_; // n_dofs x trace_size
    Eigen::SparseMatrix<double> trace_to_free_; // the same, reduced to the free directions
    Eigen::VectorXd load_;                      // tractions and body force
    std::unique_ptr<Stiffness> stiffness_;
    mutable BodyCounters counters_;
  };

  /// The body as finite elements. Throws UserError, which begins with its name and says what needs them, for
  /// one of another kind.
  const FiniteElementBody &as_finite_elements(const Body &body, const std::string &what);

  /// The points of a reference cell (see SamplePoints), with the weights of a quadrature where there are any.
  dealii::Quadrature<2> sample_rule(const Space &space, SamplePoints points);
} // namespace abut
