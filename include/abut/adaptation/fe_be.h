// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/adaptation/indicator.h>
#include <abut/bodies/boundary_elements/boundary_models.h>

#include <map>
#include <memory>
#include <mutex>

namespace abut
{
  /**
   * The indicator of the paper [Dyyak]: the difference of the stresses that finite and boundary elements give
   * for the same data, ||sigma_B - sigma_F|| in every cell, (24)-(27). Boundary elements answer the contact
   * traction of the solution, whatever displacement stands beside it: with that of an iterate the difference
   * tells of discretisation and iteration together. Operators and factors are kept for the present mesh of
   * each body. Where boundary elements are fast (BoundaryAccuracy) they are computed once more if they turn
   * out too inaccurate for what is estimated.
   */
  class FEBEIndicator : public Indicator
  {
  public:
    explicit FEBEIndicator(const BoundarySolution kind, const BoundaryAccuracy &accuracy = {})
        : kind_(kind), accuracy_(accuracy)
    {}

    /// Throws ComputationError where the boundary elements cannot solve.
    CellErrors estimate(const BodySolution &solution) const override;
    std::string name() const override { return "fe-be"; }
    void check(const Body &body) const override;

  private:
    struct Kept
    {
      unsigned int mesh;
      std::shared_ptr<const BoundaryModels> model;
    };
    std::shared_ptr<const BoundaryModels> model_of(const Body &body, BoundaryCost &cost) const;

    BoundarySolution kind_;
    BoundaryAccuracy accuracy_;
    mutable std::mutex mutex_;
    mutable std::map<const Body *, Kept> kept_;
  };
} // namespace abut
