// SPDX-License-Identifier: LGPL-2.1-or-later
// The tested matrix of close clusters against the whole one, by all pairs.
#include <abut/bem/near_system.h>

#include <gtest/gtest.h>

#include "../convergence/bem_study.h"
#include <numeric>

using namespace abut;

namespace
{
  constexpr double poisson_ratio = .3;

  /// A rectangle, held along its normals below and on the left; n edges on each side.
  struct HeldRectangle
  {
    HeldRectangle(const unsigned int n, const unsigned int degree)
        : space(traces_of({divided({{{0., 0.}, uniform(n)},
                                    {{1., 0.}, uniform(n)},
                                    {{1., .6}, uniform(n)},
                                    {{0., .6}, uniform(n)}})}),
                degree, degree),
          unknowns(space, supported(n), degree), kernels(space.elements(), degree, GalerkinRule::precise()),
          near(kernels, unknowns, poisson_ratio)
    {}

    static std::vector<std::vector<Vector2>> supported(const unsigned int n)
    {
      std::vector<std::vector<Vector2>> directions(4 * n);
      std::fill_n(directions.begin(), n, std::vector<Vector2>{Vector2::UnitY()});
      std::fill_n(directions.end() - n, n, std::vector<Vector2>{Vector2::UnitX()});
      return directions;
    }

    /// [V, -K; K^T, W] by all pairs.
    Eigen::MatrixXd whole() const
    {
      const LayerOperators operators(
          kernel_matrices(space.elements(), space.density_degree(), GalerkinRule::precise()), poisson_ratio);
      const auto &t = unknowns.tractions();
      const Eigen::MatrixXd k = operators.double_layer(t, unknowns.free());
      Eigen::MatrixXd matrix(unknowns.size(), unknowns.size());
      matrix << operators.single_layer(t, t), -k, k.transpose(),
          operators.hypersingular(unknowns.free(), unknowns.free());
      return matrix;
    }
    /// The constant of the single layer, which blocks do not have.
    Eigen::MatrixXd constant() const
    {
      const auto &t = unknowns.tractions();
      const Eigen::MatrixX2d integrals = unknowns.integrals(t);
      Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(unknowns.size(), unknowns.size());
      matrix.topLeftCorner(t.cols(), t.cols()) =
          ElasticKernels(poisson_ratio).single.even * integrals * integrals.transpose();
      return matrix;
    }
    /// All rows and columns.
    Eigen::MatrixXd principal() const
    {
      std::vector<Eigen::Index> all(static_cast<std::size_t>(unknowns.size()));
      std::iota(all.begin(), all.end(), 0);
      std::vector<std::size_t> elements(space.elements().size());
      std::iota(elements.begin(), elements.end(), std::size_t(0));
      return near.principal(all, elements);
    }

    BoundarySpace space;
    BoundaryUnknowns unknowns;
    FastKernels kernels;
    NearSystem near;
  };

  double relative(const Eigen::MatrixXd &difference, const Eigen::MatrixXd &whole)
  {
    return difference.cwiseAbs().maxCoeff() / whole.cwiseAbs().maxCoeff();
  }
} // namespace

TEST(BemNearSystem, IsTheWholeMatrixOfOneCluster)
{
  for (const unsigned int degree : {1u, 2u, 3u})
  {
    const HeldRectangle body(5, degree);
    const Eigen::MatrixXd whole = body.whole();
    EXPECT_LT(relative(body.principal() - whole, whole), 1e-13) << degree;
    const Eigen::VectorXd x = Eigen::VectorXd::Random(whole.cols());
    Eigen::VectorXd product = Eigen::VectorXd::Zero(x.size());
    body.near.add_product(x, product);
    const Eigen::VectorXd expected = (whole - body.constant()) * x;
    EXPECT_LT((product - expected).norm(), 1e-13 * expected.norm()) << degree;
  }
}

TEST(BemNearSystem, TakesFarElementsFromTheirMidpoints)
{
  for (const unsigned int degree : {1u, 2u, 3u})
  {
    const HeldRectangle body(40, degree);
    ASSERT_GT(body.kernels.near().size(), 1u);
    const Eigen::MatrixXd whole = body.whole(), missing = body.principal() - whole;
    // Clusters that are apart are as far from each other as one is wide, 16 elements: moments of polynomials
    // above degree 0 are of the order 1/16 of a far pair's kernel, which is 1/5 of that of a near one.
    EXPECT_LT(relative(missing, whole), .02) << degree;
    EXPECT_GT(relative(missing, whole), 1e-6) << degree; // not all is near
  }
}

TEST(BemNearSystem, AddsUpWithWhatIsFar)
{
  for (const unsigned int degree : {1u, 2u})
  {
    const HeldRectangle body(40, degree);
    const auto &t = body.unknowns.tractions();
    const Eigen::Index n = t.rows() / 2;
    // Tractions alone: V t = near + far + constant.
    const Eigen::VectorXd x = Eigen::VectorXd::Random(t.cols()), density = t * x;
    const Eigen::VectorXcd traction = density.head(n) + Complex(0., 1.) * density.tail(n),
                           zero = Eigen::VectorXcd::Zero(n);
    constexpr double tolerance = 1e-8;
    const KernelProducts far = body.kernels.multiply_far({traction, zero, zero}, {body.kernels, tolerance});
    const ElasticKernels::Kernel single = ElasticKernels(poisson_ratio).single;
    const Eigen::VectorXcd potential =
        single.log * far.traction_log + single.even * far.traction_even.conjugate();
    Eigen::VectorXd both(2 * n), all = Eigen::VectorXd::Zero(body.unknowns.size());
    both << potential.real(), potential.imag();
    all.head(t.cols()) = x;
    Eigen::VectorXd sum = body.constant() * all;
    body.near.add_product(all, sum);
    sum.head(t.cols()) += t.transpose() * both;
    const Eigen::VectorXd expected = body.whole() * all;
    EXPECT_LT((sum - expected).head(t.cols()).norm(), 10. * tolerance * expected.head(t.cols()).norm())
        << degree;
  }
}
