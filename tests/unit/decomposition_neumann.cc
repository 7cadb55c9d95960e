// SPDX-License-Identifier: LGPL-2.1-or-later
// The parallel Neumann scheme: iterates, bound, ways to end.
#include <abut/decomposition/interface_solver.h>
#include <abut/decomposition/schemes/initial_guess.h>
#include <abut/decomposition/schemes/neumann.h>

#include <gtest/gtest.h>

#include "decomposition_testing.h"

using namespace abut;

namespace
{
  using Index = Eigen::Index;

  const std::vector<std::string> coarse = {"Body upper/Cells=24, 6", "Body lower/Cells=32, 8"};

  DecompositionParameters by_bound(const double tolerance, const unsigned int maximum_steps = 100000)
  {
    DecompositionParameters parameters;
    parameters.tolerance = tolerance;
    parameters.maximum_steps = maximum_steps;
    return parameters;
  }

  /// Layers, their compliance and the limit of the iteration.
  struct Setting
  {
    explicit Setting(const std::vector<std::string> &overrides = {})
        : layers(overrides), problem(layers.problem()), loads(layers.loads()),
          matrix(compliance_matrix(problem)), compliance(make_compliance(problem, ComplianceMode::dense, 0.)),
          limit(limit_pressures(problem, matrix, loads)),
          start(initial_guess(problem, *compliance, loads, InitialGuess::elastic_layer_response))
    {}

    SchemeResult solve(const DecompositionParameters &parameters, const double gamma,
                       const StepObserver &observer = {}) const
    {
      return NeumannScheme(problem, *compliance, parameters, gamma).solve(loads, start, observer);
    }
    double error(const Eigen::VectorXd &pressures) const
    {
      return energy_distance(matrix, pressures - limit);
    }

    TwoLayers layers;
    const InterfaceProblem &problem;
    const InterfaceProblem::Loads &loads;
    Eigen::MatrixXd matrix;
    std::unique_ptr<InterfaceCompliance> compliance;
    Eigen::VectorXd limit;
    InterfaceState start;
  };
} // namespace

TEST(DecompositionNeumann, OneStepIsTheOneOfThePaper)
{
  const Setting setting(coarse);
  const double gamma = .03;
  const SchemeResult result = setting.solve(by_bound(1e-6, 2), gamma); // ends with the state of its last step
  const Eigen::VectorXd p = setting.problem.pressures(setting.start.response);
  const Eigen::VectorXd solved = setting.loads.response + setting.matrix * p;
  const Eigen::VectorXd next = gamma * solved + (1. - gamma) * setting.start.response;
  EXPECT_LT((result.response - next).norm(), 1e-12 * next.norm());
  EXPECT_LT((result.traction - (gamma * p + (1. - gamma) * *setting.start.traction)).norm(), 1e-10);
  EXPECT_EQ(result.relaxation, gamma);
}

TEST(DecompositionNeumann, DenseAndSolvesMakeTheSameIterates)
{
  const TwoLayers layers(coarse);
  const InterfaceProblem &problem = layers.problem();
  std::vector<SchemeResult> results;
  std::vector<std::vector<StepRecord>> records;
  for (const ComplianceMode mode : {ComplianceMode::dense, ComplianceMode::solves})
  {
    const auto compliance = make_compliance(problem, mode, 0.);
    const auto start =
        initial_guess(problem, *compliance, layers.loads(), InitialGuess::elastic_layer_response);
    records.emplace_back();
    results.push_back(
        NeumannScheme(problem, *compliance, by_bound(1e-12, 60), .03)
            .solve(layers.loads(), start, [&](const StepRecord &r) { records.back().push_back(r); }));
  }
  EXPECT_LT((results[0].response - results[1].response).norm(), 1e-12 * results[0].response.norm());
  EXPECT_LT((results[0].traction - results[1].traction).norm(), 1e-12 * results[0].traction.norm());
  ASSERT_EQ(records[0].size(), 60u);
  ASSERT_EQ(records[1].size(), 60u);
  for (std::size_t k = 0; k < 60; ++k)
  {
    EXPECT_EQ(records[0][k].step, k + 1);
    EXPECT_NEAR(records[0][k].bound / records[1][k].bound, 1., 1e-9) << k;
    EXPECT_NEAR(records[0][k].normal_force, records[1][k].normal_force, 1e-10) << k;
  }
}

TEST(DecompositionNeumann, TheBoundIsGuaranteedAndSharp)
{
  const Setting setting;
  constexpr double gamma = .02;
  std::vector<double> bounds;
  setting.solve(by_bound(1e-15, 800), gamma,
                [&](const StepRecord &record) { bounds.push_back(record.bound); });
  ASSERT_EQ(bounds.size(), 800u);

  const double limit_norm = setting.layers.energy_norm(setting.limit);
  const Index n = setting.problem.n_pressures();
  Eigen::VectorXd traction = *setting.start.traction;
  std::printf("  step   bound (relative)   error (relative)   bound / error\n");
  for (unsigned int step = 1; step <= bounds.size(); ++step)
  {
    const double norm = setting.layers.energy_norm(traction), error = setting.error(traction);
    const double ratio = bounds[step - 1] * norm / error;
    if (error > 1e-8 * limit_norm)
    {
      EXPECT_GE(ratio, 1. - 1e-6) << step;
      if (step >= 60)
      {
        EXPECT_LT(ratio, 2.) << step;
      }
    }
    for (const unsigned int k : {1u, 10u, 50u, 60u, 100u, 150u, 300u, 500u, 740u})
      if (step == k)
        std::printf("%6u %18.6e %18.6e %15.8f\n", step, bounds[step - 1], error / norm, ratio);
    // (20)-(21), said by tractions; the contact law by hand.
    const Eigen::ArrayXd gaps =
        (setting.loads.response.head(n) + setting.matrix.topRows(n) * traction).array() /
        setting.problem.weights().array();
    traction =
        gamma * ((-gaps).max(0.) / setting.problem.penalties().array()).matrix() + (1. - gamma) * traction;
  }
  EXPECT_LT(setting.error(traction), 1e-8 * limit_norm); // the whole range was looked at
}

TEST(DecompositionNeumann, TheBoundIsRelativeToTheEnergyNormUnderForcesToo)
{
  std::vector<std::string> overrides = coarse;
  overrides.push_back("Body lower/Conditions=left: normal displacement: 0; bottom: normal displacement: 0; "
                      "right: pressure: 30");
  const Setting setting(overrides);
  EXPECT_GT(setting.loads.force_gap.norm(), 0.);
  StepRecord first;
  setting.solve(by_bound(1e-6, 1), .02, [&](const StepRecord &record) { first = record; });
  const Eigen::VectorXd p = setting.problem.pressures(setting.start.response), q = *setting.start.traction;
  const double expected = energy_distance(setting.matrix, p - q) / setting.layers.energy_norm(q);
  EXPECT_NEAR(first.bound / expected, 1., 1e-9);
  EXPECT_NEAR(first.normal_force, setting.problem.weights().dot(p), 1e-10);
  EXPECT_NEAR(first.max_pressure, p.maxCoeff(), 1e-10);
}

TEST(DecompositionNeumann, EndsByTheBoundWithinTheBound)
{
  const Setting setting;
  for (const double tolerance : {1e-2, 1e-4, 1e-6})
  {
    const SchemeResult result = setting.solve(by_bound(tolerance), .02);
    EXPECT_TRUE(result.converged());
    EXPECT_EQ(result.stopped_by, StoppedBy::bound);
    EXPECT_LE(result.iteration_error, tolerance);
    EXPECT_LE(setting.error(result.traction) / setting.layers.energy_norm(result.traction),
              result.iteration_error * (1. + 1e-6));
    const Eigen::VectorXd response = setting.loads.response + setting.matrix * result.traction;
    EXPECT_LT((result.response - response).norm(), 1e-10 * response.norm());
  }
}

TEST(DecompositionNeumann, ThePapersRuleEndsAfterFiveStepsFarFromTheLimit)
{
  const TwoLayers layers;
  const InterfaceSolver solver(layers.problem(), layers.parameters());
  const SchemeResult result = solver.solve(layers.loads(), {}, {});
  EXPECT_TRUE(result.converged());
  EXPECT_EQ(result.stopped_by, StoppedBy::increment);
  EXPECT_GE(result.steps, 4u);
  EXPECT_LE(result.steps, 6u);
  EXPECT_LE(result.increment, .0015);
  EXPECT_TRUE(std::isnan(result.iteration_error)) << "the literal guess is no field";
  const SchemeResult limit = solver.limit(layers.loads(), result.traction);
  const InterfaceProblem &problem = layers.problem();
  double largest = 0.;
  for (std::size_t a = 0; a < 2; ++a)
  {
    const Eigen::VectorXd there = problem.normal_displacements(limit.response, a);
    largest =
        std::max(largest, (problem.normal_displacements(result.iterate, a) - there).norm() / there.norm());
  }
  EXPECT_NEAR(largest, .06, .01);
}

TEST(DecompositionNeumann, SolverAndItsLimitFindTheSolution)
{
  const Setting setting(coarse);
  DecompositionParameters parameters = by_bound(1e-8); // automatic relaxation
  const InterfaceSolver solver(setting.problem, parameters);
  const SchemeResult result = solver.solve(setting.loads, {}, {});
  EXPECT_TRUE(result.converged());
  const double norm = setting.layers.energy_norm(setting.limit);
  EXPECT_LE(setting.error(result.traction), 1e-8 * norm * (1. + 1e-6));
  EXPECT_LE(setting.error(solver.limit(setting.loads, result.traction).traction), 1e-10 * norm * (1. + 1e-3));
  const SchemeResult again = solver.solve(setting.loads, result.traction, {});
  EXPECT_EQ(again.steps, 1u);
}

TEST(DecompositionNeumann, TooLargeAGammaEndsAndNamesTheLargestOne)
{
  const Setting setting;
  const SchemeResult result = setting.solve(by_bound(1e-6), .1);
  EXPECT_FALSE(result.converged());
  EXPECT_EQ(result.stopped_by, StoppedBy::stalled);
  EXPECT_LT(result.steps, 200u);
  EXPECT_NE(result.message.find("gamma* = 0.0535"), std::string::npos) << result.message;
  EXPECT_NE(result.message.find("does not converge with gamma = 0.1"), std::string::npos) << result.message;

  // Below gamma* it converges, even closely below.
  EXPECT_TRUE(setting.solve(by_bound(1e-6), .053).converged());
}

TEST(DecompositionNeumann, ATooLargeGammaDoesNotPassThePapersRule)
{
  for (const std::string tolerance : {"1e-4", "1e-6"})
  {
    const TwoLayers layers({"Decomposition/Relaxation=0.1", "Decomposition/Tolerance=" + tolerance});
    const SchemeResult result =
        InterfaceSolver(layers.problem(), layers.parameters()).solve(layers.loads(), {}, {});
    EXPECT_FALSE(result.converged());
    EXPECT_EQ(result.stopped_by, StoppedBy::stalled);
  }
}

TEST(DecompositionNeumann, ARuleBelowRoundOffEndsWithItsOwnMessage)
{
  const Setting setting(coarse);
  const SchemeResult result = setting.solve(by_bound(1e-17), .05);
  EXPECT_EQ(result.stopped_by, StoppedBy::stalled);
  EXPECT_NE(result.message.find("round-off"), std::string::npos) << result.message;
  EXPECT_EQ(result.message.find("does not converge"), std::string::npos);
  EXPECT_LT(setting.error(result.traction), 1e-13 * setting.layers.energy_norm(setting.limit));
}

TEST(DecompositionNeumann, AFineIncrementIsReachedFromTheLiteralGuess)
{
  const TwoLayers layers({"Decomposition/Tolerance=1e-9"});
  const SchemeResult result =
      InterfaceSolver(layers.problem(), layers.parameters()).solve(layers.loads(), {}, {});
  EXPECT_EQ(result.stopped_by, StoppedBy::increment) << result.message;
  EXPECT_LE(result.increment, 1e-9);
}

TEST(DecompositionNeumann, MaximumSteps)
{
  const Setting setting(coarse);
  const SchemeResult result = setting.solve(by_bound(1e-6, 7), .02);
  EXPECT_EQ(result.steps, 7u);
  EXPECT_EQ(result.stopped_by, StoppedBy::maximum_steps);
  EXPECT_NE(result.message.find("Decomposition/Maximum steps = 7"), std::string::npos) << result.message;
}

TEST(DecompositionNeumann, BodiesThatDoNotTouchAreDoneAtOnce)
{
  const TwoLayers layers({"Constants/Values=1e-3, -1e-3"});
  const SchemeResult result = InterfaceSolver(layers.problem(), by_bound(1e-6)).solve(layers.loads(), {}, {});
  EXPECT_EQ(result.stopped_by, StoppedBy::bound);
  EXPECT_EQ(result.steps, 1u);
  EXPECT_EQ(result.traction.norm(), 0.);
  EXPECT_EQ(result.iteration_error, 0.);
}

TEST(DecompositionNeumann, TheBoundIsReachedFromTheLiteralGuessToo)
{
  const TwoLayers layers({"Decomposition/Stopping rule=bound", "Decomposition/Tolerance=1e-6"});
  unsigned int n_without_bound = 0;
  const SchemeResult result = InterfaceSolver(layers.problem(), layers.parameters())
                                  .solve(layers.loads(), {}, [&](const StepRecord &record) {
                                    n_without_bound += std::isnan(record.bound) ? 1 : 0;
                                  });
  EXPECT_EQ(result.stopped_by, StoppedBy::bound) << result.message;
  EXPECT_LT(result.steps, 1000u);
  EXPECT_EQ(n_without_bound, 0u);
}
