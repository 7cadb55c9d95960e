// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/sparse_cholesky.h>
#include <abut/bodies/finite_elements/floating.h>

#include <vector>

namespace abut
{
  /// The free unknowns that move a contact side, in increasing order: the rows of B that are not empty.
  std::vector<int> contact_unknowns(const Eigen::SparseMatrix<double> &trace_to_free);

  /**
   * Displacements of a body's contact sides under forces there, B^T A^-1 B f, by the last columns of a factor
   * that eliminates the contact unknowns last: what A^-1 does between these is the inverse of the Schur
   * complement S on them. Of a floating body A^-1 is the generalised inverse P K~^-1 P. P spreads forces over
   * the whole body, but only their part along the rigid motions: with an orthonormal basis U of the motions
   * on the contact unknowns, I extending by zero,
   *
   *     P I = I (1 - U U^T) + H U^T,   H = P I U.
   *
   * So what the body does under the loads H is kept, one solve a motion, and the rest is in balance on the
   * contact unknowns themselves.
   */
  class ContactResponse
  {
  public:
    /**
     * Whether the contact unknowns should come last: n_contact^2 <= 100 n_free. A response then reads
     * n_contact^2 numbers instead of twice the factor's (some 14 n log2 n), and the dense columns cost
     * n_contact^3 / 3 operations more: on layers the first 10 to 50 responses make up for that
     * (contrib/benchmark-compliance), fewer than an interface problem takes.
     */
    static bool pays(std::size_t n_contact, Eigen::Index n_free);

    /// `factor` of A, or of K~, eliminates `unknowns` last and must outlive the response. `trace_to_free`: B.
    ContactResponse(const SparseCholesky &factor, const std::vector<int> &unknowns,
                    const Eigen::SparseMatrix<double> &trace_to_free, const FloatingModes &floating);

    Eigen::MatrixXd respond(const Eigen::MatrixXd &forces) const;

  private:
    void spread_motions(const std::vector<int> &unknowns, const FloatingModes &floating);
    /// I^T A^-1 I for loads on the contact unknowns.
    Eigen::MatrixXd solve(const Eigen::MatrixXd &loads) const;

    const SparseCholesky &factor_;
    Eigen::SparseMatrix<double> trace_to_contact_; ///< B without its empty rows
    Eigen::MatrixXd motions_;                      ///< U; no columns where the body does not float
    Eigen::MatrixXd spread_;                       ///< K~^-1 H on the contact unknowns
    Eigen::MatrixXd spread_work_;                  ///< H^T K~^-1 H
  };
} // namespace abut
