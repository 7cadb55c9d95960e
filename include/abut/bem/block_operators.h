// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bem/elastic_kernels.h>
#include <abut/bem/kernel_products.h>
#include <abut/bem/legendre_basis.h>

namespace abut
{
  /**
   * LayerOperators from a block of the kernel matrices, between bases on the elements of its rows (left) and
   * on those of its columns (right): without the constant I of the even kernel, which is of rank two and no
   * matter of blocks.
   */
  class BlockOperators
  {
  public:
    using Kernel = ElasticKernels::Kernel;

    /// The kernels must outlive the object.
    BlockOperators(const KernelBlock &kernels, double poisson_ratio);

    const ElasticKernels &elastic() const { return elastic_; }
    /// <left, potential of right>; half of it is computed where both are the same object.
    Eigen::MatrixXd symmetric(const Kernel &kernel, const LegendreBasis &left,
                              const LegendreBasis &right) const;
    /// <left, K right>
    Eigen::MatrixXd double_layer(const LegendreBasis &left, const DisplacementBasis &right) const;

  private:
    /// Adds the potential of a density, `value` times the Legendre polynomial of the column, in one
    /// component: in the rows of both components from `first` on.
    void add(const Kernel &kernel, Eigen::Index component, Eigen::Index column, double value,
             Eigen::Index first, Eigen::VectorXd &potential) const;

    const KernelBlock &kernels_;
    ElasticKernels elastic_;
  };
} // namespace abut
