// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/grid/cell_id.h>

#include <Eigen/Core>

#include <map>
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

    /// Their values on the new mesh.
    std::vector<Eigen::VectorXd> on(const dealii::DoFHandler<2> &dof_handler) const;

  private:
    using Cell = dealii::DoFHandler<2>::cell_iterator;

    /// Adds the values that a cell gets if its children are merged.
    void merge(const Cell &parent, const std::vector<Eigen::MatrixXd> &restrictions);
    /// All fields (columns) at the unknowns of a cell that was there before, or whose parent or children
    /// were.
    Eigen::MatrixXd values_in(const Cell &cell, const std::vector<Eigen::MatrixXd> &prolongations) const;

    Eigen::Index n_fields_;
    std::map<dealii::CellId, Eigen::MatrixXd> values_;
  };
} // namespace abut
