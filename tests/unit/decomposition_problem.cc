// SPDX-License-Identifier: LGPL-2.1-or-later
// The interface problem, its compliance, spectrum and initial guesses.
#include <abut/decomposition/schemes/initial_guess.h>
#include <abut/decomposition/schemes/neumann.h>
#include <abut/decomposition/spectrum.h>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "decomposition_testing.h"

using namespace abut;

namespace
{
  using Index = Eigen::Index;

  const std::string coarse_upper = "Body upper/Cells=24, 6", coarse_lower = "Body lower/Cells=32, 8";

  /// 1 + the largest eigenvalue of (C, D theta) on the multipliers chosen.
  double dense_largest_eigenvalue(const InterfaceProblem &problem, const Eigen::MatrixXd &compliance,
                                  const Eigen::ArrayXd &chosen)
  {
    const Index n = problem.n_pressures();
    const Eigen::ArrayXd scaling = chosen / (problem.weights().array() * problem.penalties().array()).sqrt();
    const Eigen::MatrixXd matrix =
        scaling.matrix().asDiagonal() * compliance.topRows(n) * scaling.matrix().asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix, Eigen::EigenvaluesOnly);
    return 1. + solver.eigenvalues()[n - 1];
  }
} // namespace

TEST(DecompositionProblem, ContactLaw)
{
  const TwoLayers layers({coarse_upper, coarse_lower});
  const InterfaceProblem &problem = layers.problem();
  const Index n = problem.n_pressures();
  ASSERT_EQ(n, 33); // boxes of the finer side
  EXPECT_NEAR(problem.weights().sum(), 4., 1e-13);
  // theta = c H / E
  EXPECT_LT((problem.penalties().array() / (.05 / 2.1e5) - 1.).abs().maxCoeff(), 1e-14);
  Eigen::VectorXd response = Eigen::VectorXd::Zero(problem.response_size());
  for (Index i = 0; i < n; ++i)
    response[i] = problem.weights()[i] * (i % 2 == 0 ? -1e-5 : 2e-5) * static_cast<double>(i);
  for (Index i = 0; i < n; ++i)
  {
    EXPECT_NEAR(problem.gaps(response)[i], (i % 2 == 0 ? -1e-5 : 2e-5) * static_cast<double>(i), 1e-18);
    EXPECT_NEAR(problem.pressures(response)[i], i % 2 == 0 ? 42. * static_cast<double>(i) : 0., 1e-9);
  }
}

TEST(DecompositionProblem, GapUnderTheLoadsAloneIsApproachAndCurve)
{
  const TwoLayers layers({coarse_upper, coarse_lower});
  const InterfaceProblem &problem = layers.problem();
  const Index n = problem.n_pressures();
  // The upper layer moves down as a whole; int psi_i stays, and all of x^2 is there: sum_i D_i g_i = int g.
  EXPECT_NEAR(layers.loads().response.head(n).sum(), 1e-3 * 64. / 3. - 4. * 1.366e-3, 1e-14);
  EXPECT_LT((problem.normal_displacements(layers.loads().response, 0).array() - 1.366e-3).abs().maxCoeff(),
            1e-15);
  EXPECT_LT(problem.normal_displacements(layers.loads().response, 1).norm(), 1e-15);
  EXPECT_NEAR(layers.loads().energy_product, 0., 1e-15);
  EXPECT_EQ(layers.loads().force_gap.norm(), 0.);
}

TEST(DecompositionProblem, PressuresPressBothBodiesAlike)
{
  const TwoLayers layers({coarse_upper, coarse_lower});
  const InterfaceProblem &problem = layers.problem();
  const Eigen::VectorXd pressures = Eigen::VectorXd::LinSpaced(problem.n_pressures(), 0., 3.);
  for (std::size_t a = 0; a < 2; ++a)
  {
    const Eigen::VectorXd forces = problem.contact_forces(a, pressures);
    double x = 0., y = 0.;
    for (Index i = 0; i < forces.size(); i += 2)
    {
      x += forces[i];
      y += forces[i + 1];
    }
    EXPECT_NEAR(x, 0., 1e-13);
    EXPECT_NEAR(y, (a == 0 ? 1. : -1.) * problem.weights().dot(pressures), 1e-13) << "upper first";
  }
}

TEST(DecompositionProblem, ComplianceIsSymmetricAndPositive)
{
  const TwoLayers layers({coarse_upper, coarse_lower});
  const Eigen::MatrixXd c = compliance_matrix(layers.problem()).topRows(layers.problem().n_pressures());
  EXPECT_LT((c - c.transpose()).norm(), 1e-13 * c.norm());
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(c, Eigen::EigenvaluesOnly);
  EXPECT_GT(solver.eigenvalues()[0], 0.);
}

TEST(DecompositionProblem, DenseComplianceIsThatOfTheSolves)
{
  const TwoLayers layers({coarse_upper, coarse_lower});
  const InterfaceProblem &problem = layers.problem();
  const auto dense = make_compliance(problem, ComplianceMode::dense, 0.);
  const auto solves = make_compliance(problem, ComplianceMode::solves, 1e9);
  EXPECT_TRUE(dense->is_dense());
  EXPECT_FALSE(solves->is_dense());
  const Eigen::VectorXd p = Eigen::VectorXd::LinSpaced(problem.n_pressures(), -1., 2.);
  const Eigen::VectorXd expected = compliance_matrix(problem) * p;
  EXPECT_LT((dense->apply(p) - expected).norm(), 1e-12 * expected.norm());
  EXPECT_LT((solves->apply(p) - expected).norm(), 1e-12 * expected.norm());
}

TEST(DecompositionProblem, AutomaticComplianceTakesTheCheaperWay)
{
  // 33 multipliers; a column costs a quarter of a single solve.
  const TwoLayers layers({coarse_upper, coarse_lower});
  EXPECT_TRUE(make_compliance(layers.problem(), ComplianceMode::automatic, 9.)->is_dense());
  EXPECT_FALSE(make_compliance(layers.problem(), ComplianceMode::automatic, 8.)->is_dense());
}

TEST(DecompositionProblem, AutomaticComplianceBecomesAMatrixWhenItsSolvesHaveCostAsMuch)
{
  const TwoLayers layers({coarse_upper, coarse_lower});
  const InterfaceProblem &problem = layers.problem();
  const auto compliance = make_compliance(problem, ComplianceMode::automatic, 1.);
  const auto never = make_compliance(problem, ComplianceMode::solves, 1.);
  const Eigen::VectorXd p = Eigen::VectorXd::LinSpaced(problem.n_pressures(), -1., 2.);
  const Eigen::VectorXd expected = compliance_matrix(problem) * p;
  unsigned int n_solves = 0;
  while (!compliance->is_dense() && n_solves < 20)
  {
    EXPECT_LT((compliance->apply(p) - expected).norm(), 1e-12 * expected.norm());
    never->apply(p);
    ++n_solves;
  }
  EXPECT_EQ(n_solves, 9u); // 33 / 4, and the one that makes the matrix
  EXPECT_FALSE(never->is_dense());
}

TEST(DecompositionProblem, UncoveredPartsOfASideTakeNoPart)
{
  const TwoLayers layers({"Body upper/Size=2.3, 1", "Body upper/Cells=13, 6", coarse_lower});
  const InterfaceProblem &problem = layers.problem();
  EXPECT_NEAR(problem.weights().sum(), 2.3, 1e-13);
  EXPECT_GT(problem.weights().minCoeff(), .3 / 8.);
  for (Index k = 0; k < problem.n_pressures(); ++k)
    EXPECT_LT(problem.part(k).middle.x(), 2.3);
}

TEST(DecompositionProblem, LargestEigenvalueAgreesWithADenseSolver)
{
  const TwoLayers layers({coarse_upper, coarse_lower});
  const InterfaceProblem &problem = layers.problem();
  const Eigen::MatrixXd c = compliance_matrix(problem);
  const auto compliance = make_compliance(problem, ComplianceMode::solves, 0.);
  const auto expect_estimate = [&](const double estimate, const double exact) {
    EXPECT_GE(estimate, exact * (1. - 1e-12));
    EXPECT_LE(estimate, exact * (1. + 2e-5));
  };
  expect_estimate(largest_eigenvalue(problem, *compliance),
                  dense_largest_eigenvalue(problem, c, Eigen::ArrayXd::Ones(problem.n_pressures())));
  const Eigen::VectorXd p = limit_pressures(problem, c, layers.loads());
  const double here = dense_largest_eigenvalue(problem, c, (p.array() > 0.).cast<double>());
  expect_estimate(largest_eigenvalue(problem, *compliance, &p), here);
  const Eigen::VectorXd nothing = Eigen::VectorXd::Zero(problem.n_pressures());
  EXPECT_EQ(largest_eigenvalue(problem, *compliance, &nothing), 1.);
}

TEST(DecompositionProblem, SpectrumOfThePapersScene)
{
  const TwoLayers layers;
  const auto compliance = make_compliance(layers.problem(), ComplianceMode::solves, 0.);
  const double lambda = largest_eigenvalue(layers.problem(), *compliance);
  // 1 + 2 (1 - nu^2) / c: a long layer pressed so that its ends slide freely.
  EXPECT_NEAR(lambda / (1. + 2. * .91 / .05), 1., .01);
  std::printf("lambda_max = %.6f, gamma* = %.6f\n", lambda, 2. / lambda);
  EXPECT_DOUBLE_EQ(automatic_relaxation(lambda), 2. / (1. + lambda));
  EXPECT_NEAR(expected_steps(.02, 1e-6), std::log(1e-6) / std::log(.98), 1e-9);
}

TEST(DecompositionProblem, InitialGuessThatAnswersTheLayerPressure)
{
  const TwoLayers layers;
  const InterfaceProblem &problem = layers.problem();
  const auto compliance = make_compliance(problem, ComplianceMode::solves, 0.);
  const InterfaceState state =
      initial_guess(problem, *compliance, layers.loads(), InitialGuess::elastic_layer_response);
  ASSERT_TRUE(state.traction.has_value());
  // Both layers have k = (1 + nu)(1 - 2 nu) / (E (1 - nu)), theta = c / E.
  const double compliances = (2. * 1.3 * .4 / .7 + .05) / 2.1e5;
  const Eigen::VectorXd gaps = problem.gaps(layers.loads().response);
  for (Index i = 0; i < gaps.size(); ++i)
    EXPECT_NEAR((*state.traction)[i], std::max(0., -gaps[i]) / compliances, 1e-9);
  EXPECT_GT(state.traction->maxCoeff(), 170.);
  const Eigen::VectorXd response = layers.loads().response + compliance_matrix(problem) * *state.traction;
  EXPECT_LT((state.response - response).norm(), 1e-12 * response.norm());
}

TEST(DecompositionProblem, LiteralInitialGuessClosesTheGap)
{
  for (const std::vector<std::string> &meshes : {std::vector<std::string>{}, {coarse_upper, coarse_lower}})
  {
    const TwoLayers layers(meshes);
    const InterfaceProblem &problem = layers.problem();
    const auto compliance = make_compliance(problem, ComplianceMode::solves, 0.);
    const InterfaceState state =
        initial_guess(problem, *compliance, layers.loads(), InitialGuess::elastic_layer);
    EXPECT_FALSE(state.traction.has_value());
    const Eigen::VectorXd before = problem.gaps(layers.loads().response),
                          after = problem.gaps(state.response);
    EXPECT_LT((after - before.cwiseMax(0.)).cwiseAbs().maxCoeff(), 1e-17);
    EXPECT_LT(problem.pressures(state.response).maxCoeff(), 1e-9);
    // Equal layers share the overlap by halves: at x = 0, where the slave's last node lies, 1.366e-3 / 2
    // each, but for what the next part has less.
    const Eigen::VectorXd lower = problem.normal_displacements(state.response, 1);
    EXPECT_NEAR(lower[lower.size() - 1], .5 * before.minCoeff(), 2e-5);
    const Eigen::VectorXd upper = problem.normal_displacements(state.response, 0);
    EXPECT_NEAR(upper[0], 1.366e-3 + .5 * before.minCoeff(), 2e-5);
  }
}
