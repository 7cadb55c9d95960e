// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/stretch_model.h>

#include <memory>
#include <vector>

namespace abut
{
  /**
   * A matrix like C that costs no solve of a body, a block for each stretch, which are taken as independent:
   * as a matrix up to some 2,000 parts, by tridiagonal solves above (see StretchModel). A preconditioner (the
   * condition of C grows with the number of nodes, that of the preconditioned one does not) and a first
   * guess.
   */
  class ModelCompliance : public PressureOperator
  {
  public:
    /// Above so many parts a stretch has no matrix.
    static constexpr Eigen::Index most_rows = 2000;

    /// The problem must outlive the object. Throws ComputationError where the numbers leave the machine's
    /// range. `largest_matrix`: in rows.
    explicit ModelCompliance(const InterfaceProblem &problem, Eigen::Index largest_matrix = most_rows);

    /// C p.
    Eigen::VectorXd respond(const Eigen::VectorXd &pressures) const override;
    /// By factorisation, or by conjugate gradients where a stretch has no matrix.
    Eigen::MatrixXd solve(const ActiveSet &active, const Eigen::MatrixXd &right_sides,
                          double accuracy) const override;

    /// Inverse of (C + theta D) on an active set, or near it where a stretch has no matrix.
    class Factor
    {
    public:
      Factor(const ModelCompliance &model, const ActiveSet &active);
      Eigen::MatrixXd solve(const Eigen::MatrixXd &right_sides) const;

    private:
      struct Block
      {
        Eigen::Index size;
        std::unique_ptr<StretchModel::Inverse> inverse;
      };
      std::vector<Block> blocks_; ///< of the stretches with active multipliers
    };

  private:
    bool is_exact() const;

    const InterfaceProblem &problem_;
    struct Block
    {
      Eigen::Index first; ///< multiplier
      std::unique_ptr<StretchModel> model;
    };
    std::vector<Block> blocks_; ///< one after the other
  };
} // namespace abut
