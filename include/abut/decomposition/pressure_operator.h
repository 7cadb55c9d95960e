// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/compliance.h>

#include <memory>

namespace abut
{
  /// The multipliers that are taken as in contact, in increasing order.
  using ActiveSet = std::vector<Eigen::Index>;

  /// C + theta D as the active-set methods need it: applied, and inverted on active sets.
  class PressureOperator
  {
  public:
    virtual ~PressureOperator() = default;
    /// Z p; the first rows are C p. An operator may know no further rows.
    virtual Eigen::VectorXd respond(const Eigen::VectorXd &pressures) const = 0;
    /// The solutions x of (C + theta D)_AA x = b for right sides in columns, to a relative accuracy. Throws
    /// ComputationError where the matrix is not positive definite.
    virtual Eigen::MatrixXd solve(const ActiveSet &active, const Eigen::MatrixXd &right_sides,
                                  double accuracy) const = 0;
  };

  /// Elastic layers in place of the bodies: C = (k_1 + k_2) D.
  std::unique_ptr<PressureOperator> make_layer_operator(const InterfaceProblem &problem);

  /// The model compliance in place of C, which must outlive the operator.
  std::unique_ptr<PressureOperator> make_model_operator(const InterfaceProblem &problem,
                                                        const Eigen::MatrixXd &model);

  /// By factorisation where the compliance is a matrix: dense for one block, sparse for more. Otherwise by
  /// conjugate gradients with the model compliance, which must outlive the operator, as preconditioner.
  std::unique_ptr<PressureOperator> make_pressure_operator(const InterfaceProblem &problem,
                                                           const InterfaceCompliance &compliance,
                                                           const Eigen::MatrixXd &model);

  /// Whether the model compliance, one matrix, is worth making: not where C is in blocks of many bodies.
  inline bool suits_model(const InterfaceCompliance &compliance)
  {
    return compliance.blocks().size() <= 1;
  }

  /**
   * A matrix like C, made of the sides' places and the bodies' depths and moduli alone:
   *
   *     C_ij = D_i D_j sum_a 1/(pi E_a) log(1 + (c/r_ij)^2),   c = H/2,
   *
   * the half-planes' logarithm near by and nothing beyond the depth H of the bodies. Its symbol, that is 2/E
   * (1 - exp(-c |k|))/|k|, is positive: 2/(E |k|) of half-planes for short waves, H/E of layers for long
   * ones. Pairs are taken as independent. A preconditioner: the condition of C grows with the number of
   * nodes, that of the preconditioned one does not.
   */
  Eigen::MatrixXd model_compliance(const InterfaceProblem &problem);
} // namespace abut
