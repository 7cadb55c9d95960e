// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/processes.h>

#include <Eigen/SparseCore>

#include <memory>
#include <string>
#include <vector>

namespace abut
{
  /// Of a symmetric positive definite matrix every process has the rows of its own, one range of them after
  /// the other by rank.
  struct DistributedMatrix
  {
    using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

    std::shared_ptr<Processes> processes;
    std::vector<int> begins; ///< first row of every process; last the number of all rows
    Rows own;                ///< from the first row of this process on, all their entries

    int first() const { return begins[processes->rank()]; }
    int size() const { return begins.back(); }
  };

  /// Solves with a matrix that is spread over processes. All of them have to make it, ask it and destroy it.
  class DistributedSolver
  {
  public:
    virtual ~DistributedSolver() = default;
    /// Of right sides in columns, which are the same in all processes, and so are the solutions.
    virtual Eigen::MatrixXd solve(const Eigen::MatrixXd &right_sides) = 0;
    /// That the last right side took; 0 of a direct solver.
    virtual unsigned int iterations() const = 0;
  };

  /**
   * Conjugate gradients with algebraic multigrid by smoothed aggregation (ML of Trilinos) as preconditioner,
   * until the residual is 1e-12 of the right side. Rows 2 k and 2 k + 1 are the components of one node, rows
   * that stand for none have their diagonal alone. `near_kernel`: fields that the matrix makes almost
   * nothing of, in columns, this process's rows. `solve` throws ComputationError, beginning with `name`,
   * where `most_iterations` are not enough.
   */
  std::unique_ptr<DistributedSolver> make_multigrid_solver(DistributedMatrix matrix,
                                                           const Eigen::MatrixXd &near_kernel,
                                                           const std::string &name,
                                                           unsigned int most_iterations = 1000);

  /// A Cholesky factor that is spread over the processes (MUMPS). Throws ComputationError, beginning with
  /// `name`, when the matrix is not positive definite.
  std::unique_ptr<DistributedSolver> make_distributed_cholesky(const DistributedMatrix &matrix,
                                                               const std::string &name);
} // namespace abut
