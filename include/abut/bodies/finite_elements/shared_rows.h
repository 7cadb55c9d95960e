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

  /// By active cell index, those of the cells that are this process's, among processes that share the mesh or
  /// else the cells of a mesh that all of them have.
  std::vector<bool> cells_of(const Processes &processes, const Space &space);

  /// An unknown belongs to the process that the mesh gives it to, or else to the one with the lowest number
  /// that has one of its cells (processes_of_cells).
  SharedDofs share_dofs(const Space &space, unsigned int n_processes);

  /**
   * The unknowns of a body's equations as rows of a DistributedMatrix, two for each node that is free to move
   * in some direction: one along each free direction, or one of them for nothing. They belong to the
   * process that has the node.
   */
  class SharedRows
  {
  public:
    /// `nodes`: those that are free to move (free_nodes). `free_directions`: T of the supports. All of them
    /// have to outlive the object.
    SharedRows(const SharedDofs &dofs, const Nodes &nodes, const Eigen::SparseMatrix<double> &free_directions,
               unsigned int n_processes);

    /// First row of every process; last the number of rows.
    const std::vector<int> &begins() const { return begins_; }
    /// Of each free unknown, a column of T.
    const std::vector<int> &rows() const { return rows_; }
    /// Two translations and the rotation at the rows of a process, in columns, of about the same size.
    Eigen::MatrixXd rigid_motions(unsigned int process) const;

  private:
    /// Whether a row is the process's.
    bool has(const unsigned int process, const int row) const
    {
      return row >= begins_[process] && row < begins_[process + 1];
    }
    void number_rows(unsigned int n_processes);

    const SharedDofs &dofs_;
    const Nodes &nodes_;
    const Eigen::SparseMatrix<double> &free_directions_;
    std::vector<int> rows_, begins_;
  };
} // namespace abut
