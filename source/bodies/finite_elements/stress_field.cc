// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bodies/finite_elements/stress_field.h>
#include <abut/mesh/checkerboard.h>

namespace abut
{
  namespace
  {
    using Dofs = std::vector<dealii::types::global_dof_index>;
  }

  StressField::StressField(const FiniteElementBody &body, const Eigen::VectorXd &deformation)
      : space_(body.space()), materials_(body.description()), deformation_(deformation)
  {
    if (body.projects_divergence())
      project();
  }

  void StressField::project()
  {
    dealii::FEValues<2> values(space_.mapping(), space_.dof_handler().get_fe(), space_.quadrature(),
                               dealii::update_gradients | dealii::update_JxW_values |
                                   dealii::update_quadrature_points);
    Dofs dofs(values.dofs_per_cell);
    divergence_.resize(space_.degree() * (space_.degree() + 1) / 2,
                       space_.mesh().triangulation.n_active_cells());
    for (const auto &cell : space_.dof_handler().active_cell_iterators())
    {
      values.reinit(cell);
      cell->get_dof_indices(dofs);
      divergence_.col(cell->active_cell_index()) =
          ProjectedDivergence(polynomials(cell), values).coefficients(deformation_(dofs));
    }
    if (space_.degree() == 1)
      divergence_ -= checkerboard(space_.mesh().triangulation, divergence_.transpose()).transpose();
  }

  Stress StressField::at(const Cell &cell, const Vector2 &point, const Eigen::Matrix2d &gradient) const
  {
    if (!projects())
      return materials_(cell).stress(gradient);
    return materials_(cell).stress(gradient, polynomials(cell).values(point) *
                                                 divergence_.col(cell->active_cell_index()));
  }

  Stress StressField::at(const Cell &cell, const dealii::FEValuesBase<2> &values, const unsigned int point,
                         const Dofs &dofs) const
  {
    const auto place = values.quadrature_point(point);
    return at(cell, Vector2(place[0], place[1]), gradient_at(values, point, dofs, deformation_));
  }

  Vector2 StressField::divergence_gradient(const Cell &cell, const dealii::FEValuesBase<2> &values,
                                           const unsigned int point, const Dofs &dofs) const
  {
    if (projects())
    {
      const auto place = values.quadrature_point(point);
      return polynomials(cell).gradients(Vector2(place[0], place[1])).transpose() *
             divergence_.col(cell->active_cell_index());
    }
    Vector2 gradient = Vector2::Zero();
    for (const unsigned int i : values.dof_indices())
    {
      const auto component = values.get_fe().system_to_component_index(i).first;
      const auto row = values.shape_hessian(i, point)[component];
      gradient += deformation_[static_cast<Eigen::Index>(dofs[i])] * Vector2(row[0], row[1]);
    }
    return gradient;
  }

  void StressField::visit(const dealii::Quadrature<2> &quadrature, const PointStressVisitor &visitor) const
  {
    dealii::FEValues<2> values(space_.mapping(), space_.dof_handler().get_fe(), quadrature,
                               dealii::update_gradients | dealii::update_JxW_values |
                                   dealii::update_quadrature_points);
    Dofs dofs(values.dofs_per_cell);
    for (const auto &cell : space_.own_cells())
    {
      values.reinit(cell);
      cell->get_dof_indices(dofs);
      for (const unsigned int q : values.quadrature_point_indices())
      {
        const auto place = values.quadrature_point(q);
        visitor(Vector2(place[0], place[1]), values.JxW(q), at(cell, values, q, dofs));
      }
    }
  }
} // namespace abut
