// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bem/galerkin_rule.h>
#include <abut/bem/holomorphic_series.h>
#include <abut/bem/kernel_products.h>
#include <abut/bem/pair_integrator.h>

#include <Eigen/Core>

#include <vector>

namespace abut
{
  /**
   * The products of KernelMatrices with vectors, in a time and memory that grow like the number of elements:
   * pairs of clusters close to each other as matrices, with the same integrals, the others by the fast
   * multipole method [GreengardRokhlin1987]. With w = zeta - z, zeta on a cluster around c, and a density f,
   *
   *   F_f = int f ln w ds,   H_f = int f conj(zeta - c)/w ds,   C_f = int f/w ds
   *
   * are holomorphic, int f ln|w| = (F_f + conj(F_conj(f)))/2, int f conj(w)/w = H_f + conj(z - c) F_f', and
   * int u Im(e/w) = (C_(u e) - conj(C_(conj(u) e)))/(2i) with the directions e of the elements.
   */
  class FastKernels
  {
  public:
    FastKernels(const std::vector<BoundaryElement> &elements, unsigned int degree, const GalerkinRule &rule);

    unsigned int degree() const { return degree_; }
    const ClusterTree &tree() const { return tree_; }

    /// A leaf's rows of the matrices, in the columns of the leaves near to it.
    struct NearRows : KernelBlock
    {
      std::vector<std::size_t> leaves;   ///< clusters
      std::vector<Eigen::Index> columns; ///< where those of each begin
    };
    /// Of every cluster; without leaves but for leaves.
    const std::vector<NearRows> &near() const { return near_; }

    /// What expansions of one accuracy need.
    class Expansions
    {
    public:
      /// `tolerance`: error of what a cluster contributes, relative to its largest density.
      Expansions(const FastKernels &kernels, double tolerance);

    private:
      friend class FastKernels;
      SeriesTranslation translation_;
      /**
       * Of every leaf, real parts above imaginary ones, a row for every k, a column for every polynomial of
       * every element: int P_n y^k ds and below it int P_n conj(y) y^k ds; int P_n y^k dy.
       */
      std::vector<Eigen::MatrixXd> moments_, directed_moments_;
    };

    KernelProducts multiply(const KernelDensities &densities, const Expansions &expansions) const;
    /// Without the pairs of near().
    KernelProducts multiply_far(const KernelDensities &densities, const Expansions &expansions) const;

  private:
    /// Of series from term to term.
    static constexpr double convergence = .4;

    /// Decides which of two clusters is divided; never both, so that neighbours are so mutually.
    bool is_larger(std::size_t a, std::size_t b) const;
    void find_neighbours(std::size_t target, const std::vector<std::size_t> &sources);
    void integrate_near(const GalerkinRule &rule);
    /// Of two leaves, the second one not before the first.
    void integrate_near(std::size_t leaf, std::size_t other, PairIntegrator &integrator);
    KernelProducts multiply(const KernelDensities &densities, const Expansions &expansions,
                            bool with_near) const;
    Eigen::Index first_row(std::size_t cluster) const;
    Eigen::Index n_rows(std::size_t cluster) const;
    void add_near(const KernelDensities &densities, KernelProducts &products) const;
    void add_far(const KernelDensities &densities, const Expansions &expansions,
                 KernelProducts &products) const;
    HolomorphicSeries outgoing(std::size_t leaf, const KernelDensities &densities,
                               const Expansions &expansions) const;
    void add_incoming(std::size_t leaf, const HolomorphicSeries &incoming, const Expansions &expansions,
                      KernelProducts &products) const;

    unsigned int degree_;
    ClusterTree tree_;
    std::vector<BoundaryElement> elements_;       ///< in the order of the tree
    std::vector<std::vector<std::size_t>> apart_; ///< of every cluster: those whose series come in
    std::vector<NearRows> near_;                  ///< of every cluster; empty but for leaves
  };
} // namespace abut
