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

    /// kappa^2 of `bound`; empty where the estimate is not against the contact law's own pressures.
    std::optional<double> law_mismatch;

    double discretisation() const; ///< relative, energy norm, all bodies: b
    /**
     * Discretisation and iteration in one, relative, energy norm: the error of the displacement u_h against
     * the solution of the (penalised) contact problem is at most
     *   b/2 + sqrt(b^2/4 + kappa^2),   b = ||u^ - u_h||_A,   kappa^2 = int |p_h| |theta p_h + g(u_h)|,
     * with u^ the bodies' exact response to the pressure p_h that was applied, for which the better stress
     * stands. Not rigorous: that, and p_h in the place of the exact pressure where the law is violated.
     */
    std::optional<double> bound() const;
    std::optional<double> energy_bound() const; ///< not relative
    double energy_error() const;                ///< b itself, not relative
    double energy_norm() const;                 ///< of the better stress (or sigma_F), all bodies
    double stress() const;                      ///< the same in L2 over xx, yy, zz and twice xy
    double stress_error() const;                ///< not relative
    BoundaryCost boundary_cost() const;         ///< of all bodies
    /// The largest eta of the bodies that adapt; of all where none does.
    double eta_max(const Scene &scene) const;
  };

  /// Of every body's deformation and contact forces.
  Estimation estimate(const Indicator &indicator, const AdaptationParameters &parameters,
                      const std::vector<BodyResult> &bodies);

  /// Sum of ContactPair::law_mismatch of the bodies' displacements and contact forces over all pairs.
  double law_mismatch(const std::vector<const ContactPair *> &pairs, const std::vector<BodyResult> &bodies);

  /**
   * The cells to be changed, body by body: those that the marking of the scene chooses in bodies that adapt,
   * and the cells on both sides of contact that is smaller than a cell (`PairResult::missed`).
   */
  std::vector<CellMarks> mark_all(const Scene &scene, const Estimation &estimation,
                                  const std::vector<BodyResult> &bodies,
                                  const std::vector<PairResult> &pairs);
} // namespace abut
