// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bodies/finite_elements/assembly.h>
#include <abut/bodies/finite_elements/projected_divergence.h>

#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    bool is_among(const std::vector<bool> &cells, const Cell &cell)
    {
      return cells.empty() || cells[cell->active_cell_index()];
    }

    /// The unknowns of some cells; none: of all.
    dealii::IndexSet rows_of(const dealii::DoFHandler<2> &dof_handler, const std::vector<bool> &cells)
    {
      if (cells.empty())
        return {};
      std::vector<bool> is_there(dof_handler.n_dofs(), false);
      std::vector<dealii::types::global_dof_index> dofs(dof_handler.get_fe().n_dofs_per_cell());
      for (const auto &cell : own_cells(dof_handler))
        if (is_among(cells, cell))
        {
          cell->get_dof_indices(dofs);
          for (const auto dof : dofs)
            is_there[dof] = true;
        }
      dealii::IndexSet rows(dof_handler.n_dofs());
      for (dealii::types::global_dof_index begin = 0, end = 0; begin < is_there.size(); begin = end)
      {
        while (end < is_there.size() && is_there[end] == is_there[begin])
          ++end;
        if (is_there[begin])
          rows.add_range(begin, end);
      }
      return rows;
    }

    dealii::DynamicSparsityPattern pattern_of(const dealii::DoFHandler<2> &dof_handler,
                                              const std::vector<bool> &cells)
    {
      dealii::DynamicSparsityPattern pattern(dof_handler.n_dofs(), dof_handler.n_dofs(),
                                             rows_of(dof_handler, cells));
      std::vector<dealii::types::global_dof_index> dofs(dof_handler.get_fe().n_dofs_per_cell());
      for (const auto &cell : own_cells(dof_handler))
      {
        if (!is_among(cells, cell))
          continue;
        cell->get_dof_indices(dofs);
        std::sort(dofs.begin(), dofs.end());
        for (const auto dof : dofs)
          pattern.add_entries(dof, dofs.begin(), dofs.end(), true);
      }
      return pattern;
    }

    Eigen::SparseMatrix<double> zero_matrix(const dealii::DoFHandler<2> &dof_handler,
                                            const std::vector<bool> &cells)
    {
      const dealii::DynamicSparsityPattern pattern = pattern_of(dof_handler, cells);
      const auto n = static_cast<Index>(dof_handler.n_dofs());
      Eigen::SparseMatrix<double> matrix(n, n);
      matrix.resizeNonZeros(static_cast<Index>(pattern.n_nonzero_elements()));
      Index position = 0;
      for (Index i = 0; i < n; ++i)
      {
        matrix.outerIndexPtr()[i] = static_cast<int>(position);
        const auto row = static_cast<dealii::types::global_dof_index>(i);
        if (pattern.row_length(row) == 0)
          continue;
        for (auto entry = pattern.begin(row); entry != pattern.end(row); ++entry)
          matrix.innerIndexPtr()[position++] = static_cast<int>(entry->column());
      }
      matrix.outerIndexPtr()[n] = static_cast<int>(position);
      matrix.coeffs().setZero();
      return matrix;
    }

    /**
     * int lambda div u div v + 2 mu eps(u) : eps(v) on one cell after the other. With X, Y the derivatives of
     * the scalar shape functions at the quadrature points, times the roots of the weights, the blocks of the
     * two components are xx: (lambda + 2 mu) X X^T + mu Y Y^T,   yy: (lambda + 2 mu) Y Y^T + mu X X^T, xy:
     * lambda X Y^T + mu Y X^T.
     */
    class CellStiffness
    {
    public:
      explicit CellStiffness(const dealii::FiniteElement<2> &element)
          : matrix_(element.n_dofs_per_cell(), element.n_dofs_per_cell())
      {
        for (std::size_t component = 0; component < 2; ++component)
          for (unsigned int i = 0; i < element.base_element(0).n_dofs_per_cell(); ++i)
            dofs_[component].push_back(
                element.component_to_system_index(static_cast<unsigned int>(component), i));
      }

      const Eigen::MatrixXd &compute(const dealii::FEValues<2> &values, const double lambda, const double mu)
      {
        const auto n = static_cast<Index>(dofs_[0].size());
        x_.resize(n, values.n_quadrature_points);
        y_.resize(n, values.n_quadrature_points);
        for (const unsigned int q : values.quadrature_point_indices())
        {
          const double root = std::sqrt(values.JxW(q));
          for (Index i = 0; i < n; ++i)
          {
            const auto gradient = values.shape_grad(dofs_[0][static_cast<std::size_t>(i)], q);
            x_(i, q) = root * gradient[0];
            y_(i, q) = root * gradient[1];
          }
        }
        const Eigen::MatrixXd xx = x_ * x_.transpose(), yy = y_ * y_.transpose(), xy = x_ * y_.transpose();
        matrix_(dofs_[0], dofs_[0]) = (lambda + 2. * mu) * xx + mu * yy;
        matrix_(dofs_[1], dofs_[1]) = (lambda + 2. * mu) * yy + mu * xx;
        matrix_(dofs_[0], dofs_[1]) = lambda * xy + mu * xy.transpose();
        matrix_(dofs_[1], dofs_[0]) = matrix_(dofs_[0], dofs_[1]).transpose();
        return matrix_;
      }

    private:
      std::array<std::vector<unsigned int>, 2> dofs_; ///< of each component, by scalar shape function
      Eigen::MatrixXd x_, y_, matrix_;
    };

    /// lambda int (P div u) (P div v).
    Eigen::MatrixXd projected_volumetric_stiffness(const Cell &cell, const dealii::FEValues<2> &values,
                                                   const double lambda)
    {
      const CellPolynomials polynomials(cell, values.get_fe().degree - 1);
      const Eigen::MatrixXd root = ProjectedDivergence(polynomials, values).root();
      return lambda * (root.transpose() * root);
    }

    /// Adds a cell's matrix: the columns of each row in their order, as the pattern has them.
    class Scatter
    {
    public:
      explicit Scatter(Eigen::SparseMatrix<double> &matrix) : matrix_(matrix) {}

      void add(const std::vector<dealii::types::global_dof_index> &dofs, const Eigen::MatrixXd &cell)
      {
        order_.resize(dofs.size());
        std::iota(order_.begin(), order_.end(), 0u);
        std::sort(order_.begin(), order_.end(),
                  [&](const unsigned int i, const unsigned int j) { return dofs[i] < dofs[j]; });
        for (std::size_t j = 0; j < dofs.size(); ++j)
        {
          Index position = matrix_.outerIndexPtr()[dofs[j]];
          for (const unsigned int i : order_)
          {
            while (matrix_.innerIndexPtr()[position] < static_cast<int>(dofs[i]))
              ++position;
            matrix_.valuePtr()[position] += cell(i, static_cast<Index>(j));
          }
        }
      }

    private:
      Eigen::SparseMatrix<double> &matrix_;
      std::vector<unsigned int> order_;
    };
  } // namespace

  Eigen::SparseMatrix<double> assemble_stiffness(const Space &space, const CellMaterials &materials,
                                                 const bool projects, const std::vector<bool> &cells)
  {
    Assert(cells.empty() || cells.size() == space.mesh().triangulation.n_active_cells(),
           dealii::ExcMessage("all cells, or which ones"));
    Eigen::SparseMatrix<double> stiffness = zero_matrix(space.dof_handler(), cells);
    const auto &fe = space.dof_handler().get_fe();
    const auto places = projects ? dealii::update_quadrature_points : dealii::update_default;
    dealii::FEValues<2> values(space.mapping(), fe, space.quadrature(),
                               dealii::update_gradients | dealii::update_JxW_values | places);
    CellStiffness cell_stiffness(fe);
    Scatter scatter(stiffness);
    std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
    for (const auto &cell : space.own_cells())
    {
      if (!is_among(cells, cell))
        continue;
      values.reinit(cell);
      cell->get_dof_indices(dofs);
      const double lambda = materials(cell).lambda(), mu = materials(cell).mu();
      if (projects)
        scatter.add(dofs, cell_stiffness.compute(values, 0., mu) +
                              projected_volumetric_stiffness(cell, values, lambda));
      else
        scatter.add(dofs, cell_stiffness.compute(values, lambda, mu));
    }
    return stiffness;
  }
} // namespace abut
