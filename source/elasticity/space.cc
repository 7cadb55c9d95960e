// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/elasticity/space.h>
#include <abut/trace/make_trace.h>
#include <abut/user_error.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/fe_values.h>

namespace abut
{
  namespace
  {
    constexpr unsigned int curve_degree = 4;

    std::unique_ptr<dealii::FiniteElement<2>> scalar_element(const CellType type, const unsigned int degree)
    {
      if (type == CellType::triangles)
        return std::make_unique<dealii::FE_SimplexP<2>>(degree);
      return std::make_unique<dealii::FE_Q<2>>(degree);
    }
  } // namespace

  Space::Space(std::unique_ptr<BodyMesh> mesh, const unsigned int degree)
      : mesh_(std::move(mesh)), mapping_(mesh_->mapping(mesh_->curved ? degree : 1)),
        dof_handler_(mesh_->triangulation)
  {
    if (mesh_->cell_type == CellType::triangles && degree > 2)
      throw UserError("Body " + mesh_->name + "/Degree: degree " + std::to_string(degree) +
                      " refused for triangles, allowed are 1 and 2");
    if (mesh_->cell_type == CellType::triangles)
      quadrature_ = dealii::QGaussSimplex<2>(degree + 1);
    else
      quadrature_ = dealii::QGauss<2>(degree + 1);
    dof_handler_.distribute_dofs(dealii::FESystem<2>(*scalar_element(mesh_->cell_type, degree), 2));
  }

  Space::~Space() = default;

  Trace Space::trace(const dealii::types::boundary_id boundary) const
  {
    const unsigned int degree = mesh_->curved ? curve_degree : 1;
    return make_trace(dof_handler_, *mesh_->mapping(degree), degree, boundary);
  }

  void visit_gradients(const Space &space, const dealii::Quadrature<2> &quadrature,
                       const Eigen::VectorXd &displacement, const GradientVisitor &visitor)
  {
    dealii::FEValues<2> values(space.mapping(), space.dof_handler().get_fe(), quadrature,
                               dealii::update_values | dealii::update_gradients | dealii::update_JxW_values |
                                   dealii::update_quadrature_points);
    const auto &fe = space.dof_handler().get_fe();
    std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
    for (const auto &cell : space.dof_handler().active_cell_iterators())
    {
      values.reinit(cell);
      cell->get_dof_indices(dofs);
      for (const unsigned int q : values.quadrature_point_indices())
      {
        Vector2 u = Vector2::Zero();
        Eigen::Matrix2d gradient = Eigen::Matrix2d::Zero();
        for (const unsigned int i : values.dof_indices())
        {
          const double coefficient = displacement[static_cast<Eigen::Index>(dofs[i])];
          const auto component = fe.system_to_component_index(i).first;
          const auto shape_gradient = values.shape_grad(i, q);
          u[component] += coefficient * values.shape_value(i, q);
          gradient.row(component) += coefficient * Eigen::RowVector2d(shape_gradient[0], shape_gradient[1]);
        }
        const auto p = values.quadrature_point(q);
        visitor(Vector2(p[0], p[1]), values.JxW(q), u, gradient);
      }
    }
  }
} // namespace abut
