// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bodies/finite_elements/projected_divergence.h>

#include <Eigen/LU>

#include <cmath>

namespace abut
{
  bool projects_divergence(const CellType cell_type, const double poisson_ratio)
  {
    return cell_type == CellType::quadrilaterals && poisson_ratio >= smallest_projected_ratio;
  }

  CellPolynomials::CellPolynomials(const Cell &cell, const unsigned int degree) : degree_(degree)
  {
    const auto vertex = [&](const unsigned int i) { return Vector2(cell->vertex(i)[0], cell->vertex(i)[1]); };
    centre_ = (vertex(0) + vertex(1) + vertex(2) + vertex(3)) / 4.;
    Eigen::Matrix2d axes;
    axes.col(0) = (vertex(1) + vertex(3) - vertex(0) - vertex(2)) / 4.;
    axes.col(1) = (vertex(2) + vertex(3) - vertex(0) - vertex(1)) / 4.;
    to_unit_ = axes.inverse();
  }

  Eigen::RowVectorXd CellPolynomials::values(const Vector2 &point) const
  {
    const Vector2 z = to_unit_ * (point - centre_);
    Eigen::RowVectorXd result(size());
    Eigen::Index position = 0;
    for (Eigen::Index k = 0; k <= degree_; ++k)
      for (Eigen::Index j = 0; j <= k; ++j)
        result[position++] = std::pow(z.x(), k - j) * std::pow(z.y(), j);
    return result;
  }

  Eigen::MatrixX2d CellPolynomials::gradients(const Vector2 &point) const
  {
    const Vector2 z = to_unit_ * (point - centre_);
    const auto derivative = [](const double x, const Eigen::Index power) {
      return power == 0 ? 0. : static_cast<double>(power) * std::pow(x, power - 1);
    };
    Eigen::MatrixX2d result(size(), 2);
    Eigen::Index position = 0;
    for (Eigen::Index k = 0; k <= degree_; ++k)
      for (Eigen::Index j = 0; j <= k; ++j)
        result.row(position++) << derivative(z.x(), k - j) * std::pow(z.y(), j),
            std::pow(z.x(), k - j) * derivative(z.y(), j);
    return result * to_unit_;
  }

  ProjectedDivergence::ProjectedDivergence(const CellPolynomials &polynomials,
                                           const dealii::FEValues<2> &values)
      : moments_(Eigen::MatrixXd::Zero(polynomials.size(), values.dofs_per_cell))
  {
    const auto &fe = values.get_fe();
    Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(polynomials.size(), polynomials.size());
    Eigen::RowVectorXd divergence(values.dofs_per_cell);
    for (const unsigned int q : values.quadrature_point_indices())
    {
      const auto place = values.quadrature_point(q);
      const Eigen::RowVectorXd psi = polynomials.values(Vector2(place[0], place[1]));
      for (const unsigned int i : values.dof_indices())
        divergence[i] = values.shape_grad(i, q)[fe.system_to_component_index(i).first];
      mass += values.JxW(q) * psi.transpose() * psi;
      moments_ += values.JxW(q) * psi.transpose() * divergence;
    }
    mass_.compute(mass);
  }
} // namespace abut
