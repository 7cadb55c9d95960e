// SPDX-License-Identifier: LGPL-2.1-or-later
// Boundary operators of plane strain against the real kernels and against what exact fields satisfy.
#include <abut/base/lagrange_basis.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "bem_testing.h"
#include <cmath>
#include <string>

using namespace abut;

namespace
{
  /// A boundary with the operators on all Legendre polynomials and all continuous fields of a degree.
  struct Boundary
  {
    Boundary(const Elements &boundary, const unsigned int density_degree, const double poisson_ratio,
             const GalerkinRule &rule = GalerkinRule::precise())
        : elements(boundary), degree(density_degree),
          operators(kernel_matrices(elements, degree, rule), poisson_ratio),
          tractions(all_polynomials(elements, degree)), displacements(continuous_fields(elements, degree))
    {}

    /// |V t - (M/2 + K) u| / |M u|: on thin bodies V t is a small difference.
    double first_residual(const LegendreBasis &t, const DisplacementBasis &u) const
    {
      const Eigen::VectorXd mass = operators.mass(tractions, u.values),
                            residual = operators.single_layer(tractions, t) - .5 * mass -
                                       operators.double_layer(tractions, u);
      return residual.norm() / mass.norm();
    }
    /// |W u - (M^T/2 - K^T) t| / |M^T t|
    double second_residual(const LegendreBasis &t, const DisplacementBasis &u) const
    {
      const Eigen::VectorXd mass = operators.mass(displacements.values, t),
                            residual = operators.hypersingular(displacements, u) - .5 * mass +
                                       operators.double_layer(t, displacements).transpose();
      return residual.norm() / mass.norm();
    }

    Elements elements;
    unsigned int degree;
    LayerOperators operators;
    LegendreBasis tractions;
    DisplacementBasis displacements;
  };

  struct Shape
  {
    std::string name;
    Elements elements;
  };

  std::vector<Shape> shapes()
  {
    return {{"rectangle", rectangle(equal_parts(3))},
            {"thin rectangle", rectangle(equal_parts(4), .01)},
            {"thinner rectangle", rectangle(equal_parts(4), 1e-6)},
            {"L", l_shape(equal_parts(3))},
            {"rectangle with hole", rectangle_with_hole(3)},
            {"graded by 1e4", rectangle(graded_parts(15, 3.8))},
            {"circle", circle(20, .5)}};
  }

  /// U_ij, T_ij and S_kij of the Kelvin solution, x the source, G = 1 (Sutradhar, Paulino & Gray, ch. 4).
  struct Kelvin
  {
    Kelvin(const Complex w, const Complex normal, const double nu)
    {
      const double r = std::abs(w), e[] = {w.real() / r, w.imag() / r}, n[] = {normal.real(), normal.imag()},
                   along = e[0] * n[0] + e[1] * n[1], a = 1. - 2. * nu, b = 4. * M_PI * (1. - nu);
      for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j)
        {
          const double same = i == j;
          u[i][j] = (-(3. - 4. * nu) * std::log(r) * same + e[i] * e[j]) / (2. * b);
          t[i][j] = -(along * (a * same + 2. * e[i] * e[j]) - a * (e[i] * n[j] - e[j] * n[i])) / (b * r);
          for (int k = 0; k < 2; ++k)
          {
            const double ik = i == k, jk = j == k;
            s[k][i][j] =
                2. / (b * r * r) *
                (2. * along * (a * same * e[k] + nu * (ik * e[j] + jk * e[i]) - 4. * e[i] * e[j] * e[k]) +
                 2. * nu * (n[i] * e[j] * e[k] + n[j] * e[i] * e[k]) +
                 a * (2. * n[k] * e[i] * e[j] + n[j] * ik + n[i] * jk) - (1. - 4. * nu) * n[k] * same);
          }
        }
    }
    double u[2][2], t[2][2], s[2][2][2];
  };

  /// A quadratic that vanishes at the ends of one element, in one component, as a column of its own.
  DisplacementBasis bubble(const Boundary &boundary, const Eigen::Index element, const Eigen::Index component)
  {
    const auto n = static_cast<Eigen::Index>(boundary.elements.size());
    const Eigen::Index column = 2 * n * component + n + element;
    return {boundary.displacements.values.col(column), boundary.displacements.slopes.col(column)};
  }
  double bubble_value(const double eta)
  {
    return .5 * (eta * eta - 1.);
  }
} // namespace

TEST(BemOperators, AgreeWithTheRealKernels)
{
  const double nu = .3;
  const Boundary boundary(l_shape(equal_parts(1)), 2, nu);
  const LegendreRule rule(24, 0);
  const std::size_t first = 0, second = 4; // they do not touch
  const BoundaryElement &a = boundary.elements[first], &b = boundary.elements[second];
  const Complex normal_a = Complex(0., -1.) * a.direction, normal_b = Complex(0., -1.) * b.direction;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
    {
      double v = 0., k = 0., w = 0.;
      for (Eigen::Index p = 0; p < rule.points.size(); ++p)
        for (Eigen::Index q = 0; q < rule.points.size(); ++q)
        {
          const double weight = .25 * a.length * b.length * rule.weighted(p, 0) * rule.weighted(q, 0) *
                                bubble_value(rule.points[p]) * bubble_value(rule.points[q]);
          const Kelvin kelvin(b.point(rule.points[q]) - a.point(rule.points[p]), normal_b, nu);
          v += weight * kelvin.u[i][j];
          k += weight * kelvin.t[i][j];
          w -= weight * (kelvin.s[j][i][0] * normal_a.real() + kelvin.s[j][i][1] * normal_a.imag());
        }
      const DisplacementBasis left = bubble(boundary, first, i), right = bubble(boundary, second, j);
      const LayerOperators &operators = boundary.operators;
      EXPECT_NEAR(operators.single_layer(left.values, right.values)(0, 0), v, 1e-15) << i << j;
      EXPECT_NEAR(operators.double_layer(left.values, right)(0, 0), k, 1e-15) << i << j;
      EXPECT_NEAR(operators.hypersingular(left, right)(0, 0), w, 1e-14) << i << j;
    }
}

TEST(BemOperators, FulfilCalderonsIdentitiesForExactFields)
{
  for (const double nu : {0., .3, .4999999})
    for (const unsigned int degree : {2, 4})
      for (const Shape &shape : shapes())
      {
        const Boundary boundary(shape.elements, degree, nu);
        const CubicField field(nu);
        const DisplacementBasis u = projected(shape.elements, degree, field);
        const LegendreBasis t =
            projected(shape.elements, degree, [&](const Complex z, const BoundaryElement &element) {
              return field.traction(z, element);
            });
        EXPECT_LT(boundary.first_residual(t, u), 1e-13) << shape.name << " " << nu << " " << degree;
        EXPECT_LT(boundary.second_residual(t, u), 1e-13) << shape.name << " " << nu << " " << degree;
      }
}

TEST(BemOperators, TakeRigidMotionsForStressFree)
{
  for (const Shape &shape : shapes())
  {
    const Boundary boundary(shape.elements, 1, .3);
    const double size =
        boundary.operators.hypersingular(boundary.displacements, boundary.displacements).norm();
    for (const DisplacementBasis &motion : rigid_motions(shape.elements, 1))
    {
      EXPECT_LT(boundary.operators.hypersingular(boundary.displacements, motion).norm(), 1e-14 * size)
          << shape.name;
      const Eigen::VectorXd mass = boundary.operators.mass(boundary.tractions, motion.values);
      const Eigen::VectorXd potential = boundary.operators.double_layer(boundary.tractions, motion);
      EXPECT_LT((potential + .5 * mass).norm(), 1e-14 * mass.norm()) << shape.name;
    }
  }
}

TEST(BemOperators, AreSymmetricAndThoseOfVPositive)
{
  for (const Shape &shape : shapes())
  {
    const Boundary boundary(shape.elements, 2, .3);
    const LegendreBasis &t = boundary.tractions, other_t = t;
    const DisplacementBasis &u = boundary.displacements, other_u = u;
    const Eigen::MatrixXd v = boundary.operators.single_layer(t, other_t),
                          w = boundary.operators.hypersingular(u, other_u);
    EXPECT_LT((v - v.transpose()).norm(), 1e-15 * v.norm()) << shape.name;
    EXPECT_LT((w - w.transpose()).norm(), 1e-14 * w.norm()) << shape.name;
    // The half that is computed where both sides are the same basis.
    EXPECT_LT((boundary.operators.single_layer(t, t) - v).norm(), 1e-15 * v.norm()) << shape.name;
    EXPECT_LT((boundary.operators.hypersingular(u, u) - w).norm(), 1e-14 * w.norm()) << shape.name;
    const Eigen::VectorXd scale = v.diagonal().cwiseSqrt().cwiseInverse();
    EXPECT_EQ((scale.asDiagonal() * v * scale.asDiagonal()).llt().info(), Eigen::Success) << shape.name;
  }
}

TEST(BemOperators, LoseDefinitenessAtTheDegenerateScale)
{
  // That of a circle is exp(1/(2 k)), that of a polygon of 32 sides about (pi/32)^2 larger.
  for (const double nu : {.1, .3, .49})
  {
    const double degenerate = std::exp(1. / (2. * (3. - 4. * nu)));
    const auto smallest = [&](const double radius) {
      const Boundary boundary(circle(32, radius), 1, nu);
      const Eigen::MatrixXd v = boundary.operators.single_layer(boundary.tractions, boundary.tractions);
      return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(v, Eigen::EigenvaluesOnly).eigenvalues()[0];
    };
    EXPECT_GT(smallest(.97 * degenerate), 0.) << nu;
    EXPECT_LT(smallest(1.03 * degenerate), -1e-3) << nu;
  }
}

TEST(BemOperators, OfTheEstimatingRuleAreAccurateEnough)
{
  for (const Shape &shape : shapes())
  {
    const Boundary precise(shape.elements, 1, .3),
        boundary(shape.elements, 1, .3, GalerkinRule::estimating());
    const auto difference = [](const Eigen::MatrixXd &exact, const Eigen::MatrixXd &other) {
      const Eigen::VectorXd size = exact.diagonal().cwiseAbs().cwiseSqrt();
      return ((other - exact).array() / (size * size.transpose()).array()).abs().maxCoeff();
    };
    const auto v = [](const Boundary &b) { return b.operators.single_layer(b.tractions, b.tractions); };
    const auto w = [](const Boundary &b) {
      return b.operators.hypersingular(b.displacements, b.displacements);
    };
    EXPECT_LT(difference(v(precise), v(boundary)), 1e-3) << shape.name;
    EXPECT_LT(difference(w(precise), w(boundary)), 1e-3) << shape.name;
    // Yet not the same.
    EXPECT_GT(difference(v(precise), v(boundary)), 1e-9) << shape.name;
  }
}
