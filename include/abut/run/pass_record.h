// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/run/pass.h>

namespace abut
{
  /// What a pass has found, but for its number, the seconds since the run began and what `compare_with_exact`
  /// adds. `carried`: what it started from.
  PassRecord record_pass(const Setup &setup, const PassOutcome &outcome,
                         const std::optional<CarriedState> &carried);

  /**
   * Corrects an estimate that boundary elements have not made by what came of the one before: the solution
   * has changed by no more than the error was (Galerkin's orthogonality on nested meshes), so that an
   * estimate below the change was too small, and the same indicator will be so again. The change is that of
   * the field or of the strain energy, whichever is smaller: fields that are carried to curved cells lose
   * some of the first.
   */
  void correct_by_change(const PassRecord &before, PassRecord &record);

  /// Adds true errors and the quality of the indicator; the setup knows an exact solution.
  void compare_with_exact(const Setup &setup, const PassOutcome &outcome, PassRecord &record);
} // namespace abut
