// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bem/boundary_unknowns.h>
#include <abut/bem/fast_kernels.h>

#include <vector>

namespace abut
{
  /**
   * The share of clusters close to each other (FastKernels) in [V_DD, -K_DN; K_DN^T, W_NN], tested with the
   * unknowns, without the constant I of the kernels (BlockOperators): a matrix for every leaf, which the
   * products of an iteration take less time with than with those of single kernels.
   */
  class NearSystem
  {
  public:
    /// The kernels must outlive the object.
    NearSystem(const FastKernels &kernels, const BoundaryUnknowns &unknowns, double poisson_ratio);

    /// Adds the product with a vector of the unknowns, tractions first.
    void add_product(const Eigen::VectorXd &x, Eigen::VectorXd &result) const;
    /**
     * The rows and columns of some unknowns (ascending), all of which lie on some elements; with that
     * constant, and with what elements that are not close to each other have to do with each other from their
     * midpoints.
     */
    Eigen::MatrixXd principal(const std::vector<Eigen::Index> &unknowns,
                              const std::vector<std::size_t> &elements) const;

  private:
    /// What the elements of a leaf, the rows, and those close to it, the columns, have to do with each other.
    struct Block
    {
      std::vector<Eigen::Index> tractions, displacements;               ///< unknowns of the rows
      std::vector<Eigen::Index> column_tractions, column_displacements; ///< of the columns
      Eigen::MatrixXd v, k, w;
    };

    /// The integral of an unknown's traction or slope over an element.
    struct Charge
    {
      Eigen::Index unknown;
      Complex value;
    };
    struct Element
    {
      Complex midpoint;
      std::size_t leaf;
      const std::vector<std::size_t> *near; ///< leaves close to its own
      std::vector<Charge> charges;
    };

    void find_charges(const FastKernels &kernels, const BoundaryUnknowns &unknowns);
    /// `place`: the rows of unknowns, negative where they have none.
    void add_far(const std::vector<std::size_t> &elements, const std::vector<Eigen::Index> &place,
                 Eigen::MatrixXd &matrix) const;

    ElasticKernels elastic_;
    Eigen::Index n_tractions_;
    std::vector<Element> elements_;
    Eigen::MatrixX2d integrals_; ///< of the tractions
    std::vector<Block> blocks_;
    std::vector<std::vector<std::size_t>> blocks_of_; ///< of every unknown: those with its row
  };
} // namespace abut
