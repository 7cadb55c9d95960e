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

  std::vector<bool> cells_of(const Processes &processes, const Space &space)
  {
    const dealii::Triangulation<2> &mesh = space.mesh().triangulation;
    std::vector<bool> own(mesh.n_active_cells(), false);
    if (space.mesh().processes)
    {
      for (const auto &cell : space.own_cells())
        own[cell->active_cell_index()] = true;
      return own;
    }
    const std::vector<unsigned int> of_cells = processes_of_cells(space, processes.size());
    for (std::size_t cell = 0; cell < own.size(); ++cell)
      own[cell] = of_cells[cell] == processes.rank();
    return own;
  }

  SharedDofs share_dofs(const Space &space, const unsigned int n_processes)
  {
    if (space.shared_dofs() != nullptr)
      return *space.shared_dofs();
    const std::vector<unsigned int> of_cells = processes_of_cells(space, n_processes);
    std::vector<unsigned int> process_of_dof(static_cast<std::size_t>(space.n_dofs()), n_processes);
    std::vector<dealii::types::global_dof_index> dofs(space.dof_handler().get_fe().n_dofs_per_cell());
    for (const auto &cell : space.dof_handler().active_cell_iterators())
    {
      cell->get_dof_indices(dofs);
      for (const auto dof : dofs)
        process_of_dof[dof] = std::min(process_of_dof[dof], of_cells[cell->active_cell_index()]);
    }
    return SharedDofs(std::move(process_of_dof), n_processes);
  }

  SharedRows::SharedRows(const SharedDofs &dofs, const Nodes &nodes,
                         const Eigen::SparseMatrix<double> &free_directions, const unsigned int n_processes)
      : dofs_(dofs), nodes_(nodes), free_directions_(free_directions)
  {
    number_rows(n_processes);
  }

  void SharedRows::number_rows(const unsigned int n_processes)
  {
    constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> node_of_dof(dofs_.size(), none);
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
        if (moves[i] && dofs_.process_of(nodes_.dofs[i][0]) == process)
        {
          next_row[i] = row;
          row += 2;
        }
    }
    begins_.push_back(row);
    for (const std::size_t node : node_of_column)
      rows_.push_back(next_row[node]++);
  }

  Eigen::MatrixXd SharedRows::rigid_motions(const unsigned int process) const
  {
    const Box box = box_around(nodes_.places);
    Eigen::MatrixXd at_dofs =
        Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(dofs_.size()), 3); // zero where others determine
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
