// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/lagrange_basis.h>

#include <deal.II/base/exceptions.h>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <stdexcept>

namespace abut
{
  namespace
  {
    /**
     * Gauss rule of the Jacobi weight (1 - x^2)^a on [-1, 1], a = 0 or 1, by Golub and Welsch
     * [GolubWelsch1969]: the points are the eigenvalues of the symmetric tridiagonal matrix of the three-term
     * recurrence.
     */
    struct JacobiRule
    {
      JacobiRule(const Eigen::Index n, const double a)
      {
        Eigen::VectorXd off_diagonal(std::max<Eigen::Index>(n - 1, 0));
        for (Eigen::Index i = 0; i < n - 1; ++i)
        {
          const double k = static_cast<double>(i) + 1.;
          off_diagonal[i] = std::sqrt(k * (k + 2. * a) / ((2. * k + 2. * a + 1.) * (2. * k + 2. * a - 1.)));
        }
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
        solver.computeFromTridiagonal(Eigen::VectorXd::Zero(n), off_diagonal);
        points = solver.eigenvalues();
        first_components = solver.eigenvectors().row(0).transpose();
      }
      Eigen::VectorXd points;
      Eigen::VectorXd first_components;
    };
  } // namespace

  GaussRule::GaussRule(const unsigned int n_points)
  {
    Assert(n_points > 0, dealii::ExcMessage("a rule has points"));
    const JacobiRule rule(n_points, 0.);
    points = (rule.points.array() + 1.) / 2.;
    weights = rule.first_components.array().square();
  }

  GaussRule GaussRule::for_singular_ends(const unsigned int n_points)
  {
    const double pi = std::acos(-1.);
    GaussRule rule(n_points);
    const Eigen::ArrayXd angles = pi * rule.points.array();
    rule.points = (angles / 2.).sin().square();
    rule.weights = rule.weights.array() * pi / 2. * angles.sin();
    return rule;
  }

  LagrangeBasis::LagrangeBasis(const unsigned int degree)
      : nodes_(degree + 1), scaling_(Eigen::VectorXd::Ones(degree + 1))
  {
    if (degree < 1 || degree > 12)
      throw std::invalid_argument("LagrangeBasis: degree must be 1 to 12");
    nodes_[0] = 0.;
    nodes_[degree] = 1.;
    if (degree > 1) // the inner Gauss-Lobatto points are the zeros of the Legendre polynomial's derivative
      nodes_.segment(1, degree - 1) = (JacobiRule(degree - 1, 1.).points.array() + 1.) / 2.;
    if (degree % 2 == 0)
      nodes_[degree / 2] = .5;
    for (unsigned int i = 0; i <= degree; ++i)
      for (unsigned int j = 0; j <= degree; ++j)
        if (i != j)
          scaling_[i] /= nodes_[i] - nodes_[j];
  }

  Eigen::VectorXd LagrangeBasis::values(const double s) const
  {
    Eigen::VectorXd result = scaling_;
    for (Eigen::Index i = 0; i < result.size(); ++i)
      for (Eigen::Index j = 0; j < result.size(); ++j)
        if (i != j)
          result[i] *= s - nodes_[j];
    return result;
  }

  Eigen::VectorXd LagrangeBasis::integrals() const
  {
    const GaussRule rule(degree() + 1);
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(nodes_.size());
    for (Eigen::Index q = 0; q < rule.points.size(); ++q)
      sum += rule.weights[q] * values(rule.points[q]);
    return sum;
  }

  Eigen::VectorXd LagrangeBasis::derivatives(const double s) const
  {
    const Eigen::Index n = nodes_.size();
    Eigen::VectorXd result = Eigen::VectorXd::Zero(n);
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index left_out = 0; left_out < n; ++left_out)
        if (left_out != i)
        {
          double product = scaling_[i];
          for (Eigen::Index j = 0; j < n; ++j)
            if (j != i && j != left_out)
              product *= s - nodes_[j];
          result[i] += product;
        }
    return result;
  }
} // namespace abut
