// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/executor.h>
#include <abut/comparison/exact_solution.h>

namespace abut
{
  struct PairResult;
  struct TrueErrors;

  /**
   * Relative errors against an exact solution, as far as it tells (iteration is part of the error, and so is
   * the penalty unless the solution has it too): energy norm of all bodies' displacement; stress in L2 over
   * the components xx, yy, zz and twice xy, all bodies; pressure sum p_i phi_i of the first pair in L2 on the
   * slave side; its contact force. Bodies are compared where they live: all processes have to call it.
   */
  TrueErrors true_errors(const ExactSolution &exact, const Scene &scene,
                         const std::vector<BodyResult> &bodies, const std::vector<PairResult> &pairs,
                         const Executor &executor);

  /// Tells the first pair its exact pressures, where the solution knows them.
  void add_exact_pressures(const ExactSolution &exact, const Scene &scene, std::vector<PairResult> &pairs);
} // namespace abut
