// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/plane_geometry.h>
#include <abut/bodies/finite_elements/shared_rows.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

namespace abut
{
  namespace
  {
    /// The place along the Z-order curve: the bits of both coordinates, a number from 0 to 1 each, by turns.
    std::uint64_t place_on_curve(const dealii::Point<2> &place)
    {
      constexpr unsigned int n_bits = 24;
      const auto x = static_cast<std::uint64_t>(std::ldexp(place[0], n_bits)),
                 y = static_cast<std::uint64_t>(std::ldexp(place[1], n_bits));
      std::uint64_t result = 0;
      for (unsigned int bit = 0; bit <= n_bits; ++bit)
        result |= ((x >> bit) & 1u) << (2 * bit + 1) | ((y >> bit) & 1u) << (2 * bit);
      return result;
    }
  } // namespace

  std::vector<unsigned int> processes_of_cells(const Space &space, const unsigned int n)
  {
    const dealii::Triangulation<2> &mesh = space.mesh().triangulation;
    const auto [corner, opposite] = dealii::GridTools::compute_bounding_box(mesh).get_boundary_points();
    const double extent = std::max(opposite[0] - corner[0], opposite[1] - corner[1]);
    std::vector<std::pair<std::uint64_t, unsigned int>> cells;
    for (const auto &cell : mesh.active_cell_iterators())
      cells.emplace_back(place_on_curve(dealii::Point<2>((cell->center() - corner) / extent)),
                         cell->active_cell_index());
    std::sort(cells.begin(), cells.end());
    std::vector<unsigned int> processes(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i)
      processes[cells[i].second] = static_cast<unsigned int>(i * n / cells.size());
    return processes;
  }

  SharedRows::SharedRows(const Space &space, const Nodes &nodes,
                         const Eigen::SparseMatrix<double> &free_directions, const unsigned int n_processes)
      : space_(space), nodes_(nodes), free_directions_(free_directions)
  {
    distribute_dofs(n_processes);
    number_rows(n_processes);
  }

  void SharedRows::distribute_dofs(const unsigned int n_processes)
  {
    const std::vector<unsigned int> of_cells = processes_of_cells(space_, n_processes);
    process_of_dof_.assign(static_cast<std::size_t>(space_.n_dofs()), n_processes);
    std::vector<dealii::types::global_dof_index> dofs(space_.dof_handler().get_fe().n_dofs_per_cell());
    for (const auto &cell : space_.dof_handler().active_cell_iterators())
    {
      cell->get_dof_indices(dofs);
      for (const auto dof : dofs)
        process_of_dof_[dof] = std::min(process_of_dof_[dof], of_cells[cell->active_cell_index()]);
    }
    dofs_.resize(n_processes);
    for (std::size_t dof = 0; dof < process_of_dof_.size(); ++dof)
      dofs_[process_of_dof_[dof]].push_back(static_cast<int>(dof));
  }

  void SharedRows::number_rows(const unsigned int n_processes)
  {
    constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> node_of_dof(process_of_dof_.size(), none);
    for (std::size_t i = 0; i < nodes_.dofs.size(); ++i)
      for (const unsigned int dof : nodes_.dofs[i])
        node_of_dof[dof] = i;

    // Of each column the node that it moves, not those that follow.
    std::vector<std::size_t> node_of_column;
    std::vector<bool> moves(nodes_.dofs.size(), false);
    for (int j = 0; j < free_directions_.cols(); ++j)
    {
      Eigen::SparseMatrix<double>::InnerIterator entry(free_directions_, j);
      while (node_of_dof[static_cast<std::size_t>(entry.row())] == none)
        ++entry;
      node_of_column.push_back(node_of_dof[static_cast<std::size_t>(entry.row())]);
      moves[node_of_column.back()] = true;
    }

    std::vector<int> next_row(nodes_.dofs.size());
    int row = 0;
    for (unsigned int process = 0; process < n_processes; ++process)
    {
      begins_.push_back(row);
      for (std::size_t i = 0; i < moves.size(); ++i)
        if (moves[i] && process_of_dof_[nodes_.dofs[i][0]] == process)
        {
          next_row[i] = row;
          row += 2;
        }
    }
    begins_.push_back(row);
    for (const std::size_t node : node_of_column)
      rows_.push_back(next_row[node]++);
  }

  std::vector<bool> SharedRows::cells_for(const unsigned int process) const
  {
    std::vector<bool> needed(process_of_dof_.size(), false);
    for (const int dof : dofs_[process])
      needed[static_cast<std::size_t>(dof)] = true;
    for (int j = 0; j < free_directions_.cols(); ++j)
      if (has(process, rows_[static_cast<std::size_t>(j)]))
        for (Eigen::SparseMatrix<double>::InnerIterator entry(free_directions_, j); entry; ++entry)
          needed[static_cast<std::size_t>(entry.row())] = true;
    std::vector<bool> cells(space_.mesh().triangulation.n_active_cells(), false);
    std::vector<dealii::types::global_dof_index> dofs(space_.dof_handler().get_fe().n_dofs_per_cell());
    for (const auto &cell : space_.dof_handler().active_cell_iterators())
    {
      cell->get_dof_indices(dofs);
      cells[cell->active_cell_index()] =
          std::any_of(dofs.begin(), dofs.end(), [&](const auto dof) { return needed[dof]; });
    }
    return cells;
  }

  Eigen::MatrixXd SharedRows::rigid_motions(const unsigned int process) const
  {
    const Box box = box_around(nodes_.places);
    Eigen::MatrixXd at_dofs = Eigen::MatrixXd::Zero(space_.n_dofs(), 3); // zero where others determine
    for (std::size_t i = 0; i < nodes_.dofs.size(); ++i)
    {
      const Vector2 arm = (nodes_.places[i] - box.middle()) / box.diagonal();
      at_dofs.row(nodes_.dofs[i][0]) << 1., 0., -arm.y();
      at_dofs.row(nodes_.dofs[i][1]) << 0., 1., arm.x();
    }
    Eigen::MatrixXd motions = Eigen::MatrixXd::Zero(begins_[process + 1] - begins_[process], 3);
    for (int j = 0; j < free_directions_.cols(); ++j)
      if (const int row = rows_[static_cast<std::size_t>(j)]; has(process, row))
        for (Eigen::SparseMatrix<double>::InnerIterator entry(free_directions_, j); entry; ++entry)
          motions.row(row - begins_[process]) += entry.value() * at_dofs.row(entry.row());
    return motions;
  }
} // namespace abut
