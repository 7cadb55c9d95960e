// SPDX-License-Identifier: LGPL-2.1-or-later
// The boundary elements of a body: unknowns, what is refused, what is kept.
#include "boundary_elements_testing.h"

using namespace abut;

namespace
{
  std::unique_ptr<FiniteElementBody> pulled_plate()
  {
    BodyDescription description = turned_plate(CellType::quadrilaterals, 1, 1.);
    set_conditions(description, "left: displacement: 0, 0; right: traction: 0.3, 0.1*y");
    return std::make_unique<FiniteElementBody>(description, std::vector<std::string>());
  }

  Eigen::MatrixX3d as_rows(const std::vector<Stress> &stresses)
  {
    Eigen::MatrixX3d rows(static_cast<Eigen::Index>(stresses.size()), 3);
    for (Eigen::Index i = 0; i < rows.rows(); ++i)
    {
      const Stress &s = stresses[static_cast<std::size_t>(i)];
      rows.row(i) << s.xx, s.yy, s.xy;
    }
    return rows;
  }

  void expect_no_boundary_elements(const CellErrors &errors)
  {
    EXPECT_TRUE(std::isfinite(errors.stress.norm()));
    EXPECT_EQ(errors.boundary.elements, 0);
    EXPECT_EQ(errors.boundary.unknowns, 0);
    EXPECT_EQ(errors.boundary.assemble + errors.boundary.solve + errors.boundary.evaluate, 0.);
  }
} // namespace

TEST(AdaptationBoundary, HasTheUnknownsOfItsKind)
{
  // Ten edges, two of them clamped. Degree 1: 7 of 10 nodes are free; degree 2: 15 of 20. Eight more pieces
  // on either side of both ends of the clamped side, but not with the second and the last kind.
  const Eigen::Index elements[] = {10 + 32, 10, 10 + 32, 10},
                     tractions[] = {(2 + 16) * 2 * 2, 2 * 2, (2 + 16) * 2 * 2, 0},
                     displacements[] = {14 + 16 * 2, 14, 30 + 16 * 4, 0};
  for (std::size_t k = 0; k < 4; ++k)
  {
    const auto body = pulled_plate();
    const CellErrors errors = estimate(*body, all_boundary_solutions[k]);
    EXPECT_EQ(errors.boundary.elements, elements[k]) << k;
    EXPECT_EQ(errors.boundary.unknowns, tractions[k] + displacements[k]) << k;
    EXPECT_GT(errors.boundary.assemble, 0.);
    EXPECT_GT(errors.boundary.evaluate, 0.);
  }
}

TEST(AdaptationBoundary, StressIsThatOfTheBoundaryValues)
{
  // By hand: traction and smoothed slopes of the state, put into InteriorStress in units of the plane.
  for (const BoundarySolution kind : all_boundary_solutions)
  {
    const auto body = pulled_plate();
    const CellErrors errors = estimate(*body, kind);
    const Eigen::VectorXd none, deformation = body->deformation(none, 0.);
    const BodySolution solution{*body, deformation, none};
    const BoundaryModel model(*body, kind);
    BoundaryValues values = model.values(model.solve(solution, 0.));
    values.traction *= body->material().mu();
    std::vector<BoundaryElement> elements;
    for (const BoundaryElement &e : model.space().elements())
      elements.emplace_back(e.start * model.space().unit_length() + model.space().centre(),
                            e.end * model.space().unit_length() + model.space().centre());
    const InteriorStress interior(elements, values, body->material().mu(), .3);
    std::vector<Complex> points;
    visit_gradients(body->space(), sample_rule(body->space(), SamplePoints::comparison), deformation,
                    [&](const Vector2 &p, double, const Vector2 &, const Eigen::Matrix2d &) {
                      points.emplace_back(p.x(), p.y());
                    });
    const Eigen::MatrixX3d expected = as_rows(interior.at(points));
    ASSERT_EQ(errors.better.size(), points.size());
    EXPECT_LT((as_rows(errors.better) - expected).norm(), 1e-12 * expected.norm()) << name_of(kind);
  }
}

TEST(AdaptationBoundary, SmoothingKeepsMeansAndHalvesJumps)
{
  // Between rollers and free sides nothing is infinite: no edge is split.
  BodyDescription description = turned_plate(CellType::quadrilaterals, 1, 1.);
  set_conditions(description, "left: normal displacement: 0; bottom: normal displacement: 0; "
                              "right: traction: 0.3, 0.1*y");
  const auto body = std::make_unique<FiniteElementBody>(description, std::vector<std::string>());
  body->prepare();
  const Eigen::VectorXd none, deformation = body->deformation(none, 0.);
  const BodySolution solution{*body, deformation, none};
  const BoundaryModel smoothed(*body, BoundarySolution::trace_space),
      raw(*body, BoundarySolution::constant_traction);
  const BoundaryState state = smoothed.solve(solution, 0.);
  const Eigen::MatrixXcd with = smoothed.values(state).slope, without = raw.values(state).slope;
  EXPECT_LT((with.row(0) - without.row(0)).norm(), 1e-15);
  EXPECT_LT(without.row(1).norm(), 1e-14);
  // On the element between two others of its side, h the lengths, g the slopes: at its end it would become
  // g + (next g - g) h/(h + next h), at its start likewise; the slope gets half the difference.
  const auto &space = smoothed.space();
  unsigned int n_inner = 0;
  for (std::size_t before = 0; before < space.elements().size(); ++before)
  {
    const std::size_t here = space.next(before), after = space.next(here);
    if (space.is_corner(before) || space.is_corner(here))
      continue;
    ++n_inner;
    const auto g = [&](const std::size_t e) { return without(0, static_cast<Eigen::Index>(e)); };
    const auto h = [&](const std::size_t e) { return space.elements()[e].length; };
    const Complex at_end = g(here) + (g(after) - g(here)) * h(here) / (h(here) + h(after)),
                  at_start = g(here) + (g(before) - g(here)) * h(here) / (h(here) + h(before));
    EXPECT_LT(std::abs(with(1, static_cast<Eigen::Index>(here)) - .5 * (at_end - at_start)), 1e-14);
  }
  EXPECT_EQ(n_inner, 2u); // of three on the top and the bottom
}

TEST(AdaptationBoundary, RefusesWhatItIsNotMadeFor)
{
  const auto indicator = indicator_of("fe-be");
  const auto refused = [&](const BodyDescription &description, const std::string &part) {
    const FiniteElementBody body(description, {});
    expect_refused([&] { indicator->check(body); }, part);
    for (const std::string &other : estimators)
      EXPECT_NO_THROW(indicator_of(other)->check(body));
  };
  BodyDescription disc = make_body("disc", {1.}, {{4, 2}});
  set_conditions(disc, "outer: displacement: 0, 0");
  EXPECT_NO_THROW(indicator->check(FiniteElementBody(disc, {})));
  disc.degree = 2;
  refused(disc, "block: Degree = 2");

  BodyDescription plate = turned_plate(CellType::quadrilaterals, 2, 1.);
  set_conditions(plate, "left: displacement: 0, 0");
  plate.body_force = {Expression("2*3", {}, "test"), Expression("-1", {}, "test")};
  EXPECT_NO_THROW(indicator->check(FiniteElementBody(plate, {})));
  plate.body_force[1] = Expression("-1-x", {}, "test");
  refused(plate, "Body force = -1-x");
}

TEST(AdaptationBoundary, RefusesForcesAtPoints)
{
  for (const BoundarySolution kind : all_boundary_solutions)
  {
    BodyDescription description = turned_plate(CellType::quadrilaterals, 1, 1.);
    const std::string points = "(0,0): displacement: 0, 0; (3,0): displacement y: 0; ";
    // In balance by itself: the points carry nothing.
    set_conditions(description, points + "left: pressure: 0.2; right: pressure: 0.2");
    FiniteElementBody balanced(description, {});
    const CellErrors errors = estimate(balanced, kind);
    EXPECT_LT(errors.stress.norm(), accuracy(kind) * errors.stress_norm) << name_of(kind);
    EXPECT_NEAR(errors.stress_norm, .2 * std::sqrt(1.09 * 6.), 1e-4) << name_of(kind);

    set_conditions(description, points + "top: pressure: 0.2");
    FiniteElementBody loaded(description, {});
    EXPECT_THROW(estimate(loaded, kind), ComputationError) << name_of(kind);
    for (const auto &[other, without] : estimates(loaded))
      expect_no_boundary_elements(without);
  }
}

TEST(AdaptationBoundary, OtherIndicatorsHaveNoBoundaryElements)
{
  EXPECT_EQ(indicator_of("none"), nullptr);
  BodyDescription disc = make_body("disc", {1.}, {{4, 2}}); // curved, of degree 2: refused by fe-be
  disc.degree = 2;
  disc.young_modulus = 2.6;
  disc.poisson_ratio = .3;
  disc.body_force = {Expression("x", {}, "test"), Expression("y^2", {}, "test")};
  set_conditions(disc, "outer: displacement: 0, 0");
  FiniteElementBody body(disc, {});
  for (const auto &[kind, errors] : estimates(body))
    expect_no_boundary_elements(errors);
}

TEST(AdaptationBoundary, KeepsOperatorsForTheMesh)
{
  for (const BoundarySolution kind : all_boundary_solutions)
  {
    const auto body = pulled_plate();
    const FEBEIndicator indicator(kind);
    const CellErrors first = estimate(*body, indicator), second = estimate(*body, indicator);
    EXPECT_GT(first.boundary.assemble, 0.);
    EXPECT_EQ(second.boundary.assemble, 0.);
    EXPECT_EQ(first.boundary.unknowns, second.boundary.unknowns);
    EXPECT_EQ((as_rows(first.better) - as_rows(second.better)).norm(), 0.);

    refine_towards(*body, {3., 2.}, 1);
    const CellErrors refined = estimate(*body, indicator);
    EXPECT_GT(refined.boundary.assemble, 0.);
    EXPECT_GT(refined.boundary.elements, first.boundary.elements);
    EXPECT_EQ((as_rows(refined.better) - as_rows(estimate(*body, FEBEIndicator(kind)).better)).norm(), 0.);
    EXPECT_EQ(estimate(*body, indicator).boundary.assemble, 0.);
  }
}

TEST(AdaptationBoundary, KeepsTheBodiesApart)
{
  const FEBEIndicator indicator(BoundarySolution::trace_space);
  const auto one = pulled_plate();
  BodyDescription description = turned_plate(CellType::triangles, 1, 2.);
  set_conditions(description, "left: displacement: 0, 0; top: traction: 0.3, 0.1*x");
  FiniteElementBody other(description, {});
  const Eigen::MatrixX3d of_one = as_rows(estimate(*one, indicator).better),
                         of_other = as_rows(estimate(other, indicator).better);
  EXPECT_EQ((as_rows(estimate(*one, indicator).better) - of_one).norm(), 0.);
  EXPECT_EQ((as_rows(estimate(other, BoundarySolution::trace_space).better) - of_other).norm(), 0.);
  EXPECT_EQ(estimate(*one, indicator).boundary.assemble, 0.);
}
