// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/plane_geometry.h>
#include <abut/bodies/finite_elements/assembly.h>
#include <abut/bodies/finite_elements/projected_divergence.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    Eigen::SparseMatrix<double> zero_matrix(const dealii::DoFHandler<2> &dof_handler)
    {
      dealii::DynamicSparsityPattern pattern(dof_handler.n_dofs(), dof_handler.n_dofs());
      dealii::DoFTools::make_sparsity_pattern(dof_handler, pattern);
      const auto n = static_cast<Index>(dof_handler.n_dofs());
      Eigen::SparseMatrix<double> matrix(n, n);
      matrix.resizeNonZeros(static_cast<Index>(pattern.n_nonzero_elements()));
      Index position = 0;
      for (Index i = 0; i < n; ++i)
      {
        matrix.outerIndexPtr()[i] = static_cast<int>(position);
        const auto row = static_cast<dealii::types::global_dof_index>(i);
        for (auto entry = pattern.begin(row); entry != pattern.end(row); ++entry)
          matrix.innerIndexPtr()[position++] = static_cast<int>(entry->column());
      }
      matrix.outerIndexPtr()[n] = static_cast<int>(position);
      matrix.coeffs().setZero();
      return matrix;
    }

    /// int lambda div u div v + 2 mu eps(u) : eps(v), the lower triangle.
    dealii::FullMatrix<double> cell_stiffness(const dealii::FEValues<2> &values, const double lambda,
                                              const double mu)
    {
      const auto &fe = values.get_fe();
      dealii::FullMatrix<double> matrix(fe.n_dofs_per_cell());
      for (const unsigned int q : values.quadrature_point_indices())
        for (const unsigned int i : values.dof_indices())
        {
          const auto grad_i = values.shape_grad(i, q);
          const unsigned int ci = fe.system_to_component_index(i).first;
          for (unsigned int j = 0; j <= i; ++j)
          {
            const auto grad_j = values.shape_grad(j, q);
            const unsigned int cj = fe.system_to_component_index(j).first;
            matrix(i, j) += (lambda * grad_i[ci] * grad_j[cj] + mu * grad_i[cj] * grad_j[ci] +
                             (ci == cj ? mu * (grad_i * grad_j) : 0.)) *
                            values.JxW(q);
          }
        }
      return matrix;
    }

    /// The same with P div in place of div.
    dealii::FullMatrix<double> projected_cell_stiffness(const Cell &cell, const dealii::FEValues<2> &values,
                                                        const double lambda, const double mu)
    {
      dealii::FullMatrix<double> matrix = cell_stiffness(values, 0., mu);
      const CellPolynomials polynomials(cell, values.get_fe().degree - 1);
      const Eigen::MatrixXd root = ProjectedDivergence(polynomials, values).root();
      const Eigen::MatrixXd volumetric = lambda * (root.transpose() * root);
      for (const unsigned int i : values.dof_indices())
        for (unsigned int j = 0; j <= i; ++j)
          matrix(i, j) += volumetric(i, j);
      return matrix;
    }
  } // namespace

  Eigen::SparseMatrix<double> assemble_stiffness(const Space &space, const CellMaterials &materials,
                                                 const bool projects)
  {
    Eigen::SparseMatrix<double> stiffness = zero_matrix(space.dof_handler());
    const auto &fe = space.dof_handler().get_fe();
    dealii::FEValues<2> values(space.mapping(), fe, space.quadrature(),
                               dealii::update_gradients | dealii::update_JxW_values |
                                   dealii::update_quadrature_points);
    std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
    for (const auto &cell : space.dof_handler().active_cell_iterators())
    {
      values.reinit(cell);
      cell->get_dof_indices(dofs);
      const double lambda = materials(cell).lambda(), mu = materials(cell).mu();
      const dealii::FullMatrix<double> matrix =
          projects ? projected_cell_stiffness(cell, values, lambda, mu) : cell_stiffness(values, lambda, mu);
      for (const unsigned int i : values.dof_indices())
        for (const unsigned int j : values.dof_indices())
          stiffness.coeffRef(static_cast<Index>(dofs[i]), static_cast<Index>(dofs[j])) +=
              i >= j ? matrix(i, j) : matrix(j, i);
    }
    return stiffness;
  }
} // namespace abut
