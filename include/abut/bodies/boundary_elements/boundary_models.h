// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/boundary_elements/boundary_model.h>

namespace abut
{
  /// A BoundaryModel for every piece of a body: one, but for glued bodies. To a piece the others are the
  /// tractions of the glue, see FiniteElementBody::glue_forces.
  class BoundaryModels
  {
  public:
    /// The body must outlive the object, which is that of its present mesh. Throws ComputationError.
    BoundaryModels(const FiniteElementBody &body, BoundarySolution kind,
                   const BoundaryAccuracy &accuracy = {});

    /// sigma_B at points of the body, see BoundaryModel. Adds to the cost. Throws ComputationError.
    std::vector<Stress> stress(const BodySolution &solution, const std::vector<SamplePoint> &points,
                               double tolerance, BoundaryCost &cost) const;
    /// Whether any of them is.
    bool is_fast() const;
    Eigen::Index n_elements() const;
    Eigen::Index n_unknowns() const;

  private:
    std::vector<std::size_t> piece_of_; ///< of active cells
    std::vector<std::unique_ptr<BoundaryModel>> models_;
  };
} // namespace abut
