// SPDX-License-Identifier: LGPL-2.1-or-later
// Parts of a surface: boxes of the carrying side, slivers, stretches, several sides, and what is reported.
#include <gtest/gtest.h>

#include "surface_testing.h"
#include <algorithm>
#include <random>

using namespace abut;

namespace
{
  using Index = Eigen::Index;

  /// The x at which parts begin and end, from left to right.
  std::vector<double> bounds(const TestSurface &surface)
  {
    std::vector<double> result;
    for (const Piece &piece : surface.pieces())
    {
      const Trace &cut = *surface.surface.cut[0].trace;
      const auto x = [&](const double s) { return cut.point(cut.segments()[piece.cut_segment], s).x(); };
      const Part &part = surface.parts()[piece.part];
      if (piece.arc == part.start)
        result.push_back(x(piece.start));
      if (std::abs(piece.arc + (piece.end - piece.start) * cut.segments()[piece.cut_segment].length -
                   part.end) < 1e-12)
        result.push_back(x(piece.end));
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end(),
                             [](const double a, const double b) { return std::abs(a - b) < 1e-12; }),
                 result.end());
    return result;
  }

  void expect_bounds(const TestSurface &surface, const std::vector<double> &expected)
  {
    const std::vector<double> found = bounds(surface);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i)
      EXPECT_NEAR(found[i], expected[i], 1e-10);
  }
} // namespace

TEST(TracePartition, PartsAreTheBoxesOfTheFinerSide)
{
  for (const bool fine_is_cut : {true, false})
  {
    const Trace fine = fine_is_cut ? make_line(3., 0., 0., 6) : make_line(0., 3., 0., 6);
    const Trace coarse = fine_is_cut ? make_line(0., 3., 0., 2) : make_line(3., 0., 0., 2);
    const TestSurface surface(fine_is_cut ? fine : coarse, fine_is_cut ? coarse : fine, fine_is_cut ? .1 : 1.,
                              fine_is_cut ? 1. : .1);
    expect_bounds(surface, {0., .25, .75, 1.25, 1.75, 2.25, 2.75, 3.});
    ASSERT_EQ(surface.partition.stretches().size(), 1u);
  }
}

TEST(TracePartition, BoxesFollowTheGaussLobattoWeights)
{
  const Trace coarse = make_line(0., 2., 0., 1);
  expect_bounds({make_line(2., 0., 0., 2, 2), coarse, .1}, {0., 1. / 6., 5. / 6., 7. / 6., 11. / 6., 2.});
  expect_bounds({make_line(2., 0., 0., 2, 3), coarse, .1},
                {0., 1. / 12., .5, 11. / 12., 13. / 12., 1.5, 23. / 12., 2.});
}

TEST(TracePartition, AStiffFineSideLeavesThePartsToTheOther)
{
  const Trace fine = make_line(3., 0., 0., 6), coarse = make_line(0., 3., 0., 3);
  const std::vector<double> fine_boxes = {0., .25, .75, 1.25, 1.75, 2.25, 2.75, 3.},
                            coarse_boxes = {0., .5, 1.5, 2.5, 3.};
  // Degree 1: E_f h_c <= 1.5 E_c h_f, with h_c = 2 h_f up to E_f = .75 E_c.
  expect_bounds({fine, coarse, .74}, fine_boxes);
  expect_bounds({fine, coarse, .75}, fine_boxes);
  expect_bounds({fine, coarse, .76}, coarse_boxes);
  expect_bounds({fine, coarse, 1e6}, coarse_boxes);
  expect_bounds({fine, coarse, .1, 1., Carrier::other}, coarse_boxes);
  expect_bounds({fine, coarse, 1e6, 1., Carrier::cut}, fine_boxes);
}

TEST(TracePartition, EquallyFineSidesLeaveThePartsToTheSofter)
{
  const Trace cut = make_line(3., 0., 0., 3), other = make_line(.5, 3.5, 0., 3);
  expect_bounds({cut, other, 1., 1.1}, {.5, 1.5, 2.5, 3.});
  expect_bounds({cut, other, 1.1, 1.}, {.5, 1., 2., 3.});
  expect_bounds({cut, other, 1., 1. + 1e-9}, {.5, 1.5, 2.5, 3.}); // equal but for round-off: the first
}

TEST(TracePartition, SliversJoinTheirNeighbours)
{
  const Trace cut = make_line(4., 0., 0., 4);
  for (const double cover : {.29, .1, 1e-3, 1e-6, 1e-12})
  {
    // Of the box [.5, 1.5], whole length 1, a share `cover` is covered.
    const Trace other = make_line(1.5 - cover, 4., 0., 2);
    expect_bounds({cut, other, 1., 1., Carrier::cut}, {1.5 - cover, 2.5, 3.5, 4.});
  }
  expect_bounds({cut, make_line(1.5 - .31, 4., 0., 2), 1., 1., Carrier::cut}, {1.19, 1.5, 2.5, 3.5, 4.});
  // Where there is no neighbour, a sliver stays.
  expect_bounds({cut, make_line(1.2, 1.2 + 1e-6, 0., 1), 1., 1., Carrier::cut}, {1.2, 1.2 + 1e-6});
  // What is left of sides that end where the others begin is round-off.
  EXPECT_TRUE(TestSurface(cut, make_line(4. - 1e-13, 5., 0., 1)).parts().empty());
}

TEST(TracePartition, WhichSideIsCutMakesNoDifference)
{
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> random(0., 1.);
  for (int trial = 0; trial < 200; ++trial)
  {
    const auto places = [&](const double from, const double to) {
      std::vector<double> result = {from, to};
      for (int i = 0; i < 6; ++i)
        result.push_back(from + (to - from) * random(generator));
      std::sort(result.begin(), result.end());
      return result;
    };
    const auto line = [&](std::vector<double> x, const bool above, const unsigned int degree) {
      if (!above) // the body lies below: from right to left
        std::reverse(x.begin(), x.end());
      return make_curve([](const double r) { return Vector2(r, 0.); }, x, degree, 1);
    };
    const double shift = random(generator) - .5, modulus = std::pow(10., 4. * random(generator) - 2.);
    const auto degree = static_cast<unsigned int>(1 + trial % 3);
    const std::vector<double> upper = places(0., 3.), lower = places(shift, 3. + shift);
    const Trace a = line(upper, true, degree), b = line(lower, false, degree);
    const TestSurface cut_a(a, b, modulus);
    const Surface swapped{{{&b, 1., 1, 0}}, {{&a, modulus, 0, 0}}, {{0, 0, 1e9, Carrier::automatic}}};
    const auto normals = common_normals(swapped);
    const Partition cut_b(swapped, normals);
    ASSERT_EQ(cut_a.parts().size(), cut_b.parts().size()) << trial;
    const std::size_t n = cut_b.parts().size();
    for (std::size_t k = 0; k < n; ++k)
    {
      EXPECT_NEAR(cut_a.parts()[k].middle.x(), cut_b.parts()[n - 1 - k].middle.x(), 1e-12) << trial;
      EXPECT_NEAR(cut_a.parts()[k].length, cut_b.parts()[n - 1 - k].length, 1e-12) << trial;
    }
  }
}

TEST(TracePartition, PartsCoverWhatIsCoveredOnce)
{
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> random(0., 1.);
  for (int trial = 0; trial < 100; ++trial)
  {
    const double from = 3. * random(generator), to = from + (4. - from) * random(generator);
    const auto degree = static_cast<unsigned int>(1 + trial % 3);
    const TestSurface surface(make_line(4., 0., 0., 7, degree), make_line(from, to, 0., 5, degree),
                              std::pow(10., 6. * random(generator) - 3.));
    EXPECT_NEAR(surface.covered(), to - from, 1e-12);
    double end = surface.parts().front().start;
    for (const Part &part : surface.parts())
    {
      EXPECT_GT(part.length, 0.);
      EXPECT_NEAR(part.start, end, 1e-12);
      EXPECT_NEAR(part.end - part.start, part.length, 1e-12);
      end = part.end;
    }
  }
}

TEST(TracePartition, AClosedCurveHasNoEnds)
{
  for (const unsigned int shift : {0u, 1u})
  {
    const double turn = shift * .1;
    const Trace disc = make_arc(1., turn, turn + 2. * M_PI, 12, 1),
                hole = make_arc(1.001, 2. * M_PI, 0., 12, 1);
    const TestSurface surface(disc, hole, 1., 2.);
    ASSERT_EQ(surface.partition.stretches().size(), 1u);
    EXPECT_TRUE(surface.partition.stretches()[0].closed);
    ASSERT_EQ(surface.parts().size(), 12u);
    for (const Part &part : surface.parts())
      EXPECT_NEAR(part.length, 2. * M_PI / 12., 1e-6);
    for (const auto &neighbours : surface.partition.neighbours())
      EXPECT_EQ(neighbours.size(), 2u);
  }
}

TEST(TracePartition, AStretchGoesOnAcrossTheStartOfAClosedCurve)
{
  const Trace disc = make_arc(1., -M_PI / 2., 1.5 * M_PI, 48, 1), flat = make_line(.6, -.6, -1., 7);
  const TestSurface surface(disc, flat);
  ASSERT_EQ(surface.partition.stretches().size(), 1u);
  EXPECT_FALSE(surface.partition.stretches()[0].closed);
  for (std::size_t k = 1; k < surface.parts().size(); ++k)
    EXPECT_GT(surface.parts()[k].middle.x(), surface.parts()[k - 1].middle.x());
}

TEST(TracePartition, OnePartLiesOnTwoOtherSides)
{
  // The cut side's middle segment lies half on each of two others, which are of two bodies.
  const Trace cut = make_line(0., 2., 1., 3), left = make_line(1., 0., 1., 1),
              right = make_line(2., 1., 1., 1);
  const auto partition_of = [&](const double modulus) {
    const Surface surface{{{&cut, modulus, 0, 0}},
                          {{&left, 1., 1, 0}, {&right, 1., 2, 0}},
                          {{0, 0, 1e9, Carrier::automatic}, {0, 1, 1e9, Carrier::automatic}}};
    return Partition(surface, common_normals(surface));
  };
  const Partition soft = partition_of(.1);
  EXPECT_EQ(soft.parts().size(), 4u); // the boxes of the cut side; no end at x = 1
  const Partition stiff = partition_of(100.);
  ASSERT_EQ(stiff.parts().size(), 4u); // two boxes on each other side: they end where these meet
  EXPECT_NEAR(stiff.parts()[1].end, 1., 1e-12);
}

TEST(TracePartition, StretchesEndAtSteps)
{
  // Two masters side by side, the second one lower by more than a tenth of a cell.
  for (const double step : {.01, .2})
  {
    const Trace cut = make_line(0., 2., 1., 2), left = make_line(1., 0., 1., 1),
                right = make_line(2., 1., 1. - step, 1);
    const Surface surface{{{&cut, 1., 0, 0}},
                          {{&left, 1., 1, 0}, {&right, 1., 2, 0}},
                          {{0, 0, 1e9, Carrier::cut}, {0, 1, 1e9, Carrier::cut}}};
    EXPECT_EQ(Partition(surface, common_normals(surface)).stretches().size(), step > .1 ? 2u : 1u);
  }
}

TEST(TracePartition, APartAtAPointHeldOnBothSidesJoinsItsNeighbour)
{
  const auto hold_left = [](Trace &trace) {
    std::vector<Eigen::Matrix2d> supports(trace.n_nodes(), Eigen::Matrix2d::Zero());
    for (std::size_t i = 0; i < trace.n_nodes(); ++i)
      if (trace.node_points()[i].x() == 0.)
        supports[i] = Eigen::Matrix2d::Identity();
    trace.set_supports(supports);
  };
  Trace cut = make_line(3., 0., 0., 3), other = make_line(0., 3., 0., 3);
  expect_bounds({cut, other}, {0., .5, 1.5, 2.5, 3.});
  hold_left(cut);
  expect_bounds({cut, other}, {0., .5, 1.5, 2.5, 3.});
  hold_left(other);
  expect_bounds({cut, other}, {0., 1.5, 2.5, 3.});
}

TEST(ReportedPressures, AreWhatTheNodesGet)
{
  const TestSurface surface(make_line(4., 0., 0., 4), make_line(0., 4., 0., 2), .1);
  Eigen::VectorXd loads(5);
  loads << 1., 8., 0., 16., 4.;
  const Eigen::VectorXd reported = surface.partition.reported_pressures(loads);
  EXPECT_NEAR(reported[1], (1. + 6. * 8. + 0.) / 8., 1e-13);
  EXPECT_EQ(reported[2], 0.); // a part that does not press
  EXPECT_NEAR(reported[3], (6. * 16. + 4.) / 8., 1e-13);
  EXPECT_NEAR(reported[0], 1. + .25 * 7., 1e-13); // of half a box at the end
}

TEST(ReportedPressures, KeepUniformPressuresAndAreNeverNegative)
{
  for (unsigned int degree = 1; degree <= 3; ++degree)
  {
    const TestSurface surface(make_line(4., 0., 0., 5, degree), make_line(.3, 3.1, 0., 4, degree));
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(static_cast<Index>(surface.parts().size()));
    EXPECT_LT((surface.partition.reported_pressures(ones) - ones).norm(), 1e-13);
    std::srand(3);
    const Eigen::VectorXd loads = (Eigen::VectorXd::Random(ones.size()) - .5 * ones).cwiseMax(0.);
    EXPECT_GE(surface.partition.reported_pressures(loads).minCoeff(), 0.);
  }
}
