// SPDX-License-Identifier: LGPL-2.1-or-later
// Fast boundary elements against sums over all pairs: the same estimate, the same marked cells.
#include <abut/adaptation/marking.h>

#include "boundary_elements_testing.h"

using namespace abut;

namespace
{
  constexpr double share = 1e-3;
  const BoundaryAccuracy all_pairs{0.}, always_fast{share, 0, 0};

  struct NamedBody
  {
    std::string name;
    BodyDescription description;
    Vector2 refined = {0., 1.}; ///< hanging nodes there
  };

  BodyDescription body_of(const std::string &shape, const std::vector<double> &size,
                          const std::array<unsigned int, 2> &cells, const std::string &conditions)
  {
    BodyDescription body = make_body(shape, size, cells);
    body.young_modulus = 2.6;
    body.poisson_ratio = .3;
    set_conditions(body, conditions);
    return body;
  }

  /// A clamped side, a re-entrant corner, two that float, one long and thin, one nearly incompressible.
  std::vector<NamedBody> fast_bodies()
  {
    std::vector<NamedBody> bodies = {
        {"clamped", body_of("rectangle", {3., 2.}, {{9, 6}},
                            "left: displacement: 0, 0; right: traction: 0.3, 0.1*y; top: pressure: 0.1")},
        {"corner", body_of("L-shape", {1.}, {{4, 4}}, "left: displacement: 0, 0; top: traction: 0, 0.2")},
        {"floating",
         body_of("rectangle", {3., 2.}, {{9, 6}},
                 "left: traction: -0.3*y^2, 0; right: traction: 0.3*y^2, 0; "
                 "top: pressure: 0.1*x*(3-x); bottom: pressure: 0.1*x*(3-x)"),
         {1.5, 1.}},
        {"thin",
         body_of("rectangle", {40., 1.}, {{80, 2}}, "left: displacement: 0, 0; top: pressure: 1e-3*(1+x)")},
        {"rollers", body_of("rectangle", {3., 2.}, {{9, 6}},
                            "left: normal displacement: 0; bottom: normal displacement: 0; "
                            "top: pressure: 0.1*x^2")}};
    bodies.push_back(bodies.back());
    bodies.back().name = "nearly incompressible";
    bodies.back().description.poisson_ratio = .4999;
    return bodies;
  }

  /// Of every strategy, with the cells that errors mark.
  std::vector<bool> marked(const CellErrors &errors, const std::string &marking)
  {
    AdaptationParameters parameters;
    parameters.marking = marking;
    parameters.limit = .05;
    parameters.fraction = .4;
    const CellMarks marks = mark(errors, relative_errors(errors, Normalisation::rms), parameters);
    return {marks.refine.begin(), marks.refine.end()};
  }

  void expect_the_same(const CellErrors &fast, const CellErrors &expected, const std::string &name)
  {
    const double estimate = expected.stress.norm();
    EXPECT_NE((fast.stress - expected.stress).norm(), 0.) << name; // fast at all
    EXPECT_LT((fast.stress - expected.stress).norm(), share * estimate) << name;
    EXPECT_LT((fast.energy - expected.energy).norm(), share * expected.energy.norm()) << name;
    EXPECT_NEAR(fast.stress_norm, expected.stress_norm, share * estimate) << name;
    for (const std::string marking : {"doerfler", "threshold"})
      EXPECT_EQ(marked(fast, marking), marked(expected, marking)) << name << ", " << marking;
    // A fixed number of cells may end among such as hardly differ: along a beam, or where errors are small.
    const std::vector<bool> by_fast = marked(fast, "fixed fraction"),
                            by_all = marked(expected, "fixed fraction");
    double least = estimate;
    for (std::size_t i = 0; i < by_all.size(); ++i)
      if (by_all[i])
        least = std::min(least, expected.stress[static_cast<Eigen::Index>(i)]);
    for (std::size_t i = 0; i < by_all.size(); ++i)
      if (by_fast[i] != by_all[i])
      {
        EXPECT_NEAR(expected.stress[static_cast<Eigen::Index>(i)], least, share * estimate)
            << name << ", " << i;
      }
  }
} // namespace

TEST(AdaptationFastFEBE, EstimatesAndMarksAsAllPairsDo)
{
  for (NamedBody &body : fast_bodies())
    for (const unsigned int degree : {1u, 2u, 3u})
    {
      body.description.degree = degree;
      FiniteElementBody elastic(body.description, {});
      refine_towards(elastic, body.refined, 2);
      for (const BoundarySolution kind : all_boundary_solutions)
        expect_the_same(estimate(elastic, FEBEIndicator(kind, always_fast)),
                        estimate(elastic, FEBEIndicator(kind, all_pairs)),
                        body.name + " of degree " + std::to_string(degree) + ", " + name_of(kind));
    }
}

TEST(AdaptationFastFEBE, LooksTwiceAtSmallErrors)
{
  // A displacement of degree 3 that finite elements nearly have: an error of 1e-5 of the stress.
  BodyDescription description = body_of("rectangle", {3., 2.}, {{6, 4}},
                                        "left: normal displacement: 0; bottom: normal displacement: 0; "
                                        "top: pressure: 0.2+1e-3*cos(2*x)");
  description.degree = 3;
  FiniteElementBody body(description, {});
  const CellErrors expected = estimate(body, FEBEIndicator(BoundarySolution::trace_space, all_pairs));
  ASSERT_LT(expected.stress.norm(), 1e-4 * expected.stress_norm);
  expect_the_same(estimate(body, FEBEIndicator(BoundarySolution::trace_space, always_fast)), expected,
                  "small error");
}

TEST(AdaptationFastFEBE, SmallBodiesKeepToTheBit)
{
  FiniteElementBody body(fast_bodies().front().description, {});
  const BoundarySolution kind = BoundarySolution::trace_space;
  const CellErrors small = estimate(body, FEBEIndicator(kind, {share, 1000, 1000})),
                   expected = estimate(body, FEBEIndicator(kind, all_pairs));
  EXPECT_EQ((small.stress - expected.stress).norm(), 0.);
}

TEST(AdaptationFastFEBE, KnowsHoles)
{
  BodyDescription ring =
      body_of("ring", {1., 2.}, {{24, 4}}, "outer: displacement: 0, 0; inner: pressure: 0.1*x^2");
  FiniteElementBody body(ring, {});
  for (const BoundarySolution kind : all_boundary_solutions)
    expect_the_same(estimate(body, FEBEIndicator(kind, always_fast)),
                    estimate(body, FEBEIndicator(kind, all_pairs)), "ring, " + name_of(kind));
}
