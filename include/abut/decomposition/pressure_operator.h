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

  class ModelCompliance;

  /// By factorisation where the compliance is a matrix: dense for one block, sparse for more. Otherwise by
  /// conjugate gradients with the model, which must outlive the operator, as preconditioner, until the
  /// compliance has become a matrix.
  std::unique_ptr<PressureOperator> make_pressure_operator(const InterfaceProblem &problem,
                                                           const InterfaceCompliance &compliance,
                                                           const ModelCompliance &model);
} // namespace abut
