// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/counts.h>
#include <abut/base/warning.h>
#include <abut/bodies/cells.h>
#include <abut/bodies/reactions.h>
#include <abut/bodies/trace_body.h>
#include <abut/mesh/cell_marks.h>
#include <abut/mesh/quality.h>
#include <abut/mesh/side_facets.h>
#include <abut/scene/body_description.h>

#include <iosfwd>
#include <memory>
#include <optional>

namespace abut
{
  class Processes;
  struct OutputFields;
  struct OutputPatches;

  /// How often the expensive things were done: for reports.
  struct BodyCounters
  {
    unsigned int meshes = 0;
    unsigned int assemblies = 0;
    unsigned int factorisations = 0;
    unsigned int solves = 0;     ///< right sides
    unsigned int mortars = 0;    ///< couplings of two sides inside the body
    unsigned int iterations = 0; ///< of the last solve; 0 of a factor

    void serialize(Archive &archive)
    {
      archive(meshes, assemblies, factorisations, solves, mortars, iterations);
    }
  };

  /// A side of a body as a curve, whether or not the scene names it.
  struct BoundarySide
  {
    std::vector<std::string> names; ///< that the scene may call it by; empty: it has none
    Trace curve;                    ///< its unknowns are those of the body's fields
    bool is_glued = false;          ///< to another side of the body

    void serialize(Archive &archive) { archive(names, curve, is_glued); }
  };

  /// Seconds of `Body::prepare`.
  struct PreparationTimes
  {
    double assemble = 0., factorise = 0.;

    void serialize(Archive &archive) { archive(assemble, factorise); }
  };

  /**
   * A body, elastic or rigid, as all but its own discretisation see it: adaptation, the loop, reports.
   * Contact and the interface solvers see less, the TraceBody. Fields are vectors of all unknowns of the
   * body, whatever these are; their values are asked for at points. Displacement = deformation + rigid
   * motion: stresses come from the deformation alone, so that a body which is moved much further than it
   * deforms keeps its digits.
   */
  class Body : public TraceBody
  {
  public:
    explicit Body(const BodyDescription &description) : description_(description) {}

    // What it is.
    const std::string &name() const override { return description_.name; }
    const BodyDescription &description() const { return description_; }
    /// Of the body but for its regions of another material.
    Material material() const { return {description_.young_modulus, description_.poisson_ratio}; }
    /// The side that carries a given force, where there is one.
    virtual const std::optional<Resultant> &resultant() const = 0;
    /// The rigid motions that no support prevents, in words.
    virtual const std::vector<std::string> &free_rigid_motions() const = 0;
    virtual bool is_supported() const = 0;
    /// H_a of the penalty and of the elastic layer for a contact side (world length).
    virtual double contact_depth(std::size_t side) const = 0;
    /// Of the body behind a contact side; the softest one there.
    virtual Material material_behind(std::size_t side) const = 0;
    virtual LostLoad lost_load(const std::string &side) const = 0;
    /// One line, or more, on its discretisation: `64 quadrilaterals of degree 1, 150 unknowns`.
    virtual void describe(std::ostream &out) const = 0;
    /// What the user should hear of the mesh it began with.
    virtual const std::vector<Warning> &mesh_warnings() const = 0;
    /// How straight edges stood for the curve of a side in that mesh; none where it was no mesh file's.
    virtual std::optional<SideFacets> facets(const std::string &side) const = 0;
    virtual Counts counts() const = 0;
    virtual BodyCounters counters() const = 0;
    /// Counts on from what the same body had counted on the same mesh.
    virtual void count_from(const BodyCounters &counters) = 0;

    // Its mesh.
    /// Changes whenever the mesh does, and with it the unknowns.
    virtual unsigned int mesh_version() const = 0;
    virtual std::vector<CellInfo> cells() const = 0; ///< by active cell index
    virtual MeshQuality mesh_quality() const = 0;
    /// All its sides: together they are the closed curves around it.
    virtual std::vector<BoundarySide> boundary() const = 0;
    /// Cells with a glued edge that more than two others lie opposite.
    virtual std::vector<unsigned int> crowded_cells() const = 0;
    /// Where the exact stress may be infinite.
    virtual std::vector<Vector2> singular_vertices() const = 0;
    /// Why the bound of the estimated error does not hold for this body; empty where it does.
    virtual std::string why_no_bound() const = 0;
    /**
     * Changes the mesh and carries fields over. Traces, supports and loads are those of the new mesh
     * afterwards; `prepare` has to be called again. Where no mark can be followed, nothing changes.
     */
    virtual std::vector<Eigen::VectorXd> adapt(const CellMarks &marks,
                                               const std::vector<Eigen::VectorXd> &fields) = 0;

    // Its answers, after `prepare`.
    /// The processes that share its stiffness from the next `prepare` on, which then ask it the same things
    /// in the same order; null: it is this process's alone.
    virtual void share(std::shared_ptr<Processes> processes) { processes_ = std::move(processes); }
    /// Makes what the answers need for the present mesh. Throws ComputationError.
    virtual PreparationTimes prepare() = 0;
    /// Under loads, supports and contact forces (a trace vector).
    virtual Eigen::VectorXd deformation(const Eigen::VectorXd &contact_forces,
                                        double rigid_displacement) const = 0;
    /// That the supports prescribe.
    virtual Eigen::VectorXd rigid_motion(double rigid_displacement) const = 0;
    /// What amplitudes of `motions` add to the displacement, without that of the rigid side.
    virtual Eigen::VectorXd free_motion(const Eigen::VectorXd &amplitudes) const = 0;
    /// The displacement of the rigid side among amplitudes of `motions`; 0 without one.
    virtual double rigid_side_displacement(const Eigen::VectorXd &amplitudes) const = 0;
    /// The whole displacement, but for free rigid motions.
    Eigen::VectorXd displacement(const Eigen::VectorXd &contact_forces, const double rigid_displacement) const
    {
      return deformation(contact_forces, rigid_displacement) + rigid_motion(rigid_displacement);
    }
    virtual Reactions reactions(const Eigen::VectorXd &deformation,
                                const Eigen::VectorXd &contact_forces) const = 0;
    /// Force of the rigid side on the body, along the direction of its resultant.
    virtual double rigid_side_force(const Eigen::VectorXd &deformation,
                                    const Eigen::VectorXd &contact_forces) const = 0;
    /// Condition number of the stiffness on the free unknowns, within some per cent: costs 60 solves. NaN for
    /// a body without.
    virtual double condition() const = 0;
    virtual double strain_energy(const Eigen::VectorXd &deformation) const = 0;
    /// Squared energy norm of what a deformation misses of the solution of the body's own equations.
    virtual double round_off_energy(const Eigen::VectorXd &deformation,
                                    const Eigen::VectorXd &contact_forces) const = 0;
    /// By active cell, energy norms, estimated, of what conditions and the body force do that the cells are
    /// too large for; no estimator of the solution sees that. Zero where they are the same everywhere.
    virtual Eigen::VectorXd data_oscillation() const = 0;
    /// Squared energy norm, estimated, of what edges of cells change that are not the curves they stand for:
    /// their stresses act along other normals. Zero for straight sides; NaN where the curve is not known.
    virtual double geometry_energy(const Eigen::VectorXd &deformation) const = 0;
    /// The share of the area within the curved sides that the cells leave out; negative where they go beyond.
    virtual double lost_area() const = 0;

    // Its fields.
    /// The values of a field on the contact sides, a trace vector.
    virtual Eigen::VectorXd trace_of(const Eigen::VectorXd &field) const = 0;
    /// The continuous field with given values on the contact sides that is zero at all other nodes.
    virtual Eigen::VectorXd extended_by_zero(const Eigen::VectorXd &trace) const = 0;
    /// What supports prescribe on the contact sides where they hold them, a trace vector; before `prepare`
    /// too.
    virtual Eigen::VectorXd prescribed_trace() const = 0;
    /// Of a displacement or deformation.
    virtual void visit_displacement(const Eigen::VectorXd &field, SamplePoints points,
                                    const DisplacementVisitor &visitor) const = 0;
    virtual void visit_stress(const Eigen::VectorXd &deformation, SamplePoints points,
                              const StressVisitor &visitor) const = 0;
    /// In cells at singular vertices of straight edges, at points that crowd towards them: where Gauss
    /// points miss what integrals need. These cells only.
    virtual void visit_corner_stress(const Eigen::VectorXd &deformation,
                                     const StressVisitor &visitor) const = 0;
    /// At a point of the undeformed body (world frame). Throws UserError for a point outside.
    virtual Vector2 displacement_at(const Eigen::VectorXd &displacement, const Vector2 &point) const = 0;
    /// The active cells that a point of the undeformed body (world frame) belongs to: none outside.
    virtual std::vector<unsigned int> cells_at(const Vector2 &point) const = 0;
    /// Means over the cells of each material at a point, several where materials meet; none outside.
    virtual std::vector<MaterialStress> stresses_at(const Eigen::VectorXd &deformation,
                                                    const Vector2 &point) const = 0;
    /// Mean over all cells at a point; empty outside.
    std::optional<Stress> stress_at(const Eigen::VectorXd &deformation, const Vector2 &point) const;
    virtual OutputPatches output_patches(const OutputFields &fields) const = 0;

  protected:
    const std::shared_ptr<Processes> &processes() const { return processes_; }

  private:
    BodyDescription description_;
    std::shared_ptr<Processes> processes_;
  };

  /// A body of the kind that its description asks for. Construction reads and checks everything, loads
  /// included (UserError). `contact_sides`: boundaries by name, in the order of the trace vector.
  /// `processes` share its mesh, see FiniteElementBody; a rigid body has none.
  std::unique_ptr<Body> make_body(const BodyDescription &description,
                                  const std::vector<std::string> &contact_sides,
                                  const std::shared_ptr<Processes> &processes = nullptr);
} // namespace abut
