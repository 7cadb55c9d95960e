// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/finite_elements/space.h>
#include <abut/bodies/prescribed.h>

#include <Eigen/SparseCore>

#include <vector>

namespace abut
{
  /// For each active cell the one of n processes that it belongs to: pieces of a space-filling curve
  /// (Z-order) through the centres of all cells, with as many cells each.
  std::vector<unsigned int> processes_of_cells(const Space &space, unsigned int n);

  /**
   * The unknowns of a body's equations as rows of a DistributedMatrix, two for each node that is free to move
   * in some direction: one along each free direction, or one of them for nothing. An unknown belongs to the
   * process with the lowest number that has one of its cells.
   */
  class SharedRows
  {
  public:
    /// `nodes`: those that are free to move (free_nodes). `free_directions`: T of the supports.
    SharedRows(const Space &space, const Nodes &nodes, const Eigen::SparseMatrix<double> &free_directions,
               unsigned int n_processes);

    /// First row of every process; last the number of rows.
    const std::vector<int> &begins() const { return begins_; }
    /// Of each free unknown, a column of T.
    const std::vector<int> &rows() const { return rows_; }
    /// The unknowns of fields that belong to a process, in increasing order.
    const std::vector<int> &dofs_of(const unsigned int process) const { return dofs_[process]; }
    /// By active cell index, those that the rows and unknowns of a process need.
    std::vector<bool> cells_for(unsigned int process) const;
    /// Two translations and the rotation at the rows of a process, in columns, of about the same size.
    Eigen::MatrixXd rigid_motions(unsigned int process) const;

  private:
    /// Whether a row is the process's.
    bool has(const unsigned int process, const int row) const
    {
      return row >= begins_[process] && row < begins_[process + 1];
    }
    void distribute_dofs(unsigned int n_processes);
    void number_rows(unsigned int n_processes);

    const Space &space_;
    const Nodes &nodes_;
    const Eigen::SparseMatrix<double> &free_directions_;
    std::vector<unsigned int> process_of_dof_;
    std::vector<std::vector<int>> dofs_;
    std::vector<int> rows_, begins_;
  };
} // namespace abut
