// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What no estimator sees: round-off, chords for curves, integrals at singular vertices.
#include "finite_elements_testing.h"

using namespace abut;

namespace
{
  double corner_integral(const FiniteElementBody &body,
                         const std::function<double(const Vector2 &)> &function, unsigned int &n_points)
  {
    double sum = 0.;
    n_points = 0;
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(body.counts().dofs));
    body.visit_corner_stress(zero, [&](const SamplePoint &point, const Stress &) {
      sum += point.weight * function(point.place);
      ++n_points;
    });
    return sum;
  }
} // namespace

// int 1/r over three squares of side h at a corner is 3 h 2 ln(1 + sqrt 2).
TEST(CornerPoints, IntegrateASingularFunctionWhereGaussPointsDoNot)
{
  for (const unsigned int degree : {1u, 2u, 3u})
  {
    auto description = make_body("L-shape", {1.}, {{2, 2}});
    description.degree = degree;
    set_conditions(description, "left: displacement: 0, 0");
    FiniteElementBody body(description, {});
    ASSERT_EQ(body.singular_vertices().size(), 3u); // the corner, and where the support ends
    unsigned int n_points = 0;
    const double area = corner_integral(
        body, [](const Vector2 &) { return 1.; }, n_points);
    EXPECT_NEAR(area, 5. * .25, 1e-13); // three cells at the corner, one at each end of the support
    EXPECT_EQ(n_points % ((degree + 1) * (degree + 1)), 0u);
    const double at_corner = corner_integral(
        body, [](const Vector2 &x) { return x.cwiseAbs().maxCoeff() < .5 ? 1. / x.norm() : 0.; }, n_points);
    EXPECT_NEAR(at_corner / (3. * .5 * 2. * std::log(1. + std::sqrt(2.))), 1., 2e-3);
  }
}

TEST(CornerPoints, AreNoneWithoutSingularVertices)
{
  auto description = make_body("rectangle", {1., 1.}, {{2, 2}});
  set_conditions(description, "bottom: normal displacement: 0; left: normal displacement: 0");
  FiniteElementBody body(description, {});
  unsigned int n_points = 1;
  corner_integral(
      body, [](const Vector2 &) { return 1.; }, n_points);
  EXPECT_EQ(n_points, 0u);
}

// The energy of K^-1 r for a disturbance d of the solution is d . K d.
TEST(SolutionErrors, RoundOffIsTheEnergyOfADisturbance)
{
  auto description = make_body("rectangle", {3., 2.}, {{6, 4}});
  set_conditions(description, "bottom: displacement: 0, 0; top: pressure: 1");
  FiniteElementBody body(description, {});
  body.prepare();
  const Eigen::VectorXd none, u = body.deformation(Eigen::VectorXd::Zero(body.trace_size()), 0.);
  EXPECT_LT(body.round_off_energy(u, Eigen::VectorXd::Zero(body.trace_size())),
            1e-24 * 2. * body.strain_energy(u));
  const Eigen::VectorXd disturbed = 1.001 * u;
  EXPECT_NEAR(body.round_off_energy(disturbed, Eigen::VectorXd::Zero(body.trace_size())) /
                  (1e-6 * 2. * body.strain_energy(u)),
              1., 1e-6);
}

// A ring under pressure: chords of h instead of arcs of R turn by h/(2R) at most; the energy goes with h^3.
TEST(SolutionErrors, ChordsForArcsCostWhatTheirTurnDoes)
{
  const auto energy = [](const unsigned int degree, const unsigned int cells) {
    auto description = make_body("ring", {1., 2.}, {{cells, cells / 2}});
    description.degree = degree;
    set_conditions(description, "outer: displacement: 0, 0; inner: pressure: 1");
    FiniteElementBody body(description, {});
    body.prepare();
    const Eigen::VectorXd u = body.deformation(Eigen::VectorXd::Zero(body.trace_size()), 0.);
    return body.geometry_energy(u) / (2. * body.strain_energy(u));
  };
  EXPECT_NEAR(std::log2(energy(1, 16) / energy(1, 32)), 3., .15);
  EXPECT_LT(energy(3, 16), 1e-6 * energy(1, 16));
}

TEST(SolutionErrors, StraightSidesHaveNoChords)
{
  auto description = make_body("rectangle", {3., 2.}, {{6, 4}});
  set_conditions(description, "bottom: displacement: 0, 0; top: pressure: 1");
  FiniteElementBody body(description, {});
  body.prepare();
  EXPECT_EQ(body.geometry_energy(body.deformation(Eigen::VectorXd::Zero(body.trace_size()), 0.)), 0.);
}

TEST(SolutionErrors, TrianglesThatStandForACurveSayThatTheyDoNotKnow)
{
  auto description = make_body("ring", {1., 2.}, {{8, 4}});
  description.cell_type = CellType::triangles;
  set_conditions(description, "outer: displacement: 0, 0; inner: pressure: 1");
  FiniteElementBody body(description, {});
  body.prepare();
  EXPECT_TRUE(
      std::isnan(body.geometry_energy(body.deformation(Eigen::VectorXd::Zero(body.trace_size()), 0.))));
}
