// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/interface_problem.h>
#include <abut/scene/decomposition_parameters.h>

#include <memory>

namespace abut
{
  /// A dense part of Z: the responses `rows` to the pressures of the multipliers `columns`. The first rows
  /// are the gap integrals of these same multipliers, in their order. Z is the sum of its blocks.
  struct ComplianceBlock
  {
    std::vector<Eigen::Index> columns, rows;
    Eigen::MatrixXd matrix;

    void serialize(Archive &archive) { archive(columns, rows, matrix); }
  };

  /// The linear map Z from pressures to responses (see InterfaceProblem).
  class InterfaceCompliance
  {
  public:
    virtual ~InterfaceCompliance() = default;
    virtual Eigen::VectorXd apply(const Eigen::VectorXd &pressures) const = 0;
    /// Z as a matrix: one block where there are two bodies, else one for every body, so that the size
    /// grows with the number of bodies and not with its square. Empty where Z is applied by solves.
    virtual const std::vector<ComplianceBlock> &blocks() const = 0;
    bool is_dense() const { return !blocks().empty(); }
  };

  /**
   * Z as a matrix, made once by a solve for every multiplier, or applied by a solve of every body each time:
   * the same iterates. `automatic` takes the matrix where it costs no more than the expected number of
   * solves, and else makes it as soon as the solves done have cost as much.
   */
  std::unique_ptr<InterfaceCompliance> make_compliance(const InterfaceProblem &problem, ComplianceMode mode,
                                                       double expected_solves);
} // namespace abut
