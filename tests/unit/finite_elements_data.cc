// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Conditions and body forces that change within cells.
#include "finite_elements_testing.h"

using namespace abut;

namespace
{
  BodyDescription block(const unsigned int degree, const unsigned int cells, const std::string &top)
  {
    auto description = make_body("rectangle", {4., 2.}, {{2 * cells, cells}});
    description.degree = degree;
    set_conditions(description, "bottom: displacement: 0, 0; top: " + top);
    return description;
  }

  double oscillation(const BodyDescription &description)
  {
    return FiniteElementBody(description, {}).data_oscillation().norm();
  }

  double work(const BodyDescription &description)
  {
    FiniteElementBody body(description, {});
    body.prepare();
    return 2. * body.strain_energy(body.deformation(Eigen::VectorXd(0), 0.));
  }

  /// The force on the support.
  double reaction(const BodyDescription &description)
  {
    FiniteElementBody body(description, {});
    body.prepare();
    const Eigen::VectorXd none(0);
    return body.reactions(body.deformation(none, 0.), none).by_boundary.at("bottom").y();
  }

  void set_body_force(BodyDescription &description, const std::string &y)
  {
    description.body_force = {Expression("0", {}, "test"), Expression(y, {}, "test")};
  }
} // namespace

TEST(DataOscillation, IsNoneWhereThePolynomialsOfTheSpaceAreEnough)
{
  for (const unsigned int degree : {1u, 2u, 3u})
  {
    EXPECT_EQ(oscillation(block(degree, 2, "pressure: 2")), 0.);
    const std::string power = "x^" + std::to_string(degree);
    const double pressure = oscillation(block(degree, 2, "pressure: " + power)),
                 displacement = oscillation(block(degree, 2, "displacement: 1, " + power));
    EXPECT_LT(pressure, 1e-10);
    EXPECT_LT(displacement, 1e-10);
    auto heavy = block(degree, 2, "pressure: 0");
    set_body_force(heavy, "y^" + std::to_string(degree - 1));
    EXPECT_LT(oscillation(heavy), 1e-10);
  }
}

// Nodes at the zeros of a displacement, an edge's mean of a pressure: no cell has seen anything. A half-plane
// under waves has the energy that the estimate gives waves of their length; Haar's steps are not sines.
TEST(DataOscillation, IsTheWorkOfWavesThatCellsDoNotSee)
{
  for (const unsigned int degree : {1u, 2u, 3u})
  {
    const std::string wave = "1e-3*sin(16*pi*x)"; // 8 waves in a cell of 2 x 2
    const double exact = work(block(3, 40, "displacement y: " + wave));
    EXPECT_GT(oscillation(block(degree, 2, "displacement y: " + wave)) / std::sqrt(exact), .5);
    EXPECT_LT(oscillation(block(degree, 2, "displacement y: " + wave)) / std::sqrt(exact), 2.);
    const double loaded = work(block(3, 40, "pressure: " + wave));
    EXPECT_GT(oscillation(block(degree, 2, "pressure: " + wave)) / std::sqrt(loaded), .5);
    EXPECT_LT(oscillation(block(degree, 2, "pressure: " + wave)) / std::sqrt(loaded), 2.);
  }
}

// The error goes with h^p.
TEST(DataOscillation, IsOfHigherOrderThanTheErrorWhereDataAreSmooth)
{
  for (const unsigned int degree : {1u, 2u, 3u})
    for (const std::string kind : {"pressure: ", "displacement y: "})
    {
      const double coarse = oscillation(block(degree, 8, kind + "sin(x)")),
                   fine = oscillation(block(degree, 16, kind + "sin(x)"));
      const double above = kind == "pressure: " ? 1.5 : .5;
      EXPECT_NEAR(std::log2(coarse / fine), degree + above, .1) << kind << degree;
    }
}

TEST(NarrowLoads, ArriveWhole)
{
  for (const unsigned int degree : {1u, 2u, 3u})
  {
    EXPECT_NEAR(reaction(block(degree, 2, "pressure: 100*(abs(x-1.31)<0.002)")) / .4, 1., 1e-3);
    auto heavy = block(degree, 2, "pressure: 0");
    set_body_force(heavy, "-1e4*exp(-1e4*((x-1.31)^2+(y-0.37)^2))");
    EXPECT_NEAR(reaction(heavy) / M_PI, 1., 1e-3);
    if (degree == 3)
      continue; // no triangles
    heavy.cell_type = CellType::triangles;
    EXPECT_NEAR(reaction(heavy) / M_PI, 1., 1e-3);
  }
}
