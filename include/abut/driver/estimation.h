// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/adaptation/indicator.h>
#include <abut/adaptation/marking.h>
#include <abut/decomposition/interface_problem.h>
#include <abut/report/results.h>

namespace abut
{
  /// What an indicator says of all bodies in one pass.
  struct Estimation
  {
    std::vector<CellErrors> errors;   ///< body by body
    std::vector<Eigen::VectorXd> eta; ///< relative_errors

    double discretisation() const; ///< relative, energy norm, all bodies
    double stress() const;         ///< the same in L2 over xx, yy, zz and twice xy
    double stress_error() const;   ///< not relative
    /// The largest eta of the bodies that adapt; of all where none does.
    double eta_max(const Scene &scene) const;
  };

  /// Of every body's deformation and contact forces.
  Estimation estimate(const Indicator &indicator, const AdaptationParameters &parameters,
                      const std::vector<BodyResult> &bodies);

  /**
   * The cells to be changed, body by body: those that the marking of the scene chooses in bodies that adapt,
   * and the cells on both sides of contact that is smaller than a cell (`PairResult::missed`).
   */
  std::vector<CellMarks> mark_all(const Scene &scene, const Estimation &estimation,
                                  const std::vector<BodyResult> &bodies,
                                  const std::vector<PairResult> &pairs);
} // namespace abut
