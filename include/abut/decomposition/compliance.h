// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/interface_problem.h>
#include <abut/scene/decomposition_parameters.h>

#include <memory>

namespace abut
{
  /// The linear map Z from pressures to responses (see InterfaceProblem).
  class InterfaceCompliance
  {
  public:
    virtual ~InterfaceCompliance() = default;
    virtual Eigen::VectorXd apply(const Eigen::VectorXd &pressures) const = 0;
    virtual bool is_dense() const = 0;
  };

  /**
   * Z as a matrix, made once by a solve for every multiplier, or applied by a solve of every body each time:
   * the same iterates. `automatic` takes the matrix when it costs no more solves than the expected number of
   * steps.
   */
  std::unique_ptr<InterfaceCompliance> make_compliance(const InterfaceProblem &problem, ComplianceMode mode,
                                                       double expected_steps);
} // namespace abut
