// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bem/elastic_kernels.h>
#include <abut/bem/kernel_matrices.h>
#include <abut/bem/legendre_basis.h>

namespace abut
{
  /**
   * The boundary operators of plane strain for G = 1, V, K and W of t = traction, u = displacement on the
   * boundary of a body. With k = 3 - 4 nu and the fundamental solution
   *
   *   U = (1/(4 pi (1+k))) [-2 k ln|w| I + I + (Re, -Im; -Im, -Re) conj(w)/w],   w = y - x,
   *
   * V t = int U t, K u = int T u as a principal value, T_ij the traction j at y of the load i at x, and
   * W u = -(traction of K u). For a displacement without loads inside
   *
   *   V t = (M/2 + K) u,   W u = (M^T/2 - K^T) t.
   *
   * K u = K_L u + (2 V - L)(-u_2', u_1'), K_L the double layer and L the single layer of the Laplacian, and
   * <W u, v> = int int v' [4 V - 2 (1-2nu)/(1-nu) L] u' need no principal value. See [HsiaoWendland2008,
   * Lemma 2.3.1] and [Sutradhar2008].
   * For another G: V/G and G W. V is positive definite while the body fits into a circle of radius
   * exp(1/(2 k)), the degenerate scale: divide coordinates by the diameter.
   */
  class LayerOperators
  {
  public:
    LayerOperators(KernelMatrices kernels, double poisson_ratio);

    const KernelMatrices &kernels() const { return kernels_; }
    double poisson_ratio() const { return poisson_ratio_; }

    /// <left, V right>
    Eigen::MatrixXd single_layer(const LegendreBasis &left, const LegendreBasis &right) const;
    /// <left, K right>
    Eigen::MatrixXd double_layer(const LegendreBasis &left, const DisplacementBasis &right) const;
    /// <left, W right>
    Eigen::MatrixXd hypersingular(const DisplacementBasis &left, const DisplacementBasis &right) const;
    /// <left, right>
    LegendreBasis mass(const LegendreBasis &left, const LegendreBasis &right) const;

  private:
    /// <left, potential of right>; half of it is computed where both are the same object.
    Eigen::MatrixXd symmetric(const ElasticKernels::Kernel &kernel, const LegendreBasis &left,
                              const LegendreBasis &right) const;
    Eigen::MatrixX2d integrals(const LegendreBasis &basis) const;

    KernelMatrices kernels_;
    double poisson_ratio_;
    ElasticKernels elastic_;
  };

  /// <left, right>, from the lengths of the elements and the degree of the polynomials.
  LegendreBasis legendre_mass(const Eigen::VectorXd &lengths, unsigned int degree, const LegendreBasis &left,
                              const LegendreBasis &right);

  /// The integrals over the boundary of both components of every column.
  Eigen::MatrixX2d legendre_integrals(const Eigen::VectorXd &lengths, unsigned int degree,
                                      const LegendreBasis &basis);

  /// A known field, in the rows of a LegendreBasis, as a basis of its own.
  LegendreBasis as_basis(const Eigen::VectorXd &field);
} // namespace abut
