// SPDX-License-Identifier: LGPL-2.1-or-later
#include "smooth_solution.h"

#include <abut/bodies/finite_elements/stress_field.h>

#include <deal.II/base/quadrature_lib.h>

namespace
{
  using namespace abut;

  constexpr double a = 2.1, b = .7, c = .6, d = 1.9;

  Vector2 compressible(const Vector2 &p, double /*k*/)
  {
    return Vector2(std::sin(a * p.x()) * std::exp(b * p.y()), std::exp(c * p.x()) * std::cos(d * p.y()));
  }

  Eigen::Matrix2d compressible_gradient(const Vector2 &p, double /*k*/)
  {
    const double ey = std::exp(b * p.y()), ex = std::exp(c * p.x());
    Eigen::Matrix2d gradient;
    gradient << a * std::cos(a * p.x()) * ey, b * std::sin(a * p.x()) * ey, c * ex * std::cos(d * p.y()),
        -d * ex * std::sin(d * p.y());
    return gradient;
  }

  Vector2 nearly_incompressible(const Vector2 &p, const double k)
  {
    return Vector2(std::sin(a * p.x()) * std::exp(b * p.y()) + k * std::sin(d * p.x()) * std::exp(c * p.y()),
                   -a / b * std::cos(a * p.x()) * std::exp(b * p.y()));
  }

  Eigen::Matrix2d nearly_incompressible_gradient(const Vector2 &p, const double k)
  {
    const double eb = std::exp(b * p.y()), ec = k * std::exp(c * p.y());
    Eigen::Matrix2d gradient;
    gradient << a * std::cos(a * p.x()) * eb + d * std::cos(d * p.x()) * ec,
        b * std::sin(a * p.x()) * eb + c * std::sin(d * p.x()) * ec, a * a / b * std::sin(a * p.x()) * eb,
        -a * std::cos(a * p.x()) * eb;
    return gradient;
  }

  /// The slope of the top side, as a formula: that of `curved_top`, or 0.
  std::string slope(const BodyDescription &shape)
  {
    return shape.shape == "rectangle with curved top" ? "(0.4*cos(2*x))" : "0";
  }
} // namespace

const SmoothField &compressible_field()
{
  static const SmoothField field{
      "sin(a*x)*exp(b*y)",
      "exp(c*x)*cos(d*y)",
      "((L+2*M)*a*cos(a*x)*exp(b*y)-L*d*exp(c*x)*sin(d*y))",
      "(L*a*cos(a*x)*exp(b*y)-(L+2*M)*d*exp(c*x)*sin(d*y))",
      "(M*(b*sin(a*x)*exp(b*y)+c*exp(c*x)*cos(d*y)))",
      "(L+2*M)*a^2*sin(a*x)*exp(b*y)+(L+M)*c*d*exp(c*x)*sin(d*y)-M*b^2*sin(a*x)*exp(b*y)",
      "(L+2*M)*d^2*exp(c*x)*cos(d*y)-(L+M)*a*b*cos(a*x)*exp(b*y)-M*c^2*exp(c*x)*cos(d*y)",
      compressible,
      compressible_gradient};
  return field;
}

const SmoothField &nearly_incompressible_field()
{
  static const SmoothField field{"(sin(a*x)*exp(b*y)+K*sin(d*x)*exp(c*y))",
                                 "(-a/b*cos(a*x)*exp(b*y))",
                                 "M*((1+2*K)*d*cos(d*x)*exp(c*y)+2*a*cos(a*x)*exp(b*y))",
                                 "M*(d*cos(d*x)*exp(c*y)-2*a*cos(a*x)*exp(b*y))",
                                 "M*((b+a^2/b)*sin(a*x)*exp(b*y)+K*c*sin(d*x)*exp(c*y))",
                                 "M*(((1+2*K)*d^2-K*c^2)*sin(d*x)*exp(c*y)+(a^2-b^2)*sin(a*x)*exp(b*y))",
                                 "-M*((1+K)*c*d*cos(d*x)*exp(c*y)+a/b*(a^2-b^2)*cos(a*x)*exp(b*y))",
                                 nearly_incompressible,
                                 nearly_incompressible_gradient};
  return field;
}

SmoothSolution::SmoothSolution(const BodyDescription &shape, const SmoothField &field)
    : field_(field), body_(shape)
{
  const Material material{shape.young_modulus, shape.poisson_ratio};
  k_ = material.mu() / material.lambda();
  const Constants constants{{"a", a},
                            {"b", b},
                            {"c", c},
                            {"d", d},
                            {"L", material.lambda()},
                            {"M", material.mu()},
                            {"K", k_},
                            {"S", shape.placement.length_to_world(1.)}};
  const std::string t = slope(shape), unit = "/sqrt(1+" + t + "^2)";
  // -div sigma; derivatives are those of the plane, S times smaller than those of the own frame.
  body_.body_force = {Expression("(" + field.f_x + ")/S", constants, "force"),
                      Expression("(" + field.f_y + ")/S", constants, "force")};
  // Traction from the direction (m, n) of the outward normal.
  body_.conditions = parse_conditions(
      "left: displacement: " + field.u_x + ", " + field.u_y + "; bottom: displacement y: " + field.u_y +
          "; bottom: traction: -" + field.s_xy + ", -" + field.s_yy + "; right: traction: " + field.s_xx +
          ", " + field.s_xy + "; top: traction: (" + field.s_xy + "-" + t + "*" + field.s_xx + ")" + unit +
          ", (" + field.s_yy + "-" + t + "*" + field.s_xy + ")" + unit,
      constants, "conditions");
}

Vector2 SmoothSolution::displacement(const Vector2 &point) const
{
  const Vector2 own = field_.displacement(body_.placement.point_to_own(point), k_);
  return body_.placement.length_to_world(1.) * body_.placement.direction_to_world(own);
}

Eigen::Matrix2d SmoothSolution::gradient(const Vector2 &point) const
{
  Eigen::Matrix2d turn;
  turn << body_.placement.direction_to_world(Vector2::UnitX()),
      body_.placement.direction_to_world(Vector2::UnitY());
  return turn * field_.gradient(body_.placement.point_to_own(point), k_) * turn.transpose();
}

SmoothErrors solve_smooth(const BodyDescription &shape, const SmoothField &field)
{
  const SmoothSolution exact(shape, field);
  FiniteElementBody body(exact.description(), {});
  body.prepare();
  const Eigen::VectorXd u = body.displacement(Eigen::VectorXd::Zero(body.trace_size()), 0.);

  dealii::Quadrature<2> quadrature = dealii::QGauss<2>(shape.degree + 3);
  if (shape.cell_type == CellType::triangles)
    quadrature = dealii::QGaussSimplex<2>(4);
  const Material material = body.material();
  double energy = 0., energy_error = 0., stress = 0., stress_error = 0., square = 0., square_error = 0.;
  StressField(body, u).visit(quadrature,
                             [&](const Vector2 &point, const double weight, const Stress &computed) {
                               const Stress right = material.stress(exact.gradient(point));
                               energy += weight * material.energy_density(right);
                               energy_error += weight * material.energy_density(computed - right);
                               stress += weight * right.square();
                               stress_error += weight * (computed - right).square();
                             });
  visit_gradients(
      body.space(), quadrature, u,
      [&](const Vector2 &point, const double weight, const Vector2 &value, const Eigen::Matrix2d &) {
        square += weight * exact.displacement(point).squaredNorm();
        square_error += weight * (value - exact.displacement(point)).squaredNorm();
      });
  return {std::sqrt(energy_error / energy), std::sqrt(stress_error / stress),
          std::sqrt(square_error / square)};
}
