// SPDX-License-Identifier: LGPL-2.1-or-later
// Pieces of a slave curve, each opposite one master segment, and the projection between them.
#include <abut/trace/common_refinement.h>

#include <gtest/gtest.h>

#include "trace_testing.h"

using namespace abut;

namespace
{
  /// The pieces must follow one another along the slave, without gaps within a segment, and be opposite the
  /// segment they name.
  void expect_faithful(const std::vector<Piece> &pieces, const Trace &slave, const Trace &master)
  {
    for (std::size_t i = 0; i < pieces.size(); ++i)
    {
      const Piece &piece = pieces[i];
      EXPECT_LT(piece.start, piece.end);
      if (i > 0 && pieces[i - 1].slave_segment == piece.slave_segment)
      {
        EXPECT_EQ(pieces[i - 1].end, piece.start);
      }
      for (const double share : {1e-6, .3, .5, 1. - 1e-6})
      {
        const Segment &segment = slave.segments()[piece.slave_segment];
        const double s = piece.start + share * (piece.end - piece.start);
        const Vector2 x = slave.point(segment, s), n = Trace::averaged_normal(segment, s);
        const Segment &opposite = master.segments()[piece.master_segment];
        const Projection projection = project(master, opposite, x, n);
        EXPECT_GT(projection.t, -1e-9);
        EXPECT_LT(projection.t, 1. + 1e-9);
        EXPECT_LT((master.point(opposite, projection.t) - x - projection.gap * n).norm(), 1e-13);
      }
    }
  }

  double covered(const std::vector<Piece> &pieces, const Trace &slave)
  {
    double sum = 0.;
    for (const Piece &piece : pieces)
      sum += (piece.end - piece.start) * slave.segments()[piece.slave_segment].length;
    return sum;
  }
} // namespace

TEST(TraceRefinement, MatchingSidesPairOneToOne)
{
  const Trace slave = make_line(4., 0., 1., 7), master = make_line(0., 4., 1., 7);
  const auto pieces = common_refinement(slave, master);
  ASSERT_EQ(pieces.size(), 7u);
  for (std::size_t i = 0; i < 7; ++i)
  {
    EXPECT_EQ(pieces[i].slave_segment, i);
    EXPECT_EQ(pieces[i].master_segment, 6 - i);
    EXPECT_EQ(pieces[i].start, 0.);
    EXPECT_EQ(pieces[i].end, 1.);
  }
}

TEST(TraceRefinement, NonmatchingSidesAreCutAtBothSidesEnds)
{
  const std::pair<unsigned int, unsigned int> counts[] = {{2, 3}, {3, 2}, {5, 7}, {7, 5}, {1, 9}};
  for (const auto &[n, m] : counts)
  {
    const Trace slave = make_line(3., 0., 1., n), master = make_line(0., 3., 1.25, m);
    const auto pieces = common_refinement(slave, master);
    EXPECT_EQ(pieces.size(), n + m - 1); // n and m have no common divisor
    EXPECT_NEAR(covered(pieces, slave), 3., 1e-14);
    expect_faithful(pieces, slave, master);
    for (const Piece &piece : pieces)
    {
      // Ends lie on multiples of 3/n or of 3/m.
      const double x = 3. - (static_cast<double>(piece.slave_segment) + piece.end) * 3. / n;
      EXPECT_NEAR(std::min(std::abs(std::remainder(x, 3. / n)), std::abs(std::remainder(x, 3. / m))), 0.,
                  1e-14);
    }
  }
}

TEST(TraceRefinement, LeavesOutWhatNothingFaces)
{
  const Trace slave = make_line(4., 0., 1., 4), master = make_line(.3, 2.6, 1., 3);
  const auto pieces = common_refinement(slave, master);
  EXPECT_NEAR(covered(pieces, slave), 2.3, 1e-14);
  expect_faithful(pieces, slave, master);
  for (const Piece &piece : pieces)
    for (const double s : {piece.start, piece.end})
    {
      const double x = 4. - static_cast<double>(piece.slave_segment) - s;
      EXPECT_GT(x, .3 - 1e-14);
      EXPECT_LT(x, 2.6 + 1e-14);
    }
}

TEST(TraceRefinement, IsEmptyWhereNothingFaces)
{
  const Trace slave = make_line(1., 0., 1., 3);
  EXPECT_TRUE(common_refinement(slave, make_line(3., 5., 1., 3)).empty()) << "beside";
  EXPECT_TRUE(common_refinement(slave, make_line(1., 0., 2., 3)).empty()) << "the back of a body";
}

TEST(TraceRefinement, OverlappingBodiesPair)
{
  const Trace slave = make_line(3., 0., 1., 2), master = make_line(0., 3., .75, 3);
  const auto pieces = common_refinement(slave, master);
  EXPECT_NEAR(covered(pieces, slave), 3., 1e-14);
  for (const Piece &piece : pieces)
    EXPECT_NEAR(project(master, master.segments()[piece.master_segment],
                        slave.point(slave.segments()[piece.slave_segment], .5), Vector2(0., 1.))
                    .gap,
                -.25, 1e-15);
}

TEST(TraceRefinement, ClosedCurvesPairWithTheNearSide)
{
  const Trace disc = make_arc(1., 0., 2. * M_PI, 40, 1), hole = make_arc(1.1, 2. * M_PI, 0., 56, 1);
  for (const bool disc_is_slave : {true, false})
  {
    const Trace &slave = disc_is_slave ? disc : hole, &master = disc_is_slave ? hole : disc;
    const auto pieces = common_refinement(slave, master);
    expect_faithful(pieces, slave, master);
    EXPECT_NEAR(covered(pieces, slave), slave.length(), 1e-12);
    for (const Piece &piece : pieces)
    {
      const Segment &segment = slave.segments()[piece.slave_segment];
      const double s = .5 * (piece.start + piece.end);
      const Projection projection = project(master, master.segments()[piece.master_segment],
                                            slave.point(segment, s), Trace::averaged_normal(segment, s));
      EXPECT_NEAR(projection.gap, .1, 1e-6); // the far side would give 2.1
    }
  }
}

TEST(TraceRefinement, ProjectionOntoACircleIsExact)
{
  const Trace circle = make_arc(1., M_PI, 0., 96, 2); // a hole: its body lies outside
  unsigned int n_hits = 0;
  for (const Segment &segment : circle.segments())
  {
    const Vector2 point = .2 * Vector2(.6, .8), middle = circle.point(segment, .4);
    const Vector2 normal = (middle - point).normalized();
    // |point + g normal| = 1
    const double b = point.dot(normal), gap = -b + std::sqrt(b * b + 1. - point.squaredNorm());
    const Projection projection = project(circle, segment, point, normal);
    EXPECT_NEAR(projection.gap, gap, 1e-10);
    EXPECT_NEAR(projection.t, .4, 1e-10);
    ++n_hits;
  }
  EXPECT_EQ(n_hits, 96u);
}
