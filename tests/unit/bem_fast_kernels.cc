// SPDX-License-Identifier: LGPL-2.1-or-later
// Products with the kernel matrices, by series and by the matrices.
#include <abut/bem/fast_kernels.h>

#include <gtest/gtest.h>

#include "bem_testing.h"
#include <algorithm>

using namespace abut;

namespace
{
  std::vector<double> parts_of_growing_length(const unsigned int n)
  {
    return graded_parts(n, 1.3);
  }

  double relative_difference(const Eigen::VectorXcd &a, const Eigen::VectorXcd &b)
  {
    return (a - b).norm() / b.norm();
  }

  KernelDensities random_densities(const Eigen::Index n)
  {
    return {Eigen::VectorXcd::Random(n), Eigen::VectorXcd::Random(n), Eigen::VectorXcd::Random(n)};
  }

  /// The largest relative error of all products.
  double largest_error(const KernelProducts &products, const KernelMatrices &matrices,
                       const KernelDensities &x)
  {
    const Eigen::MatrixXcd even = matrices.even_real + Complex(0., 1.) * matrices.even_imag;
    return std::max({relative_difference(products.traction_log, matrices.log * x.traction),
                     relative_difference(products.slope_log, matrices.log * x.slope),
                     relative_difference(products.traction_even, even * x.traction),
                     relative_difference(products.slope_even, even * x.slope),
                     relative_difference(products.double_layer, matrices.double_layer * x.displacement),
                     relative_difference(products.transposed_double_layer,
                                         matrices.double_layer.transpose() * x.traction)});
  }

  double error_of_products(const Elements &elements, const unsigned int degree, const double tolerance)
  {
    const GalerkinRule rule = GalerkinRule::precise();
    const KernelMatrices matrices = kernel_matrices(elements, degree, rule);
    const FastKernels fast(elements, degree, rule);
    const KernelDensities x = random_densities(matrices.log.rows());
    return largest_error(fast.multiply(x, {fast, tolerance}), matrices, x);
  }
} // namespace

TEST(BemFastKernels, MultiplyAsTheMatricesDo)
{
  // In the mean over elements, densities that are random lose no more than a cluster's largest one does.
  const std::vector<Elements> bodies = {l_shape(parts_of_growing_length(10)), rectangle(equal_parts(40)),
                                        rectangle(equal_parts(40), .01), rectangle_with_hole(20),
                                        circle(100, .4)};
  for (const Elements &elements : bodies)
    for (unsigned int degree = 0; degree <= 4; degree += 2)
      for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10})
        EXPECT_LT(error_of_products(elements, degree, tolerance), 10. * tolerance)
            << elements.size() << " " << degree << " " << tolerance;
}

TEST(BemFastKernels, AreTheSameByMatrices)
{
  for (unsigned int degree = 0; degree <= 3; ++degree)
  {
    const KernelMatrices matrices =
        kernel_matrices(l_shape(equal_parts(9)), degree, GalerkinRule::estimating());
    for (const Eigen::MatrixXd *symmetric : {&matrices.log, &matrices.even_real, &matrices.even_imag})
      EXPECT_EQ(*symmetric, symmetric->transpose());
    const KernelDensities x = random_densities(matrices.log.rows());
    EXPECT_LT(largest_error(matrices.multiply(x, x.traction), matrices, x), 1e-14);
  }
}

TEST(BemFastKernels, HaveNoSeriesForFewElements)
{
  // All of them near: the same integrals.
  EXPECT_LT(error_of_products(rectangle(equal_parts(3)), 2, 1e-2), 1e-14);
}
