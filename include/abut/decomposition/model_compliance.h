// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/dense_cholesky.h>
#include <abut/decomposition/pressure_operator.h>

#include <vector>

namespace abut
{
  /**
   * A matrix like C, made of the sides' places and the bodies' depths and moduli alone:
   *
   *     C_ij = sum_a D_ia D_ja 1/(pi E_a) log(1 + (c_a/r_ij)^2),   c_a = H_a/2,
   *
   * the half-planes' logarithm near by and nothing beyond the depths H_a of the bodies. The symbol of a body
   * is 2/E_a (1 - exp(-c_a |k|))/|k| > 0: 2/(E_a |k|), a half-plane's, for short waves, H_a/E_a, a layer's,
   * for long ones. D_ia is what part i presses of body a. Stretches are taken as independent,
   * a block for each. A preconditioner (the condition of C
   * grows with the number of nodes, that of the preconditioned one does not) and a first guess; costs no
   * solve of a body.
   */
  class ModelCompliance : public PressureOperator
  {
  public:
    /// The problem must outlive the object. Throws ComputationError where the numbers leave the machine's
    /// range.
    explicit ModelCompliance(const InterfaceProblem &problem);

    /// C p.
    Eigen::VectorXd respond(const Eigen::VectorXd &pressures) const override;
    Eigen::MatrixXd solve(const ActiveSet &active, const Eigen::MatrixXd &right_sides,
                          double accuracy) const override;

    /// (C + theta D) on an active set, factorised.
    class Factor
    {
    public:
      Factor(const ModelCompliance &model, const ActiveSet &active);
      Eigen::MatrixXd solve(const Eigen::MatrixXd &right_sides) const;

    private:
      std::vector<DenseCholesky> blocks_; ///< of the stretches with active multipliers
    };

  private:
    const InterfaceProblem &problem_;
    struct Block
    {
      Eigen::Index first; ///< multiplier
      Eigen::MatrixXd matrix;
    };
    std::vector<Block> blocks_; ///< one after the other
  };
} // namespace abut
