// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/finite_elements/space.h>

#include <Eigen/Cholesky>

namespace abut
{
  /**
   * Whether the volumetric term of a body takes the projection P div u in place of div u: quadrilaterals from
   * nu = .4 on. Without it nu -> .5 imposes div u = 0 at every quadrature point, more constraints than the
   * elements can bear: they lock, and their pressure oscillates. Below .4 the errors without it are less than
   * twice those at nu = .3.
   */
  constexpr double smallest_projected_ratio = .4;
  bool projects_divergence(CellType cell_type, double poisson_ratio);

  /**
   * A basis of the polynomials of degree k in the coordinates of the plane: monomials in affine coordinates
   * in which the cell is about [-1, 1]^2. Polynomials of the reference cell's coordinates would lose an order
   * on distorted cells [Arnold2002].
   */
  class CellPolynomials
  {
  public:
    CellPolynomials(const Cell &cell, unsigned int degree);

    Eigen::Index size() const { return (degree_ + 1) * (degree_ + 2) / 2; }
    Eigen::RowVectorXd values(const Vector2 &point) const;
    /// A row for every polynomial. Per length.
    Eigen::MatrixX2d gradients(const Vector2 &point) const;

  private:
    Vector2 centre_;
    Eigen::Matrix2d to_unit_; // from the plane, about the centre
    Eigen::Index degree_;
  };

  /**
   * The L2 projection P div u on a quadrilateral onto the polynomials of degree p - 1, p the degree of u.
   * With lambda P div u as the pressure this is the mixed method Q_p/P_(p-1) [MalkusHughes1978],
   * [Boffi2013, section 8.6], stable for p >= 2; Q1/P0 is used for p = 1.
   */
  class ProjectedDivergence
  {
  public:
    /// `values` have to show shape gradients, weights and points of the cell in a rule as Space::quadrature.
    ProjectedDivergence(const CellPolynomials &polynomials, const dealii::FEValues<2> &values);

    /// G with |G u|^2 = int (P div u)^2, u the unknowns of the cell.
    Eigen::MatrixXd root() const { return mass_.matrixL().solve(moments_); }
    /// P div u in the basis of the polynomials.
    Eigen::VectorXd coefficients(const Eigen::VectorXd &unknowns) const
    {
      return mass_.solve(moments_ * unknowns);
    }

  private:
    Eigen::LLT<Eigen::MatrixXd> mass_;
    Eigen::MatrixXd moments_; ///< int psi_k div phi_i
  };
} // namespace abut
