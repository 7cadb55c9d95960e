// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/body_facts.h>

#include <memory>
#include <mutex>

namespace abut
{
  /**
   * A body of a run of several processes: its mesh is where it lives. The others know what it tells of itself
   * there; whoever asks for anything else gets the answer of the body itself, which is made then and follows
   * the mesh from there on, as it is when the body comes to live in another process. One that is made from a
   * file is made at once, in all processes: files may change while a run goes on.
   */
  class TravellingBody : public Body
  {
  public:
    /// `contact_sides`: their names, see make_body. The body has to `learn` before it is asked for anything.
    TravellingBody(const BodyDescription &description, std::vector<std::string> contact_sides);

    /// With mesh and all: the same in every process. Throws ComputationError where it is not.
    Body &whole() const;
    bool is_whole() const;

    /// Where it lives: what it is on its present mesh.
    BodyFacts tell() const { return facts_of(whole(), contact_side_names_); }
    /// In all processes: what it has told. Throws ComputationError where it is another one here.
    void learn(BodyFacts facts);
    /// The same after an adaptation. Where it lives it has been adapted by these marks; elsewhere it follows.
    void learn(BodyFacts facts, const CellMarks &marks);
    /// It lives elsewhere from now on: what it takes is given back.
    void leave();

    // What it has told.
    const std::vector<Trace> &contact_sides() const override { return facts_->contact_sides; }
    const std::optional<Resultant> &resultant() const override { return facts_->resultant; }
    const std::vector<std::string> &free_rigid_motions() const override { return facts_->free_rigid_motions; }
    bool is_supported() const override { return facts_->is_supported; }
    double contact_depth(const std::size_t side) const override { return facts_->contact_depths[side]; }
    Material material_behind(const std::size_t side) const override { return facts_->materials_behind[side]; }
    LostLoad lost_load(const std::string &side) const override;
    void describe(std::ostream &out) const override;
    const std::vector<Warning> &mesh_warnings() const override { return facts_->mesh_warnings; }
    std::optional<SideFacets> facets(const std::string &side) const override;
    Counts counts() const override { return facts_->counts; }
    BodyCounters counters() const override;
    void count_from(const BodyCounters &counters) override;
    unsigned int mesh_version() const override { return facts_->mesh_version; }
    MeshQuality mesh_quality() const override { return facts_->mesh_quality; }
    std::vector<BoundarySide> boundary() const override { return facts_->boundary; }
    std::string why_no_bound() const override { return facts_->why_no_bound; }
    Eigen::VectorXd trace_of(const Eigen::VectorXd &field) const override;
    Eigen::VectorXd prescribed_trace() const override { return facts_->prescribed_trace; }
    void share(std::shared_ptr<Processes> processes) override;

    // Answers of the whole body.
    /// What it tells is known when it has been told (`learn`).
    std::vector<Eigen::VectorXd> adapt(const CellMarks &marks,
                                       const std::vector<Eigen::VectorXd> &fields) override;
    PreparationTimes prepare() override { return whole().prepare(); }
    Eigen::MatrixXd respond(const Eigen::MatrixXd &forces) const override { return whole().respond(forces); }
    LoadResponse respond_to_loads(double rigid_displacement) const override
    {
      return whole().respond_to_loads(rigid_displacement);
    }
    BodyMotions motions() const override { return whole().motions(); }
    std::vector<CellInfo> cells() const override { return whole().cells(); }
    std::vector<unsigned int> crowded_cells() const override { return whole().crowded_cells(); }
    std::vector<Vector2> singular_vertices() const override { return whole().singular_vertices(); }
    Eigen::VectorXd deformation(const Eigen::VectorXd &contact_forces,
                                double rigid_displacement) const override
    {
      return whole().deformation(contact_forces, rigid_displacement);
    }
    Eigen::VectorXd rigid_motion(double rigid_displacement) const override
    {
      return whole().rigid_motion(rigid_displacement);
    }
    Eigen::VectorXd free_motion(const Eigen::VectorXd &amplitudes) const override
    {
      return whole().free_motion(amplitudes);
    }
    double rigid_side_displacement(const Eigen::VectorXd &amplitudes) const override
    {
      return whole().rigid_side_displacement(amplitudes);
    }
    Reactions reactions(const Eigen::VectorXd &deformation,
                        const Eigen::VectorXd &contact_forces) const override
    {
      return whole().reactions(deformation, contact_forces);
    }
    double rigid_side_force(const Eigen::VectorXd &deformation,
                            const Eigen::VectorXd &contact_forces) const override
    {
      return whole().rigid_side_force(deformation, contact_forces);
    }
    double condition() const override { return whole().condition(); }
    double strain_energy(const Eigen::VectorXd &deformation) const override
    {
      return whole().strain_energy(deformation);
    }
    double round_off_energy(const Eigen::VectorXd &deformation,
                            const Eigen::VectorXd &contact_forces) const override
    {
      return whole().round_off_energy(deformation, contact_forces);
    }
    Eigen::VectorXd data_oscillation() const override { return whole().data_oscillation(); }
    double geometry_energy(const Eigen::VectorXd &deformation) const override
    {
      return whole().geometry_energy(deformation);
    }
    double lost_area() const override { return whole().lost_area(); }
    Eigen::VectorXd extended_by_zero(const Eigen::VectorXd &trace) const override
    {
      return whole().extended_by_zero(trace);
    }
    void visit_displacement(const Eigen::VectorXd &field, SamplePoints points,
                            const DisplacementVisitor &visitor) const override
    {
      whole().visit_displacement(field, points, visitor);
    }
    void visit_stress(const Eigen::VectorXd &deformation, SamplePoints points,
                      const StressVisitor &visitor) const override
    {
      whole().visit_stress(deformation, points, visitor);
    }
    void visit_corner_stress(const Eigen::VectorXd &deformation, const StressVisitor &visitor) const override
    {
      whole().visit_corner_stress(deformation, visitor);
    }
    Vector2 displacement_at(const Eigen::VectorXd &displacement, const Vector2 &point) const override
    {
      return whole().displacement_at(displacement, point);
    }
    std::vector<unsigned int> cells_at(const Vector2 &point) const override
    {
      return whole().cells_at(point);
    }
    std::vector<MaterialStress> stresses_at(const Eigen::VectorXd &deformation,
                                            const Vector2 &point) const override
    {
      return whole().stresses_at(deformation, point);
    }
    OutputPatches output_patches(const OutputFields &fields) const override;

  private:
    std::vector<std::string> contact_side_names_;
    std::optional<BodyFacts> facts_;     ///< of the present mesh
    std::vector<CellMarks> adaptations_; ///< that have led to it
    mutable std::mutex mutex_;           ///< of what follows
    mutable std::unique_ptr<Body> whole_;
  };
} // namespace abut
