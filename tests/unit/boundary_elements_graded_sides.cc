// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bodies/boundary_elements/graded_sides.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
  using namespace abut;

  constexpr unsigned int n_halvings = 5;

  BodyDescription unit_body(const std::string &shape, const std::vector<double> &size,
                            const std::string &conditions, const unsigned int degree = 1)
  {
    BodyDescription body;
    body.name = "body";
    body.shape = shape;
    body.size = size;
    body.cells = {{2, 2}};
    body.degree = degree;
    body.young_modulus = 1.;
    body.poisson_ratio = .3;
    body.conditions = parse_conditions(conditions, {}, "test");
    return body;
  }

  /// The sides of a body, graded.
  struct Graded
  {
    explicit Graded(const BodyDescription &description) : body(description, {}), graded(body, n_halvings) {}

    std::vector<dealii::types::boundary_id> ids() const
    {
      return body.space().mesh().triangulation.get_boundary_ids();
    }
    std::vector<Trace> own() const
    {
      std::vector<Trace> sides;
      for (const auto id : ids())
        sides.push_back(body.space().trace(id));
      return sides;
    }
    std::size_t n_own() const
    {
      std::size_t n = 0;
      for (const Trace &side : own())
        n += side.segments().size();
      return n;
    }
    std::size_t n_singular() const
    {
      return static_cast<std::size_t>(
          std::count(graded.singular_ends().begin(), graded.singular_ends().end(), true));
    }

    FiniteElementBody body;
    GradedSides graded;
  };

  struct Count
  {
    std::string name;
    BodyDescription body;
    std::size_t n_singular;
  };

  std::ostream &operator<<(std::ostream &out, const Count &given)
  {
    return out << given.name;
  }

  class SingularVertices : public ::testing::TestWithParam<Count>
  {};

  /// Each costs as many new pieces on both of its edges as it is halved.
  TEST_P(SingularVertices, AreFound)
  {
    const Graded graded(GetParam().body);
    EXPECT_EQ(graded.n_singular(), GetParam().n_singular);
    EXPECT_EQ(graded.graded.singular_ends().size(), graded.n_own() + 2 * n_halvings * GetParam().n_singular);
    for (std::size_t i = 0; i < graded.own().size(); ++i)
      EXPECT_NEAR(graded.graded.sides()[i].length(), graded.own()[i].length(), 1e-13);
  }

  const std::string rollers = "left: normal displacement: 0; bottom: normal displacement: 0";
  const auto block = [](const std::string &conditions) {
    return unit_body("rectangle", {1., 1.}, conditions);
  };

  INSTANTIATE_TEST_SUITE_P(
      Of, SingularVertices,
      ::testing::Values(
          Count{"NoneBetweenRollersAndFreeSides", block(rollers), 0},
          Count{"ASmoothLoad", block(rollers + "; top: pressure: sin(3*x)"), 0},
          Count{"AJump", block(rollers + "; top: pressure: if(x < 0.5, 1, 0)"), 1},
          Count{"AnInfinitePressure", block(rollers + "; top: pressure: if(x < 0.5, 1/sqrt(0.25 - x^2), 0)"),
                1},
          Count{"OneInfiniteOnBothSides", block(rollers + "; top: pressure: 1/sqrt(abs(x - 0.5))"), 1},
          Count{"BothEndsOfAClampedSide", block("left: displacement: 0, 0"), 2},
          Count{"ClampedBesideARoller", block("left: displacement: 0, 0; bottom: normal displacement: 0"), 1},
          Count{"AReentrantCorner", unit_body("L-shape", {1.}, "left: displacement: 0, 0"), 3},
          Count{"NoneOnADisc", unit_body("disc", {1.}, ""), 0}),
      [](const auto &parameter) { return parameter.param.name; });

  /// New nodes carry what the polynomials of their edges have there.
  TEST(GradedSides, ExtendFields)
  {
    for (const unsigned int degree : {1u, 2u, 3u})
    {
      const Graded graded(
          unit_body("rectangle", {1., 1.}, rollers + "; top: pressure: if(x < 0.5, 1, 0)", degree));
      const auto field = [degree](const Vector2 &p) { return 1. + std::pow(p.x(), degree) - p.y(); };
      Eigen::VectorXd values = Eigen::VectorXd::Zero(graded.body.space().n_dofs());
      for (const Trace &side : graded.own())
        for (std::size_t node = 0; node < side.n_nodes(); ++node)
          for (unsigned int c = 0; c < 2; ++c)
            values[side.node_dofs()[node][c]] = (1. + c) * field(side.node_points()[node]);
      const Eigen::VectorXd extended = graded.graded.extended(values);
      EXPECT_GT(extended.size(), values.size());
      for (const Trace &side : graded.graded.sides())
        for (std::size_t node = 0; node < side.n_nodes(); ++node)
          for (unsigned int c = 0; c < 2; ++c)
            EXPECT_NEAR(extended[side.node_dofs()[node][c]], (1. + c) * field(side.node_points()[node]),
                        1e-13);
    }
  }
} // namespace
