// SPDX-License-Identifier: LGPL-2.1-or-later
#include "smooth_solution.h"

#include <abut/elasticity/body.h>

#include <deal.II/base/quadrature_lib.h>

namespace
{
  using namespace abut;

  constexpr double a = 2.1, b = .7, c = .6, d = 1.9;

  // Stresses, and traction from the direction (m, n) of the outward normal.
  const std::string s_xx = "((L+2*M)*a*cos(a*x)*exp(b*y)-L*d*exp(c*x)*sin(d*y))";
  const std::string s_yy = "(L*a*cos(a*x)*exp(b*y)-(L+2*M)*d*exp(c*x)*sin(d*y))";
  const std::string s_xy = "(M*(b*sin(a*x)*exp(b*y)+c*exp(c*x)*cos(d*y)))";
  const std::string u_x = "sin(a*x)*exp(b*y)", u_y = "exp(c*x)*cos(d*y)";

  /// The slope of the top side, as a formula: that of `curved_top`, or 0.
  std::string slope(const BodyDescription &shape)
  {
    return shape.shape == Shape::rectangle_curved_top ? "(0.4*cos(2*x))" : "0";
  }
} // namespace

SmoothSolution::SmoothSolution(const BodyDescription &shape) : body_(shape)
{
  const Material material{shape.young_modulus, shape.poisson_ratio};
  const Constants constants{{"a", a},
                            {"b", b},
                            {"c", c},
                            {"d", d},
                            {"L", material.lambda()},
                            {"M", material.mu()},
                            {"S", shape.placement.length_to_world(1.)}};
  const std::string t = slope(shape), unit = "/sqrt(1+" + t + "^2)";
  // -div sigma; derivatives are those of the plane, S times smaller than those of the own frame.
  body_.body_force = {
      Expression("((L+2*M)*a^2*sin(a*x)*exp(b*y)+(L+M)*c*d*exp(c*x)*sin(d*y)-M*b^2*sin(a*x)*exp(b*y))/S",
                 constants, "force"),
      Expression("((L+2*M)*d^2*exp(c*x)*cos(d*y)-(L+M)*a*b*cos(a*x)*exp(b*y)-M*c^2*exp(c*x)*cos(d*y))/S",
                 constants, "force")};
  body_.conditions =
      parse_conditions("left: displacement: " + u_x + ", " + u_y + "; bottom: displacement y: " + u_y +
                           "; bottom: traction: -" + s_xy + ", -" + s_yy + "; right: traction: " + s_xx +
                           ", " + s_xy + "; top: traction: (" + s_xy + "-" + t + "*" + s_xx + ")" + unit +
                           ", (" + s_yy + "-" + t + "*" + s_xy + ")" + unit,
                       constants, "conditions");
}

Vector2 SmoothSolution::displacement(const Vector2 &point) const
{
  const Vector2 p = body_.placement.point_to_own(point);
  const Vector2 own(std::sin(a * p.x()) * std::exp(b * p.y()), std::exp(c * p.x()) * std::cos(d * p.y()));
  return body_.placement.length_to_world(1.) * body_.placement.direction_to_world(own);
}

Eigen::Matrix2d SmoothSolution::gradient(const Vector2 &point) const
{
  const Vector2 p = body_.placement.point_to_own(point);
  const double ey = std::exp(b * p.y()), ex = std::exp(c * p.x());
  Eigen::Matrix2d own, turn;
  own << a * std::cos(a * p.x()) * ey, b * std::sin(a * p.x()) * ey, c * ex * std::cos(d * p.y()),
      -d * ex * std::sin(d * p.y());
  turn << body_.placement.direction_to_world(Vector2::UnitX()),
      body_.placement.direction_to_world(Vector2::UnitY());
  return turn * own * turn.transpose();
}

SmoothErrors solve_smooth(const BodyDescription &shape)
{
  const SmoothSolution exact(shape);
  Body body(exact.description(), {});
  body.prepare();
  const Eigen::VectorXd u = body.displacement(Eigen::VectorXd::Zero(body.trace_size()), 0.);

  dealii::Quadrature<2> quadrature = dealii::QGauss<2>(shape.degree + 3);
  if (shape.cell_type == CellType::triangles)
    quadrature = dealii::QGaussSimplex<2>(4);
  const Material material = body.material();
  const auto energy_density = [&](const Eigen::Matrix2d &gradient) {
    const Stress s = material.stress(gradient);
    return s.xx * gradient(0, 0) + s.yy * gradient(1, 1) + s.xy * (gradient(0, 1) + gradient(1, 0));
  };
  double energy = 0., energy_error = 0., square = 0., square_error = 0.;
  visit_gradients(
      body.space(), quadrature, u,
      [&](const Vector2 &point, const double weight, const Vector2 &value, const Eigen::Matrix2d &gradient) {
        energy += weight * energy_density(exact.gradient(point));
        energy_error += weight * energy_density(gradient - exact.gradient(point));
        square += weight * exact.displacement(point).squaredNorm();
        square_error += weight * (value - exact.displacement(point)).squaredNorm();
      });
  return {std::sqrt(energy_error / energy), std::sqrt(square_error / square)};
}
