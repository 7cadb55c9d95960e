// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bem/boundary_problem.h>
#include <abut/bem/interior_stress.h>
#include <abut/bodies/boundary_elements/boundary_accuracy.h>
#include <abut/bodies/boundary_elements/boundary_cost.h>
#include <abut/bodies/boundary_elements/boundary_data.h>

#include <memory>

namespace abut
{
  /**
   * A body's stress by boundary elements, sigma_B of (23), on the trace of its present mesh, which is split
   * towards singular vertices (see GradedSides; not with the constant traction, the paper's, nor where the
   * finite elements' own trace is taken). Made once for a
   * mesh, it solves for any load with the operators of (20)'s body and evaluates the stress inside.
   */
  class BoundaryModel
  {
  public:
    /// Of the whole body, or of the piece of marked cells (by active index). The body must outlive the model,
    /// which is that of its present mesh. Throws ComputationError.
    BoundaryModel(const FiniteElementBody &body, BoundarySolution kind, const BoundaryAccuracy &accuracy = {},
                  const std::vector<bool> &cells = {});

    /// sigma_B at points inside the body or piece (world frame), which answers the contact traction of
    /// `solution`; with a relative error of about the tolerance if it is computed fast. Adds to the cost.
    /// Throws ComputationError.
    std::vector<Stress> stress(const BodySolution &solution, const std::vector<Vector2> &points,
                               double tolerance, BoundaryCost &cost) const;
    bool is_fast() const { return solves_fast() || evaluates_fast(); }

    /// Tractions and displacements on the boundary, scaled (see BoundaryState), less the uniform force's.
    BoundaryState solve(const BodySolution &solution, double tolerance) const;
    /// The same as densities for the stress: on each element du/ds gets the term of its degree that halves
    /// its jumps at vertices and keeps its mean (not with the constant traction, nor across corners and
    /// singular vertices).
    BoundaryValues values(const BoundaryState &state) const;

    const BoundarySpace &space() const { return *space_; }
    Eigen::Index n_unknowns() const { return problem_ ? problem_->n_unknowns() : 0; }

  private:
    bool solves_fast() const { return accuracy_.solves_fast(space_->elements().size()); }
    bool evaluates_fast() const { return accuracy_.evaluates_fast(space_->elements().size()); }
    GalerkinRule rule() const;
    std::unique_ptr<BoundaryProblem> make_problem(bool fast) const;
    void smooth(Eigen::MatrixXcd &slope) const;

    const FiniteElementBody &body_;
    Material material_;
    BoundarySolution kind_;
    BoundaryAccuracy accuracy_;
    unsigned int traction_degree_;
    std::unique_ptr<GradedSides> sides_;
    std::unique_ptr<BoundarySpace> space_;
    std::unique_ptr<BoundaryData> data_;
    /// None with the trace of the finite elements; another where an iteration fails.
    mutable std::unique_ptr<BoundaryProblem> problem_;
  };
} // namespace abut
