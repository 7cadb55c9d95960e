// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/scheme.h>

namespace abut
{
  /// max_a ||u_an - v_an||_2 / ||u_an||_2 over the nodes of all contact sides of each body: the paper's norm,
  /// for two responses.
  double relative_change(const InterfaceProblem &problem, const Eigen::VectorXd &u, const Eigen::VectorXd &v);

  /// What a relative error refers to: ||u||_A of the displacement that answers the pressures with this
  /// response, or the norm of that part of u which contact makes where it is smaller. A body stretched far
  /// from the contact would else make any error of the contact look small.
  double reference_norm(const InterfaceProblem &problem, const InterfaceProblem::Loads &loads,
                        const Eigen::VectorXd &pressures, const Eigen::VectorXd &response);

  /// What a step tells of a state with these pressures; `increment` and `bound` as in StepRecord.
  StepRecord step_record(const InterfaceProblem &problem, unsigned int step, double increment, double bound,
                         const Eigen::VectorXd &pressures);
} // namespace abut
