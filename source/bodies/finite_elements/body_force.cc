// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bodies/finite_elements/body_force.h>
#include <abut/bodies/finite_elements/projected_divergence.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>

namespace abut
{
  Vector2 body_force(const BodyDescription &body, const Vector2 &point)
  {
    if (body.body_force.empty())
      return Vector2::Zero();
    const Vector2 own = body.placement.point_to_own(point);
    return body.placement.direction_to_world(Vector2(body.body_force[0](own), body.body_force[1](own)));
  }

  namespace
  {
    using Index = Eigen::Index;

    bool is_uniform(const BodyDescription &body)
    {
      return std::all_of(body.body_force.begin(), body.body_force.end(),
                         [](const Expression &expression) { return expression.is_constant(); });
    }

    /// A rule in each of the n^2 triangles that lines parallel to its sides make of the reference triangle.
    dealii::Quadrature<2> iterated_on_triangle(const dealii::Quadrature<2> &rule, const unsigned int n)
    {
      std::vector<dealii::Point<2>> points;
      std::vector<double> weights;
      const double size = 1. / n;
      for (unsigned int row = 0; row < n; ++row)
        for (unsigned int column = 0; row + column < n; ++column)
          for (const bool is_turned : {false, true})
          {
            if (is_turned && row + column + 1 == n)
              continue;
            const dealii::Point<2> corner =
                is_turned ? dealii::Point<2>(column + 1., row + 1.) : dealii::Point<2>(column, row);
            for (unsigned int q = 0; q < rule.size(); ++q)
            {
              const dealii::Tensor<1, 2> from_corner = (is_turned ? -1. : 1.) * rule.point(q);
              points.push_back(size * (corner + from_corner));
              weights.push_back(size * size * rule.weight(q));
            }
          }
      return {points, weights};
    }

    /// FEValues of rules that see what is narrow beside the body in cells of any size.
    class SampledCells
    {
    public:
      SampledCells(const Space &space, const BodyDescription &body) : space_(space)
      {
        if (is_uniform(body))
          return;
        double largest = 0.;
        const auto &triangulation = space.mesh().triangulation;
        const dealii::Point<2> origin = triangulation.begin()->vertex(0);
        for (const auto &cell : triangulation.cell_iterators_on_level(0)) // which all processes know
          for (const unsigned int v : cell->vertex_indices())
            largest = std::max(largest, cell->vertex(v).distance(origin));
        spacing_ = largest / n_points_;
      }

      const dealii::FEValues<2> &reinit(const Cell &cell)
      {
        const double per_side = static_cast<double>(space_.degree() + 1);
        unsigned int n = 1;
        while (n * per_side * spacing_ < cell->diameter())
          n *= 2;
        auto &values = values_[n];
        if (values == nullptr)
          values = std::make_unique<dealii::FEValues<2>>(
              space_.mapping(), space_.dof_handler().get_fe(), rule(n),
              dealii::update_values | dealii::update_JxW_values | dealii::update_quadrature_points);
        values->reinit(cell);
        return *values;
      }

    private:
      dealii::Quadrature<2> rule(const unsigned int n) const
      {
        if (n == 1)
          return space_.quadrature();
        if (space_.mesh().cell_type == CellType::triangles)
          return iterated_on_triangle(space_.quadrature(), n);
        return dealii::QIterated<2>(dealii::QGauss<1>(space_.degree() + 1), n);
      }

      static constexpr double n_points_ = 500.; ///< along the body
      const Space &space_;
      double spacing_ = std::numeric_limits<double>::infinity();
      std::map<unsigned int, std::unique_ptr<dealii::FEValues<2>>> values_; ///< by pieces along a cell
    };

    Vector2 place_of(const dealii::FEValues<2> &values, const unsigned int q)
    {
      return {values.quadrature_point(q)[0], values.quadrature_point(q)[1]};
    }

    void add_cell_force(const dealii::FEValues<2> &values, const BodyDescription &body,
                        const std::vector<dealii::types::global_dof_index> &dofs, Eigen::VectorXd &load)
    {
      const auto &fe = values.get_fe();
      for (const unsigned int q : values.quadrature_point_indices())
      {
        const Vector2 force = values.JxW(q) * body_force(body, place_of(values, q));
        for (const unsigned int i : values.dof_indices())
          load[static_cast<Index>(dofs[i])] +=
              force[fe.system_to_component_index(i).first] * values.shape_value(i, q);
      }
    }

    double cell_oscillation(const Cell &cell, const dealii::FEValues<2> &values, const BodyDescription &body)
    {
      const CellPolynomials polynomials(cell, values.get_fe().degree - 1);
      const Index n = values.n_quadrature_points;
      Eigen::MatrixXd basis(n, polynomials.size());
      Eigen::MatrixX2d force(n, 2);
      for (const unsigned int q : values.quadrature_point_indices())
      {
        const double root = std::sqrt(values.JxW(q));
        basis.row(q) = root * polynomials.values(place_of(values, q));
        force.row(q) = root * body_force(body, place_of(values, q)).transpose();
      }
      const Eigen::MatrixX2d coefficients =
          (basis.transpose() * basis).ldlt().solve(basis.transpose() * force);
      return (force - basis * coefficients).squaredNorm();
    }
  } // namespace

  void add_body_force(const Space &space, const BodyDescription &body, Eigen::VectorXd &load)
  {
    if (body.body_force.empty())
      return;
    SampledCells sampled(space, body);
    std::vector<dealii::types::global_dof_index> dofs(space.dof_handler().get_fe().n_dofs_per_cell());
    Eigen::VectorXd of_cells = Eigen::VectorXd::Zero(load.size());
    for (const auto &cell : space.own_cells())
    {
      cell->get_dof_indices(dofs);
      add_cell_force(sampled.reinit(cell), body, dofs, of_cells);
    }
    load += space.sum(of_cells);
  }

  Eigen::VectorXd body_force_oscillation(const Space &space, const BodyDescription &body)
  {
    if (is_uniform(body))
      return {};
    SampledCells sampled(space, body);
    std::vector<double> own;
    for (const auto &cell : space.own_cells())
      own.push_back(cell_oscillation(cell, sampled.reinit(cell), body));
    const std::vector<double> squares = space.gathered(std::move(own));
    return Eigen::VectorXd::Map(squares.data(), static_cast<Index>(squares.size()));
  }
} // namespace abut
