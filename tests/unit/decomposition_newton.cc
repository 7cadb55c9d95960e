// SPDX-License-Identifier: LGPL-2.1-or-later
// The scheme newton: against independent solutions, at every penalty and stiffness ratio.
#include <abut/decomposition/interface_solver.h>
#include <abut/decomposition/schemes/contact_guess.h>
#include <abut/decomposition/schemes/newton.h>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "decomposition_testing.h"
#include <cmath>

using namespace abut;

namespace
{
  using Index = Eigen::Index;

  const std::vector<std::string> coarse_meshes = {"Body upper/Cells=24, 6", "Body lower/Cells=32, 8",
                                                  "Decomposition/Stopping rule=bound",
                                                  "Decomposition/Tolerance=1e-6"};

  std::vector<std::string> coarse_with(const std::vector<std::string> &more)
  {
    std::vector<std::string> all = coarse_meshes;
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  SchemeResult newton(const TwoLayers &layers, const ComplianceMode mode, const double tolerance,
                      const StepObserver &observer = {})
  {
    DecompositionParameters parameters = layers.parameters();
    parameters.tolerance = tolerance;
    const auto compliance = make_compliance(layers.problem(), mode, 0.);
    const ContactSystem system(layers.problem(), *compliance, make_motion_terms(layers.problem()));
    return NewtonScheme(system, parameters).solve(layers.loads(), {std::nullopt, {}}, observer);
  }
} // namespace

TEST(DecompositionNewton, FindsTheLimitOfTheNeumannScheme)
{
  const TwoLayers layers(coarse_meshes);
  const Eigen::MatrixXd c = compliance_matrix(layers.problem());
  const Eigen::VectorXd expected = limit_pressures(layers.problem(), c, layers.loads());
  for (const ComplianceMode mode : {ComplianceMode::dense, ComplianceMode::solves})
  {
    const SchemeResult result = newton(layers, mode, 1e-9);
    EXPECT_TRUE(result.converged()) << result.message;
    EXPECT_EQ(result.stopped_by, StoppedBy::bound);
    EXPECT_LE(result.steps, 10u);
    EXPECT_LT((result.traction - expected).norm(), 1e-8 * expected.norm());
    // the bound holds
    EXPECT_LE(energy_distance(c, result.traction - expected),
              (result.iteration_error + 1e-14) * layers.energy_norm(result.traction));
  }
}

TEST(DecompositionNewton, StepsDoNotGrowWithPenaltyOrContrast)
{
  for (const char *const stiffness : {"2.1e-1", "2.1e5", "2.1e11"})
    for (const char *const c : {"1e-1", "5e-4", "1e-8", "0"})
      for (const char *const scheme : {"newton", "conjugate"})
      {
        const TwoLayers layers(coarse_with({std::string("Decomposition/Scheme=") + scheme,
                                            std::string("Body upper/Young modulus=") + stiffness,
                                            std::string("Contact interface/Penalty coefficient=") + c}));
        const InterfaceSolver solver(layers.problem(), layers.parameters());
        const SchemeResult result = solver.solve(layers.loads(), {}, {});
        EXPECT_TRUE(result.converged()) << result.message;
        // Conjugate gradients end after as many steps as there are unknowns; expansions count twice.
        const bool is_newton = layers.parameters().scheme == "newton";
        EXPECT_LE(result.steps, is_newton ? 10 : 2 * layers.problem().n_pressures()) << stiffness << ' ' << c;
        std::printf("%-9s E1 = %s, c = %s: %u steps, error %.1e\n", scheme, stiffness, c, result.steps,
                    result.iteration_error);
      }
}

TEST(DecompositionNewton, ExactContactIsComplementary)
{
  // against all active sets' own conditions: no gap and no pressure at once, neither of the wrong sign
  const TwoLayers layers(
      coarse_with({"Decomposition/Scheme=newton", "Contact interface/Penalty coefficient=0"}));
  const Index n = layers.problem().n_pressures();
  const Eigen::MatrixXd c = compliance_matrix(layers.problem()).topRows(n);
  for (const ComplianceMode mode : {ComplianceMode::dense, ComplianceMode::solves})
  {
    const SchemeResult result = newton(layers, mode, 1e-9);
    EXPECT_TRUE(result.converged()) << result.message;
    EXPECT_EQ(result.stopped_by, StoppedBy::residual);
    const Eigen::VectorXd p = result.traction, gap = (layers.loads().response.head(n) + c * p)
                                                         .cwiseQuotient(layers.problem().weights());
    const double pressure = p.maxCoeff(), size = gap.maxCoeff(),
                 small = mode == ComplianceMode::dense ? 1e-12 : 1e-9;
    EXPECT_GE(p.minCoeff(), 0.);
    EXPECT_GE(gap.minCoeff(), -small * size);
    EXPECT_LE(p.cwiseProduct(gap).cwiseAbs().maxCoeff(), 10. * small * pressure * size);
  }
}

TEST(DecompositionNewton, TheAlgebraicErrorIsOnTheSafeSide)
{
  // Exact contact, pressures off by smooth and rough amounts. Bodies yield to pressures that alternate from
  // part to part a quarter of what half-planes do (a box gives (1, 6, 1)/8 to three nodes, half of what
  // alternates is lost, in both directions): for smooth errors the algebraic one is too large by 4 H/h = 32,
  // by twice that at most, for those that alternate less. On a stiff slave with finer cells, equal or graded,
  // rough pressures cost less still.
  const std::vector<std::vector<std::string>> cases = {
      {},
      {"Body upper/Young modulus=2.1e1"},
      {"Body upper/Young modulus=2.1e3", "Body lower/Grading=30, 1", "Body upper/Grading=3, 1"}};
  for (std::size_t i = 0; i < cases.size(); ++i)
  {
    const bool equal = i == 0;
    std::vector<std::string> overrides =
        coarse_with({"Decomposition/Scheme=newton", "Contact interface/Penalty coefficient=0"});
    overrides.insert(overrides.end(), cases[i].begin(), cases[i].end());
    const TwoLayers layers(overrides);
    const InterfaceProblem &problem = layers.problem();
    const Index n = problem.n_pressures();
    const Eigen::MatrixXd z = compliance_matrix(problem);
    const auto compliance = make_compliance(problem, ComplianceMode::dense, 0.);
    const ContactResidual residual(problem, *compliance);
    const Eigen::VectorXd exact = newton(layers, ComplianceMode::dense, 1e-9).traction;
    const Eigen::ArrayXd count = Eigen::ArrayXd::LinSpaced(n, 0., static_cast<double>(n - 1));
    for (const double size : {1e-1, 1e-3, 1e-6})
      for (const double waves : {0., .2, 1., 3.14159})
        for (const double spread : {0., 1.})
        {
          const Eigen::ArrayXd wave = size * (waves * count).cos();
          const Eigen::VectorXd p =
              (exact.array() * (1. + wave) + spread * size * exact.maxCoeff() * wave.abs()).matrix();
          const Eigen::VectorXd answer = z * p;
          const double algebraic =
              residual.algebraic(layers.loads(), p, answer, layers.loads().response + answer);
          const double error = energy_distance(z, p - exact) / layers.energy_norm(p);
          std::printf("case %d, size %g, waves %g, spread %g: %.3f\n", static_cast<int>(i), size, waves,
                      spread, algebraic / error);
          EXPECT_GT(algebraic, .9 * error) << i << ' ' << size << ' ' << waves << ' ' << spread;
          if (equal)
          {
            EXPECT_LT(algebraic, 2. * 4. * 8. * error) << size << ' ' << waves << ' ' << spread;
          }
        }
  }
}

TEST(DecompositionNewton, TheNeumannSchemeMakesNothingOfIt)
{
  const TwoLayers layers(coarse_meshes);
  EXPECT_EQ(InterfaceSolver(layers.problem(), layers.parameters()).motions(), nullptr);
}

TEST(DecompositionNewton, ConjugateGradientsFindTheSame)
{
  for (const char *const c : {"5e-2", "0"})
  {
    const TwoLayers layers(coarse_with({"Decomposition/Scheme=conjugate", "Decomposition/Tolerance=1e-8",
                                        std::string("Contact interface/Penalty coefficient=") + c}));
    const SchemeResult expected = newton(layers, ComplianceMode::dense, 1e-10);
    for (const char *const mode : {"dense", "solves"})
    {
      DecompositionParameters parameters = layers.parameters();
      parameters.compliance = std::string(mode) == "dense" ? ComplianceMode::dense : ComplianceMode::solves;
      const SchemeResult result = InterfaceSolver(layers.problem(), parameters).solve(layers.loads(), {}, {});
      EXPECT_TRUE(result.converged()) << result.message;
      EXPECT_LT((result.traction - expected.traction).norm(), 1e-6 * expected.traction.norm());
      EXPECT_GE(result.traction.minCoeff(), 0.);
    }
  }
}

namespace
{
  Eigen::MatrixXd model_matrix(const InterfaceProblem &problem)
  {
    const ModelCompliance model(problem);
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(problem.n_pressures(), problem.n_pressures());
    for (Index k = 0; k < matrix.cols(); ++k)
      matrix.col(k) = model.respond(Eigen::VectorXd(matrix.col(k)));
    return matrix;
  }

  double condition(const Eigen::MatrixXd &c, const Eigen::MatrixXd &model)
  {
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(c, model, Eigen::EigenvaluesOnly);
    return solver.eigenvalues()[c.rows() - 1] / solver.eigenvalues()[0];
  }
} // namespace

TEST(DecompositionNewton, ModelComplianceKeepsIterationsBounded)
{
  // The plain condition grows fourfold from 33 to 129 nodes.
  for (const std::vector<std::string> &bodies : std::vector<std::vector<std::string>>{
           {},
           {"Body upper/Young modulus=2.1e3"},
           {"Body upper/Size=4, 0.25", "Body upper/Young modulus=2.1e3"}, // a soft coating
           {"Discretisation/Degree=2"}})
  {
    std::vector<double> conditions;
    for (const char *const cells : {"32, 8", "64, 16", "128, 32"})
    {
      std::vector<std::string> all = bodies;
      all.push_back(std::string("Body upper/Cells=") + cells);
      all.push_back(std::string("Body lower/Cells=") + cells);
      const TwoLayers layers(all);
      const Index n = layers.problem().n_pressures();
      const Eigen::MatrixXd c = compliance_matrix(layers.problem()).topRows(n);
      conditions.push_back(condition(c, model_matrix(layers.problem())));
      std::printf("%s, %s: condition %.3g, preconditioned %.3g\n",
                  bodies.empty() ? "equal layers" : bodies.front().c_str(), cells,
                  condition(c, Eigen::MatrixXd::Identity(n, n)), conditions.back());
    }
    EXPECT_LT(conditions.back(), 8.);
    EXPECT_LT(conditions.back(), 1.15 * conditions[1]);
  }
}

TEST(DecompositionNewton, TheGuessFindsTheEdgeOfContact)
{
  for (const char *const cells : {"64, 16", "128, 32", "256, 64"})
    for (const char *const modulus : {"2.1e3", "2.1e5", "2.1e7"})
    {
      const TwoLayers layers(
          {std::string("Body upper/Cells=") + cells, std::string("Body lower/Cells=") + cells,
           std::string("Body upper/Young modulus=") + modulus, "Contact interface/Penalty coefficient=0",
           "Decomposition/Scheme=newton", "Decomposition/Stopping rule=bound"});
      const InterfaceProblem &problem = layers.problem();
      const auto compliance = make_compliance(problem, ComplianceMode::dense, 0.);
      const ContactSystem system(problem, *compliance, make_motion_terms(problem));
      const Eigen::ArrayXd guess = guess_contact(system, layers.loads(), {}).pressures,
                           found = newton(layers, ComplianceMode::dense, 1e-9).traction;
      const auto differing = ((guess > 0.) != (found > 0.)).count();
      std::printf("%s, E1 = %s: %d of %d nodes\n", cells, modulus, static_cast<int>(differing),
                  static_cast<int>((found > 0.).count()));
      EXPECT_LE(differing, 2);
    }
}

TEST(DecompositionNewton, TouchingWithoutForce)
{
  // The upper layer floats, touches and carries nothing.
  for (const char *const scheme : {"newton", "conjugate"})
    for (const char *const c : {"1e-3", "0"})
    {
      const TwoLayers layers(
          coarse_with({std::string("Decomposition/Scheme=") + scheme, "Contact interface/Gap=0",
                       "Body upper/Conditions=left: normal displacement: 0",
                       std::string("Contact interface/Penalty coefficient=") + c}));
      const SchemeResult result =
          InterfaceSolver(layers.problem(), layers.parameters()).solve(layers.loads(), {}, {});
      EXPECT_TRUE(result.converged()) << scheme << ' ' << c << ": " << result.message;
      EXPECT_LT(result.traction.maxCoeff(), 1e-9) << scheme << ' ' << c;
    }
}

TEST(DecompositionNewton, AnUnfinishedRunGuaranteesNothing)
{
  for (const char *const scheme : {"newton", "conjugate"})
    for (const char *const steps : {"1", "1000"})
    {
      const TwoLayers layers(coarse_with({std::string("Decomposition/Scheme=") + scheme,
                                          std::string("Decomposition/Maximum steps=") + steps}));
      // The guess is too good: begun with contact everywhere.
      const Eigen::VectorXd start = Eigen::VectorXd::Ones(layers.problem().n_pressures());
      const SchemeResult result =
          InterfaceSolver(layers.problem(), layers.parameters()).solve(layers.loads(), start, {});
      const bool finished = std::string(steps) != "1";
      EXPECT_EQ(result.converged(), finished) << scheme;
      EXPECT_EQ(result.stopped_by, finished ? StoppedBy::bound : StoppedBy::maximum_steps) << scheme;
      EXPECT_EQ(result.error_is_bound, finished) << scheme;
    }
}
