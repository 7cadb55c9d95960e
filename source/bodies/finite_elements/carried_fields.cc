// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bodies/finite_elements/carried_fields.h>
#include <abut/mesh/own_cells.h>

#include <deal.II/fe/fe.h>
#include <deal.II/lac/full_matrix.h>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    Eigen::MatrixXd to_eigen(const dealii::FullMatrix<double> &matrix)
    {
      Eigen::MatrixXd result(matrix.m(), matrix.n());
      for (Index i = 0; i < result.rows(); ++i)
        for (Index j = 0; j < result.cols(); ++j)
          result(i, j) = matrix(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
      return result;
    }
  } // namespace

  CarriedFields::CarriedFields(const dealii::DoFHandler<2> &dof_handler,
                               const std::vector<Eigen::VectorXd> &fields)
      : n_fields_(static_cast<Index>(fields.size()))
  {
    const dealii::FiniteElement<2> &element = dof_handler.get_fe();
    for (unsigned int child = 0; child < 4; ++child)
    {
      restrictions_.push_back(to_eigen(element.get_restriction_matrix(child)));
      prolongations_.push_back(to_eigen(element.get_prolongation_matrix(child)));
    }
    std::vector<dealii::types::global_dof_index> dofs(element.n_dofs_per_cell());
    for (const auto &cell : own_cells(dof_handler))
    {
      cell->get_dof_indices(dofs);
      Eigen::MatrixXd values(static_cast<Index>(dofs.size()), n_fields_);
      for (Index field = 0; field < n_fields_; ++field)
        values.col(field) = fields[static_cast<std::size_t>(field)](dofs);
      values_.emplace(cell->id(), std::move(values));
    }
    for (const auto &cell : own_cells(dof_handler))
      if (cell->level() > 0)
        merge(cell->parent());
  }

  void CarriedFields::merge(const Cell &parent)
  {
    const auto [place, is_new] = values_.emplace(parent->id(), Eigen::MatrixXd());
    if (!is_new)
      return;
    place->second = Eigen::MatrixXd::Zero(restrictions_[0].rows(), n_fields_);
    for (unsigned int child = 0; child < parent->n_children(); ++child)
    {
      const auto of_child = values_.find(parent->child(child)->id());
      if (of_child == values_.end()) // it has children itself, and stays
        continue;
      const Eigen::MatrixXd &restriction = restrictions_[child];
      for (Index i = 0; i < restriction.rows(); ++i)
        if (!restriction.row(i).isZero(0.)) // the child has the node
          place->second.row(i) = restriction.row(i) * of_child->second;
    }
  }

  Eigen::MatrixXd CarriedFields::values_in(const Cell &cell) const
  {
    if (const auto own = values_.find(cell->id()); own != values_.end())
      return own->second;
    unsigned int child = 0;
    while (cell->parent()->child(child) != cell)
      ++child;
    return prolongations_[child] * values_in(cell->parent());
  }

  void CarriedFields::repartition(dealii::Triangulation<2> &triangulation)
  {
    CellValues values;
    for (const auto &cell : own_cells(triangulation))
      values.emplace(cell->id(), values_in(cell));
    values_ = std::move(values);
    abut::repartition(triangulation, values_);
  }

  std::vector<Eigen::VectorXd> CarriedFields::on(const dealii::DoFHandler<2> &dof_handler) const
  {
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(dof_handler.n_dofs(), n_fields_);
    Eigen::VectorXd counts = Eigen::VectorXd::Zero(dof_handler.n_dofs());
    std::vector<dealii::types::global_dof_index> dofs(dof_handler.get_fe().n_dofs_per_cell());
    for (const auto &cell : own_cells(dof_handler))
    {
      cell->get_dof_indices(dofs);
      sums(dofs, Eigen::all) += values_in(cell);
      counts(dofs).array() += 1.;
    }
    std::vector<Eigen::VectorXd> fields;
    for (Index field = 0; field < n_fields_; ++field)
      fields.push_back(sums.col(field).cwiseQuotient(counts));
    return fields;
  }
} // namespace abut
