// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/processes.h>
#include <abut/scene/body_description.h>

#include <deal.II/grid/cell_id.h>
#include <deal.II/grid/tria.h>

#include <Eigen/Core>

#include <map>
#include <memory>

namespace abut
{
  /// A mesh without cells that processes are to share (p4est). All of them have to call it.
  std::unique_ptr<dealii::Triangulation<2>>
  shared_triangulation(const Processes &processes, dealii::Triangulation<2>::MeshSmoothing smoothing);

  /// Of a body whose mesh processes may share cells that touch differ by one level at most, also at a common
  /// vertex, as p4est has it: so that the mesh is the same where it is not shared.
  dealii::Triangulation<2>::MeshSmoothing smoothing_of(const BodyDescription &body);

  /// How often the cells of a body can be halved in both directions from larger ones that have the same
  /// vertices: not where they are graded, or follow curves.
  unsigned int n_first_splits(const BodyDescription &body);

  /// The body with cells that are to be halved so often.
  BodyDescription with_larger_cells(BodyDescription body, unsigned int n_splits);

  /// Halves all cells so often, each time giving every process as many.
  void split_all(dealii::Triangulation<2> &triangulation, unsigned int n_splits);

  using CellValues = std::map<dealii::CellId, Eigen::MatrixXd>;

  /// Gives every process as many cells, and with them their values: matrices of one size, of every own cell.
  void repartition(dealii::Triangulation<2> &triangulation, CellValues &values);
} // namespace abut
