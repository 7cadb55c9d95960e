// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/interface_motions.h>

namespace abut
{
  /// A motion, amplitudes of `motions`, in words: "Body pin: rotation about (0, 0)"; of several bodies where
  /// they move together.
  std::string words_of(const InterfaceProblem &problem, const InterfaceMotions &motions,
                       const Eigen::VectorXd &motion);

  /// Throws a UserError for loads that stay unbalanced along a motion, whose amplitudes they are.
  [[noreturn]] void refuse_motion(const InterfaceProblem &problem, const InterfaceMotions &motions,
                                  const Eigen::VectorXd &unbalanced, const std::string &why);
} // namespace abut
