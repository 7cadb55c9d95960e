// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/mesh/shared_mesh.h>

#include <deal.II/dofs/dof_handler.h>

#include <vector>

namespace abut
{
  /**
   * Fields (vectors of all unknowns) cell by cell, to be carried over to a mesh whose cells are split, or
   * merged once. Where cells disagree on a common unknown, as beside mortar edges, the new field has their
   * mean.
   */
  class CarriedFields
  {
  public:
    CarriedFields(const dealii::DoFHandler<2> &dof_handler, const std::vector<Eigen::VectorXd> &fields);

    /// Gives every process as many cells of the new mesh, and what it will have to know.
    void repartition(dealii::Triangulation<2> &triangulation);

    /// Their values on the new mesh; where processes share it, at unknowns of own cells.
    std::vector<Eigen::VectorXd> on(const dealii::DoFHandler<2> &dof_handler) const;

  private:
    using Cell = dealii::Triangulation<2>::cell_iterator;

    /// Adds the values that a cell gets if its children are merged.
    void merge(const Cell &parent);
    /// All fields (columns) at the unknowns of a cell that was there before, or whose parent or children
    /// were.
    Eigen::MatrixXd values_in(const Cell &cell) const;

    Eigen::Index n_fields_;
    std::vector<Eigen::MatrixXd> restrictions_, prolongations_; ///< by child
    CellValues values_;
  };
} // namespace abut
