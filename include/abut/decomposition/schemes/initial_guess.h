// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/scheme.h>

namespace abut
{
  /// The pressures overlap_i / (k_1 + k_2 + extra_i) of elastic layers, `overlap` as below.
  Eigen::VectorXd layer_pressures(const InterfaceProblem &problem, const InterfaceProblem::Loads &loads,
                                  const Eigen::VectorXd &extra);

  /**
   * u^0 from the model of the elastic layer, where every body is a Winkler layer of compliance k_a and
   * `overlap` is the negative part of the gap under the loads alone.
   *
   * `elastic layer`, the paper's, literally: p = overlap/(k_1 + k_2), each body's contact nodes recede by k_a
   * p. The mean gaps close exactly, so that the first traction is zero, and u^0 is no field; a field with
   * these values at the nodes (the combined algorithm's) closes them but for what varies within a part.
   * `elastic layer response`: the bodies' response to p = overlap/(k_1 + k_2 + theta).
   */
  InterfaceState initial_guess(const InterfaceProblem &problem, const InterfaceCompliance &compliance,
                               const InterfaceProblem::Loads &loads, InitialGuess kind);

  /// The state whose displacement answers given pressures.
  InterfaceState respond_to(const InterfaceCompliance &compliance, const InterfaceProblem::Loads &loads,
                            const Eigen::VectorXd &pressures);
} // namespace abut
