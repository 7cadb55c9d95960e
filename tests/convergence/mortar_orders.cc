// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Glued meshes that do not match, with a smooth solution: displacement, stress and the traction of the glue.
#include <abut/bodies/finite_elements/stress_field.h>
#include <abut/trace/applied_traction.h>

#include <gtest/gtest.h>

#include "convergence_table.h"
#include "smooth_solution.h"

namespace
{
  using namespace abut;

  constexpr std::size_t in_energy = 0, in_l2 = 1, of_multiplier = 2;

  BodyDescription part(const std::string &name, const std::string &shape, const std::vector<double> &size,
                       const std::array<unsigned int, 2> &cells, const Vector2 &shift)
  {
    BodyDescription part;
    part.name = name;
    part.is_part = true;
    part.shape = shape;
    part.size = size;
    part.cells = cells;
    part.placement = Placement(1., false, 0., shift);
    part.young_modulus = 2.1e5;
    part.poisson_ratio = .3;
    return part;
  }

  BodyDescription glued(const std::vector<BodyDescription> &parts, const unsigned int degree,
                        const MortarMultipliers multipliers)
  {
    BodyDescription body;
    body.name = "plate";
    body.shape = "glued parts";
    body.degree = degree;
    body.young_modulus = 2.1e5;
    body.poisson_ratio = .3;
    body.joints.glue.automatic = true;
    body.joints.mortar.multipliers = multipliers;
    for (const BodyDescription &own : parts)
    {
      body.parts.push_back(own);
      body.parts.back().degree = degree;
      body.regions.push_back({own.name, {own.young_modulus, own.poisson_ratio}});
    }
    return body;
  }

  /// Gives conditions to other sides: of each side that is named first to those that follow.
  void move_conditions(BodyDescription &body,
                       const std::vector<std::pair<std::string, std::vector<std::string>>> &sides)
  {
    std::vector<Condition> moved;
    for (const Condition &condition : body.conditions)
      for (const auto &[from, to] : sides)
        if (condition.boundary == from)
          for (const std::string &side : to)
          {
            moved.push_back(condition);
            moved.back().boundary = side;
          }
    body.conditions = moved;
  }

  struct GlueErrors
  {
    double energy = 0., l2 = 0., multiplier = 0.;
  };

  /// Relative; that of the traction on the slave side with the square roots of its edges as weights.
  GlueErrors errors_of(const SmoothSolution &exact, const BodyDescription &description)
  {
    FiniteElementBody body(description, {});
    body.prepare();
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(0), u = body.displacement(none, 0.);
    const Material material = body.material();
    double error = 0., norm = 0., square_error = 0., square = 0.;
    body.visit_stress(u, SamplePoints::precise, [&](const SamplePoint &point, const Stress &computed) {
      const Stress right = material.stress(exact.gradient(point.place));
      norm += point.weight * material.energy_density(right);
      error += point.weight * material.energy_density(computed - right);
    });
    body.visit_displacement(u, SamplePoints::precise,
                            [&](const SamplePoint &point, const Vector2 &value, const Eigen::Matrix2d &) {
                              square += point.weight * exact.displacement(point.place).squaredNorm();
                              square_error +=
                                  point.weight * (value - exact.displacement(point.place)).squaredNorm();
                            });
    GlueErrors errors{std::sqrt(error / norm), std::sqrt(square_error / square), 0.};

    const Trace slave = body.space().trace(body.space().glued_sides().front().slave);
    const Eigen::VectorXd all = body.glue_forces(body.deformation(none, 0.), none).front();
    Eigen::VectorXd forces(2 * static_cast<Eigen::Index>(slave.n_nodes()));
    for (std::size_t node = 0; node < slave.n_nodes(); ++node)
      for (std::size_t component = 0; component < 2; ++component)
        forces[static_cast<Eigen::Index>(2 * node + component)] = all[slave.node_dofs()[node][component]];
    const Eigen::VectorXd traction = applied_traction(slave, forces);
    const GaussRule rule(description.degree + 3);
    double weighted_error = 0., weighted = 0.;
    for (const Segment &segment : slave.segments())
      for (Eigen::Index q = 0; q < rule.points.size(); ++q)
      {
        const double s = rule.points[q];
        const Vector2 tangent = slave.tangent(segment, s),
                      normal = Vector2(tangent.y(), -tangent.x()).normalized();
        const Stress stress = material.stress(exact.gradient(slave.point(segment, s)));
        const Vector2 right(stress.xx * normal.x() + stress.xy * normal.y(),
                            stress.xy * normal.x() + stress.yy * normal.y());
        const Eigen::VectorXd values = slave.basis().values(s);
        Vector2 computed = Vector2::Zero();
        for (std::size_t i = 0; i < segment.nodes.size(); ++i)
          computed += values[static_cast<Eigen::Index>(i)] * traction.segment<2>(2 * segment.nodes[i]);
        const double weight = rule.weights[q] * tangent.norm();
        weighted_error += weight * segment.length * (computed - right).squaredNorm();
        weighted += weight * right.squaredNorm();
      }
    errors.multiplier = std::sqrt(weighted_error / weighted);
    return errors;
  }

  struct Variant
  {
    unsigned int degree;
    MortarMultipliers multipliers;
  };

  class GluedPlates : public testing::TestWithParam<Variant>
  {
  protected:
    std::string title(const std::string &scene) const
    {
      return scene + ", degree " + std::to_string(GetParam().degree) +
             (GetParam().multipliers == MortarMultipliers::dual ? ", dual" : ", standard") + " multipliers";
    }
  };

  TEST_P(GluedPlates, HaveOptimalOrders)
  {
    const unsigned int degree = GetParam().degree;
    ConvergenceTable table(title("Two plates, edges 2 to 3"), {"energy", "L2", "multiplier"});
    for (unsigned int n = 4; n <= (degree == 1 ? 64 : 32u); n *= 2)
    {
      BodyDescription plate = glued({part("west", "rectangle", {.6, 1.}, {{n, n}}, {0., 0.}),
                                     part("east", "rectangle", {.7, 1.}, {{n, 3 * n / 2}}, {.6, 0.})},
                                    degree, GetParam().multipliers);
      const SmoothSolution exact(plate);
      BodyDescription body = exact.description();
      move_conditions(body, {{"left", {"west.left"}},
                             {"bottom", {"west.bottom", "east.bottom"}},
                             {"right", {"east.right"}},
                             {"top", {"west.top", "east.top"}}});
      const GlueErrors errors = errors_of(exact, body);
      table.add(1. / n, {errors.energy, errors.l2, errors.multiplier});
    }
    table.print();
    EXPECT_NEAR(table.last_rate(in_energy), degree, .1);
    EXPECT_NEAR(table.last_rate(in_l2), degree + 1, .15);
    EXPECT_GT(table.last_rate(of_multiplier), degree + .45);
  }

  TEST_P(GluedPlates, HaveOptimalOrdersAroundADisc)
  {
    const unsigned int degree = GetParam().degree;
    ConvergenceTable table(title("A disc glued into a ring, edges 2 to 3"), {"energy", "L2", "multiplier"});
    for (unsigned int n = 2; n <= (degree == 1 ? 16 : 8u); n *= 2)
    {
      BodyDescription plate = glued({part("disc", "disc", {.5}, {{n, n}}, {0., 0.}),
                                     part("ring", "ring", {.5, 1.}, {{3 * n / 2, n}}, {0., 0.})},
                                    degree, GetParam().multipliers);
      const SmoothSolution exact(plate);
      BodyDescription body = exact.description();
      body.conditions = {body.conditions.front()}; // displacement
      body.conditions.front().boundary = "ring.outer";
      const GlueErrors errors = errors_of(exact, body);
      table.add(1. / n, {errors.energy, errors.l2, errors.multiplier});
    }
    table.print();
    EXPECT_GT(table.last_rate(in_energy), degree - .1);
    EXPECT_GT(table.last_rate(in_l2), degree + .8);
    EXPECT_GT(table.overall_rate(of_multiplier), degree + .45);
  }

  std::string glue_name(const testing::TestParamInfo<Variant> &info)
  {
    return (info.param.multipliers == MortarMultipliers::dual ? "Dual" : "Standard") +
           std::to_string(info.param.degree);
  }

  INSTANTIATE_TEST_SUITE_P(
      Degrees, GluedPlates,
      testing::Values(Variant{1, MortarMultipliers::dual}, Variant{2, MortarMultipliers::dual},
                      Variant{3, MortarMultipliers::dual}, Variant{1, MortarMultipliers::standard},
                      Variant{2, MortarMultipliers::standard}, Variant{3, MortarMultipliers::standard}),
      glue_name);
} // namespace
