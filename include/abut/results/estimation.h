// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/adaptation/indicator.h>
#include <abut/scene/scene.h>

#include <optional>

namespace abut
{
  /// LawMismatch of all pairs, squared energy norm.
  struct ContactMismatch
  {
    double law = 0.;               ///< kappa^2
    std::vector<double> responses; ///< of every body, to what its trace does not carry
    /// Of every body, by active cell: half of the law's part at the cell's edges, and the response.
    std::vector<Eigen::VectorXd> cells;
  };

  /// What an indicator says of all bodies in one pass.
  struct Estimation
  {
    std::vector<CellErrors> errors;   ///< body by body
    std::vector<Eigen::VectorXd> eta; ///< relative_errors

    /// Of `bound`; empty where the estimate is not against the contact law's own pressures.
    std::optional<ContactMismatch> mismatch;

    std::string estimator; ///< its word in the parameter file; of several, body by body, all
    /// Estimator = automatic: why this is not the estimate of boundary elements for all bodies; empty where
    /// it is, and with other estimators.
    std::string why_uncertified;

    double discretisation() const; ///< relative, energy norm, all bodies: b
    /**
     * Squared energy norms of the errors of a body's cells, the contact's included: what marking for the
     * energy norm goes by.
     */
    Eigen::VectorXd cell_squares(std::size_t body) const;
    /**
     * What b misses in contact, relative: the root of the responses and kappa^2/4. The quarter is calibrated:
     * against exact solutions what b misses has been .3 to 1.2 kappa (convergence_estimator, BudgetStudy).
     */
    std::optional<double> contact() const;
    /**
     * Discretisation and iteration in one, energy norm: the error of the displacement u_h against the
     * solution of the (penalised) contact problem is at most
     *   T = B/2 + sqrt(B^2/4 + kappa^2),   B = ||u^ - u_h||_A,
     * with u^ the bodies' exact response to one pressure p_h and kappa^2 of LawMismatch. In every body B is
     * taken as its computed error, in which the better stress stands for the response to the traction that
     * its trace carries, plus the response to the rest of p_h. Relative to sqrt(N^2 - T^2), N the norm of
     * the better stress: ||u||_A is not below that where displacements drive the bodies (forces alone make it
     * larger than ||u_h||_A), so a response that is wrong and large does not make the error look small. 1e3
     * at most. Not rigorous: the better stress, and what LawMismatch says.
     */
    std::optional<double> bound() const;
    std::optional<double> energy_bound() const; ///< not relative: T
    double energy_error() const;                ///< b itself, not relative
    double energy_norm() const;                 ///< of the better stress (or sigma_F), all bodies
    double stress() const;                      ///< the same in L2 over xx, yy, zz and twice xy
    double stress_error() const;                ///< not relative
    BoundaryCost boundary_cost() const;         ///< of all bodies
    /// The largest eta of the bodies that adapt; of all where none does.
    double eta_max(const Scene &scene) const;
  };
} // namespace abut
