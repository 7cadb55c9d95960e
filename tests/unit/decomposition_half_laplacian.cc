// SPDX-License-Identifier: LGPL-2.1-or-later
// The square root of a Laplacian by tridiagonal solves, and what it is worth where contact sides have more
// parts than a matrix may have rows.
#include <abut/decomposition/half_laplacian.h>
#include <abut/decomposition/interface_solver.h>
#include <abut/decomposition/schemes/newton.h>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "decomposition_testing.h"
#include <cmath>

using namespace abut;

namespace
{
  using Index = Eigen::Index;

  /// Parts of widths that grow from the ends of a line to its middle.
  struct Line
  {
    Eigen::VectorXd places, widths, kappas;

    Line(const Index n, const double ratio, const double kappa)
        : places(n), widths(n), kappas(Eigen::VectorXd::Constant(n, kappa))
    {
      for (Index i = 0; i < n; ++i)
        widths[i] = std::pow(ratio, static_cast<double>(std::min(i, n - 1 - i)));
      widths /= widths.sum();
      double arc = 0.;
      for (Index i = 0; i < n; ++i)
      {
        places[i] = arc + .5 * widths[i];
        arc += widths[i];
      }
    }

    /// M f(A), symmetric, by the eigenvalues of A.
    template <typename Function> Eigen::MatrixXd function(const Function &f) const
    {
      const Index n = widths.size();
      const Eigen::VectorXd root = widths.cwiseSqrt();
      Eigen::MatrixXd a = kappas.cwiseAbs2().asDiagonal();
      for (Index i = 0; i + 1 < n; ++i)
      {
        const double link = 1. / (places[i + 1] - places[i]);
        a(i, i) += link / widths[i];
        a(i + 1, i + 1) += link / widths[i + 1];
        a(i, i + 1) = a(i + 1, i) = -link / (root[i] * root[i + 1]);
      }
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(a);
      const Eigen::VectorXd values = solver.eigenvalues().unaryExpr(f);
      return root.asDiagonal() * solver.eigenvectors() * values.asDiagonal() *
             solver.eigenvectors().transpose() * root.asDiagonal();
    }
  };

  template <typename Map> Eigen::MatrixXd matrix_of(const Index n, const Map &map)
  {
    Eigen::MatrixXd matrix(n, n);
    for (Index k = 0; k < n; ++k)
      matrix.col(k) = map(Eigen::VectorXd::Unit(n, k));
    return matrix;
  }

  /// Smallest and largest x.A x / x.B x.
  std::pair<double, double> ratios(const Eigen::MatrixXd &a, const Eigen::MatrixXd &b)
  {
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(a, b, Eigen::EigenvaluesOnly);
    return {solver.eigenvalues()[0], solver.eigenvalues()[a.rows() - 1]};
  }

  ActiveSet all_of(const InterfaceProblem &problem)
  {
    ActiveSet all;
    for (Index k = 0; k < problem.n_pressures(); ++k)
      all.push_back(k);
    return all;
  }
} // namespace

TEST(DecompositionHalfLaplacian, IsTheSquareRoot)
{
  for (const double ratio : {1., 1.15, 1.3})
    for (const double kappa : {.1, 1., 100.})
      for (const Index n : {1, 2, 60})
      {
        const Line line(n, ratio, kappa);
        const HalfLaplacian half(line.places, line.widths, line.kappas);
        const Eigen::MatrixXd exact = line.function([](const double a) { return 1. / std::sqrt(a); });
        const Eigen::MatrixXd integrals =
            matrix_of(n, [&](const Eigen::VectorXd &v) { return half.integrals(v); });
        EXPECT_LT((integrals - integrals.transpose()).cwiseAbs().maxCoeff(),
                  1e-9 * integrals.cwiseAbs().maxCoeff());
        const auto [least, most] = ratios(integrals, exact);
        EXPECT_GT(least, .98) << ratio << ' ' << kappa << ' ' << n;
        EXPECT_LT(most, 1.02) << ratio << ' ' << kappa << ' ' << n;
        for (const double softness : {0., .01, 10.})
        {
          // the inverse's quotients are those of the matrix, upside down
          const Eigen::MatrixXd soft =
              line.function([&](const double a) { return 1. / std::sqrt(a) + softness; });
          const Eigen::MatrixXd solved =
              matrix_of(n, [&](const Eigen::VectorXd &r) { return half.solve(r, softness); });
          const auto [smallest, largest] = ratios(solved, soft.inverse());
          EXPECT_GT(smallest, .96) << ratio << ' ' << kappa << ' ' << n << ' ' << softness;
          EXPECT_LT(largest, 1.04) << ratio << ' ' << kappa << ' ' << n << ' ' << softness;
        }
      }
}

TEST(DecompositionHalfLaplacian, KeepsIterationsBounded)
{
  for (const std::vector<std::string> &bodies : std::vector<std::vector<std::string>>{
           {},
           {"Body upper/Young modulus=2.1e3"},
           {"Body upper/Size=4, 0.25", "Body upper/Young modulus=2.1e3"}, // a soft coating
           {"Discretisation/Degree=2"}})
    for (const char *const cells : {"64, 16", "128, 32"})
    {
      std::vector<std::string> all = bodies;
      all.push_back(std::string("Body upper/Cells=") + cells);
      all.push_back(std::string("Body lower/Cells=") + cells);
      const TwoLayers layers(all);
      const InterfaceProblem &problem = layers.problem();
      const ModelCompliance model(problem, 0);
      const ActiveSet active = all_of(problem);
      const ModelCompliance::Factor factor(model, active);
      Eigen::MatrixXd c = compliance_matrix(problem).topRows(problem.n_pressures());
      c.diagonal() += problem.weights().cwiseProduct(problem.penalties());
      const Eigen::MatrixXd inverse =
          matrix_of(c.rows(), [&](const Eigen::VectorXd &r) { return factor.solve(r); });
      const auto [least, most] = ratios(inverse, c.inverse());
      std::printf("%s, %s: condition %.3g\n", bodies.empty() ? "equal layers" : bodies.front().c_str(), cells,
                  most / least);
      EXPECT_LT(most / least, 8.);
    }
}

TEST(DecompositionHalfLaplacian, TheModelIsSolvedOnActiveSets)
{
  const TwoLayers layers({"Body upper/Cells=48, 6", "Body lower/Cells=48, 8"});
  const InterfaceProblem &problem = layers.problem();
  const ModelCompliance model(problem, 0);
  ActiveSet active; // with a gap
  for (Index k = 3; k < problem.n_pressures(); ++k)
    if (k < 20 || k > 30)
      active.push_back(k);
  Eigen::MatrixXd matrix =
      matrix_of(problem.n_pressures(), [&](const Eigen::VectorXd &p) { return model.respond(p); });
  matrix.diagonal() += problem.weights().cwiseProduct(problem.penalties());
  const Eigen::MatrixXd right_sides = Eigen::MatrixXd::Random(static_cast<Index>(active.size()), 2);
  const Eigen::MatrixXd expected = matrix(active, active).eval().llt().solve(right_sides);
  EXPECT_LT((model.solve(active, right_sides, 1e-12) - expected).norm(), 1e-9 * expected.norm());
}

TEST(DecompositionHalfLaplacian, LargeInterfacesFindTheSamePressures)
{
  const TwoLayers layers({"Body upper/Cells=2050, 1", "Body lower/Cells=2010, 1",
                          "Contact interface/Penalty coefficient=0", "Decomposition/Scheme=newton",
                          "Decomposition/Stopping rule=bound"});
  const InterfaceProblem &problem = layers.problem();
  ASSERT_GT(problem.n_pressures(), ModelCompliance::most_rows);
  std::vector<Eigen::VectorXd> tractions;
  for (const ComplianceMode mode : {ComplianceMode::dense, ComplianceMode::solves})
  {
    DecompositionParameters parameters = layers.parameters();
    parameters.tolerance = 1e-6;
    const auto compliance = make_compliance(problem, mode, 0.);
    const ContactSystem system(problem, *compliance, make_motion_terms(problem));
    const SchemeResult result =
        NewtonScheme(system, parameters).solve(layers.loads(), {std::nullopt, {}}, {});
    EXPECT_TRUE(result.converged()) << result.message;
    tractions.push_back(result.traction);
  }
  EXPECT_LT((tractions[1] - tractions[0]).norm(), 1e-5 * tractions[0].norm());
}
