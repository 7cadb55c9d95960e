// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/body.h>
#include <abut/bodies/rigid/rigid_outline.h>

#include <limits>

namespace abut
{
  /**
   * A body that does not deform: an outline without a mesh. Its supports prescribe a rigid motion or leave
   * one free; a side with a given resultant moves the whole body. It yields nothing to contact forces, has no
   * cells and no stress. Fields are displacements of the outline's nodes.
   */
  class RigidBody : public Body
  {
  public:
    /// Throws UserError: unknown sides, displacements that would deform the body.
    RigidBody(const BodyDescription &description, const std::vector<std::string> &contact_sides);

    const std::vector<Trace> &contact_sides() const override { return contact_sides_; }
    Eigen::MatrixXd respond(const Eigen::MatrixXd &forces) const override;
    LoadResponse respond_to_loads(double rigid_displacement) const override;
    /// First the free rigid motions, then the side with a given resultant.
    BodyMotions motions() const override;

    const std::optional<Resultant> &resultant() const override { return resultant_; }
    const std::vector<std::string> &free_rigid_motions() const override { return free_rigid_motions_; }
    bool is_supported() const override { return !components_.empty(); }
    /// `Contact depth` or the extent of the outline along the side's mean normal (half its diagonal where
    /// that vanishes).
    double contact_depth(std::size_t side) const override;
    Material material_behind(std::size_t) const override { return material(); }
    /// Loads of a body that cannot move are taken by its supports: nothing is lost that could deform it.
    LostLoad lost_load(const std::string &) const override { return {}; }
    void describe(std::ostream &out) const override;
    const std::vector<Warning> &mesh_warnings() const override { return no_warnings_; }
    std::optional<SideFacets> facets(const std::string &) const override { return {}; }
    /// Three unknowns: two translations and a rotation.
    Counts counts() const override { return {0, 3, 0}; }
    BodyCounters counters() const override { return {}; }
    void count_from(const BodyCounters &) override {}

    unsigned int mesh_version() const override { return 0; }
    std::vector<CellInfo> cells() const override { return {}; }
    MeshQuality mesh_quality() const override;
    std::vector<BoundarySide> boundary() const override;
    std::vector<unsigned int> crowded_cells() const override { return {}; }
    std::vector<Vector2> singular_vertices() const override { return {}; }
    std::string why_no_bound() const override { return {}; }
    std::vector<Eigen::VectorXd> adapt(const CellMarks &, const std::vector<Eigen::VectorXd> &fields) override
    {
      return fields;
    }

    PreparationTimes prepare() override { return {}; }
    Eigen::VectorXd deformation(const Eigen::VectorXd &, double) const override { return zero_field(); }
    Eigen::VectorXd rigid_motion(double rigid_displacement) const override
    {
      return fixed_ + rigid_displacement * moving_;
    }
    Eigen::VectorXd free_motion(const Eigen::VectorXd &amplitudes) const override;
    double rigid_side_displacement(const Eigen::VectorXd &amplitudes) const override;
    /// Where several sides hold the body their shares are not determined: the most even ones are told.
    Reactions reactions(const Eigen::VectorXd &deformation,
                        const Eigen::VectorXd &contact_forces) const override;
    double rigid_side_force(const Eigen::VectorXd &deformation,
                            const Eigen::VectorXd &contact_forces) const override;
    double condition() const override { return std::numeric_limits<double>::quiet_NaN(); }
    double strain_energy(const Eigen::VectorXd &) const override { return 0.; }
    double round_off_energy(const Eigen::VectorXd &, const Eigen::VectorXd &) const override { return 0.; }
    Eigen::VectorXd data_oscillation() const override { return {}; }
    double geometry_energy(const Eigen::VectorXd &) const override { return 0.; }
    double lost_area() const override { return 0.; }

    std::vector<unsigned int> cells_at(const Vector2 &) const override { return {}; }
    std::vector<MaterialStress> stresses_at(const Eigen::VectorXd &, const Vector2 &) const override
    {
      return {};
    }
    void visit_corner_stress(const Eigen::VectorXd &, const StressVisitor &) const override {}
    Eigen::VectorXd trace_of(const Eigen::VectorXd &field) const override;
    Eigen::VectorXd extended_by_zero(const Eigen::VectorXd &trace) const override;
    Eigen::VectorXd prescribed_trace() const override { return trace_of(fixed_); }
    /// At the nodes, for output, and around the outline: a hole is joined to the outer curve by a cut.
    void visit_displacement(const Eigen::VectorXd &field, SamplePoints points,
                            const DisplacementVisitor &visitor) const override;
    void visit_stress(const Eigen::VectorXd &, SamplePoints, const StressVisitor &) const override {}
    /// There is none inside: throws UserError.
    Vector2 displacement_at(const Eigen::VectorXd &displacement, const Vector2 &point) const override;
    /// A thin band behind the outline.
    OutputPatches output_patches(const OutputFields &fields) const override;

  private:
    void set_up_supports();
    void collect_loads();
    /// The length that each component stands for; 1 for points.
    Eigen::VectorXd weights_of_components() const;
    Eigen::VectorXd zero_field() const;

    RigidOutline outline_;
    Sides sides_;
    std::vector<Trace> contact_sides_;
    std::optional<Resultant> resultant_;
    std::vector<PrescribedComponent> components_;
    Eigen::VectorXd fixed_;      ///< the motion that supports prescribe
    Eigen::VectorXd moving_;     ///< per unit displacement of the side with a given resultant
    Eigen::MatrixXd free_modes_; ///< motions that no support prevents, a column each
    std::vector<std::string> free_rigid_motions_;
    Eigen::VectorXd load_;
    std::vector<Warning> no_warnings_;
  };
} // namespace abut
