// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What a penalty changes, against the solution without one of the same matrices.
#include <abut/decomposition/interface_solver.h>

#include <gtest/gtest.h>

#include "decomposition_testing.h"

using namespace abut;

namespace
{
  std::vector<std::string> with_penalty(const std::string &coefficient)
  {
    return {"Body upper/Cells=32, 8", "Body lower/Cells=32, 8", "Decomposition/Scheme=newton",
            "Decomposition/Stopping rule=bound", "Contact interface/Penalty coefficient=" + coefficient};
  }

  Eigen::VectorXd pressures_of(const TwoLayers &layers)
  {
    return InterfaceSolver(layers.problem(), layers.parameters()).solve(layers.loads(), {}, {}).traction;
  }

  struct Change
  {
    double estimated, exact, force, exact_force;
  };

  Change change_by(const std::string &coefficient)
  {
    const TwoLayers penalised(with_penalty(coefficient)), rigid(with_penalty("0"));
    const Eigen::VectorXd p = pressures_of(penalised), q = pressures_of(rigid);
    const Eigen::MatrixXd compliance = compliance_matrix(rigid.problem());
    const PenaltyChange change =
        InterfaceSolver(penalised.problem(), penalised.parameters()).penalty_change(p);
    return {std::sqrt(change.energy), energy_distance(compliance, q - p), change.force,
            rigid.problem().normal_force(q) - rigid.problem().normal_force(p)};
  }

  // Parts that open, a tenth of the contact's length for the largest coefficient, are not followed.
  TEST(PenaltyChange, IsThatOfTheSolutionWithoutPenalty)
  {
    for (const std::string coefficient : {"0.001", "0.01", "0.05"})
    {
      SCOPED_TRACE(coefficient);
      const Change change = change_by(coefficient);
      EXPECT_NEAR(change.estimated / change.exact, 1., .1);
      EXPECT_NEAR(change.force / change.exact_force, 1., .12);
    }
  }

  TEST(PenaltyChange, IsZeroInExactContact)
  {
    const TwoLayers layers(with_penalty("0"));
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(layers.problem().n_pressures());
    const PenaltyChange change = InterfaceSolver(layers.problem(), layers.parameters()).penalty_change(ones);
    EXPECT_EQ(change.energy, 0.);
    EXPECT_EQ(change.force, 0.);
  }
} // namespace
