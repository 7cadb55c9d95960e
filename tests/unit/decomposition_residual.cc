// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The algebraic error of the scheme newton, and the accuracy of its systems on active sets.
#include <abut/decomposition/measures.h>
#include <abut/decomposition/schemes/neumann.h>
#include <abut/decomposition/schemes/newton.h>

#include <gtest/gtest.h>

#include "decomposition_testing.h"
#include <cmath>
#include <tuple>

using namespace abut;

namespace
{
  using Index = Eigen::Index;

  SchemeResult newton_on(const TwoLayers &layers, const ComplianceMode mode, const double tolerance)
  {
    DecompositionParameters parameters = layers.parameters();
    parameters.tolerance = tolerance;
    const auto compliance = make_compliance(layers.problem(), mode, 0.);
    const ContactSystem system(layers.problem(), *compliance, make_motion_terms(layers.problem()));
    return NewtonScheme(system, parameters).solve(layers.loads(), {std::nullopt, {}}, {});
  }

  /// Exact contact on a scene of two layers, with the compliance from solves.
  class ResidualOfOnePart
  {
  public:
    explicit ResidualOfOnePart(std::vector<std::string> overrides)
        : layers_(with_exact_contact(std::move(overrides))), z_(compliance_matrix(problem())),
          compliance_(make_compliance(problem(), ComplianceMode::dense, 0.)),
          residual_(problem(), *compliance_)
    {}

    const TwoLayers &layers() const { return layers_; }
    const Eigen::MatrixXd &z() const { return z_; }
    const ContactResidual &residual() const { return residual_; }
    const InterfaceProblem &problem() const { return layers_.problem(); }
    Index size() const { return problem().n_pressures(); }

    /// From the error that a gap at part k alone makes: t = gap / beta_k there, sqrt(t C_kk t) of the norm.
    double beta(const Index k) const
    {
      const Eigen::VectorXd pressures = Eigen::VectorXd::Ones(size()), answer = z_ * pressures;
      constexpr double gap = 1e-9; // below beta_k p_k: the part goes on pressing
      Eigen::VectorXd response = Eigen::VectorXd::Zero(problem().response_size());
      response[k] = gap * problem().weights()[k];
      const double error = residual_.algebraic(layers_.loads(), pressures, answer, response),
                   norm = reference_norm(problem(), layers_.loads(), pressures,
                                         layers_.loads().response + answer);
      return gap * std::sqrt(z_(k, k)) / (error * norm);
    }

    /// D_k a . C a / |D a|^2 over the parts [k - 2, k + 2] that there are, a = 1, -1, 1, ...; half-planes' at
    /// most.
    double expected_beta(const Index k) const
    {
      double work = 0., squares = 0.;
      for (Index j = std::max<Index>(k - 2, 0); j <= std::min(k + 2, size() - 1); ++j)
      {
        double answer = 0.;
        for (Index i = 0; i < size(); ++i)
          answer += (i + j) % 2 == 0 ? z_(j, i) : -z_(j, i);
        work += answer;
        squares += problem().weights()[j] * problem().weights()[j];
      }
      const ContactPair &pair = problem().surfaces()[0].pairs()[0];
      const double half_planes = 1. / pair.slave().young_modulus + 1. / pair.master().young_modulus;
      return problem().weights()[k] * std::min(half_planes, work / squares);
    }

  private:
    static std::vector<std::string> with_exact_contact(std::vector<std::string> overrides)
    {
      overrides.emplace_back("Decomposition/Scheme=newton");
      overrides.emplace_back("Decomposition/Stopping rule=bound");
      overrides.emplace_back("Contact interface/Penalty coefficient=0");
      return overrides;
    }

    TwoLayers layers_;
    Eigen::MatrixXd z_;
    std::unique_ptr<InterfaceCompliance> compliance_;
    ContactResidual residual_;
  };

  std::vector<std::string> on_cells(const std::string &upper, const std::string &lower,
                                    std::vector<std::string> more = {})
  {
    more.push_back("Body upper/Cells=" + upper);
    more.push_back("Body lower/Cells=" + lower);
    return more;
  }
} // namespace

TEST(DecompositionResidual, SoftnessIsTakenOverAPartAndTwoNeighboursOnBothSides)
{
  // On equal cells all parts but those at the ends yield alike. Where meshes do not match, where cells are
  // graded, and between the vertices and the middles of cells of degree 2, neighbours yield differently.
  for (const auto &overrides : {on_cells("24, 6", "24, 6"), on_cells("16, 4", "28, 7"),
                                on_cells("12, 3", "20, 5", {"Body upper/Young modulus=2.1e3"}),
                                on_cells("12, 3", "16, 4", {"Discretisation/Degree=2"}),
                                on_cells("24, 6", "24, 6", {"Body lower/Grading=10, 1"})})
  {
    const ResidualOfOnePart residual(overrides);
    ASSERT_EQ(residual.problem().surfaces()[0].partition().stretches().size(), 1u);
    for (Index k = 0; k < residual.size(); ++k)
    {
      const double expected = residual.expected_beta(k);
      // the compliance is a matrix or applied by solves: round-off times the condition of the stiffness, some
      // 1e4
      EXPECT_NEAR(residual.beta(k) / expected, 1., 1e-10) << overrides[0] << ", part " << k;
    }
  }
}

TEST(DecompositionResidual, ErrorIsOnTheSafeSideWhereNeighboursYieldDifferently)
{
  // See DecompositionNewton.TheAlgebraicErrorIsOnTheSafeSide, and the .9 there. Parts of degree 2 are in turn
  // long and short: softness from each alone makes the error too small by a fifth.
  const ResidualOfOnePart one(on_cells("33, 8", "32, 8",
                                       {"Body upper/Young modulus=2.1e3", "Discretisation/Degree=2",
                                        "Body lower/Grading=3, 1", "Body upper/Grading=.1, 1"}));
  const Eigen::VectorXd exact = newton_on(one.layers(), ComplianceMode::dense, 1e-9).traction;
  const Eigen::ArrayXd count = Eigen::ArrayXd::LinSpaced(one.size(), 0., static_cast<double>(one.size() - 1));
  double least = 10.;
  for (const double size : {1e-1, 1e-3, 1e-6})
    for (const double waves : {0., .2, 1., 2., 3.14159})
      for (const double spread : {0., 1.})
      {
        const Eigen::ArrayXd wave = size * (waves * count).cos();
        const Eigen::VectorXd p =
            (exact.array() * (1. + wave) + spread * size * exact.maxCoeff() * wave.abs()).matrix();
        const Eigen::VectorXd answer = one.z() * p;
        const double algebraic =
            one.residual().algebraic(one.layers().loads(), p, answer, one.layers().loads().response + answer);
        const double error = energy_distance(one.z(), p - exact) / one.layers().energy_norm(p);
        least = std::min(least, algebraic / error);
        EXPECT_GT(algebraic, .9 * error) << size << ' ' << waves << ' ' << spread;
      }
  std::printf("algebraic error by the true one: %.3f at least\n", least);
}

TEST(DecompositionNewton, PressuresOfAStiffSlaveAreMoreAccurate)
{
  // Of what both bodies yield, the slave has the share 1/(1 + 1e4): by as much more accurate than the
  // tolerance are the pressures that are found by solves, at once. Against those from the matrix.
  constexpr double tolerance = 1e-4, share = 1. / (1. + 1e4);
  for (const char *const c : {"0", "5e-2"})
    for (const auto &[upper, lower, degree] :
         {std::tuple("24, 6", "24, 6", "2"), {"32, 8", "12, 3", "1"}, {"32, 8", "12, 3", "2"}})
    {
      const TwoLayers layers(
          on_cells(upper, lower,
                   {"Body upper/Young modulus=2.1e1", "Decomposition/Scheme=newton",
                    "Decomposition/Stopping rule=bound", std::string("Discretisation/Degree=") + degree,
                    std::string("Contact interface/Penalty coefficient=") + c}));
      const SchemeResult expected = newton_on(layers, ComplianceMode::dense, 1e-9),
                         result = newton_on(layers, ComplianceMode::solves, tolerance);
      ASSERT_TRUE(result.converged()) << result.message;
      EXPECT_EQ(result.steps, expected.steps);
      const double error = (result.traction - expected.traction).norm() / expected.traction.norm();
      std::printf("%s on %s, degree %s, c = %s: %.1e\n", upper, lower, degree, c, error);
      EXPECT_LT(error, share * tolerance);
    }
}
