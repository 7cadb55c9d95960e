// SPDX-License-Identifier: LGPL-2.1-or-later
// Pieces of a curve, each opposite one segment of another, and the common normal that pairs them.
#include <gtest/gtest.h>

#include "surface_testing.h"

using namespace abut;

namespace
{
  std::vector<Piece> refinement(const Trace &cut, const Trace &other, const double deepest = 1e9)
  {
    const Surface surface{{{&cut, 1., 0, 0}}, {{&other, 1., 1, 0}}, {{0, 0, deepest, Carrier::automatic}}};
    return common_refinement(surface, common_normals(surface));
  }

  /// The pieces must follow one another along the cut side, without gaps within a segment, and be opposite
  /// the segment they name: on the line along the common normal.
  void expect_faithful(const std::vector<Piece> &pieces, const Trace &cut, const Trace &other)
  {
    const CommonNormal normal(cut, other);
    for (std::size_t i = 0; i < pieces.size(); ++i)
    {
      const Piece &piece = pieces[i];
      EXPECT_LT(piece.start, piece.end);
      if (i > 0 && pieces[i - 1].cut_segment == piece.cut_segment)
      {
        EXPECT_EQ(pieces[i - 1].end, piece.start);
      }
      for (const double share : {1e-6, .3, .5, 1. - 1e-6})
      {
        const double s = piece.start + share * (piece.end - piece.start);
        const Vector2 x = cut.point(cut.segments()[piece.cut_segment], s);
        const Opposite opposite = normal.project(piece.cut_segment, s, piece.other_segment);
        EXPECT_GT(opposite.t, -1e-9);
        EXPECT_LT(opposite.t, 1. + 1e-9);
        const Vector2 y = other.point(other.segments()[piece.other_segment], opposite.t);
        EXPECT_LT((y - x - opposite.gap * opposite.normal).norm(), 1e-13);
      }
    }
  }

  double covered(const std::vector<Piece> &pieces, const Trace &cut)
  {
    double sum = 0.;
    for (const Piece &piece : pieces)
      sum += (piece.end - piece.start) * cut.segments()[piece.cut_segment].length;
    return sum;
  }
} // namespace

TEST(TraceRefinement, MatchingSidesPairOneToOne)
{
  const Trace cut = make_line(4., 0., 1., 7), other = make_line(0., 4., 1., 7);
  const auto pieces = refinement(cut, other);
  ASSERT_EQ(pieces.size(), 7u);
  for (std::size_t i = 0; i < 7; ++i)
  {
    EXPECT_EQ(pieces[i].cut_segment, i);
    EXPECT_EQ(pieces[i].other_segment, 6 - i);
    EXPECT_EQ(pieces[i].start, 0.);
    EXPECT_EQ(pieces[i].end, 1.);
  }
}

TEST(TraceRefinement, NonmatchingSidesAreCutAtBothSidesEnds)
{
  const std::pair<unsigned int, unsigned int> counts[] = {{2, 3}, {3, 2}, {5, 7}, {7, 5}, {1, 9}};
  for (const auto &[n, m] : counts)
  {
    const Trace cut = make_line(3., 0., 1., n), other = make_line(0., 3., 1.25, m);
    const auto pieces = refinement(cut, other);
    EXPECT_EQ(pieces.size(), n + m - 1); // n and m have no common divisor
    EXPECT_NEAR(covered(pieces, cut), 3., 1e-14);
    expect_faithful(pieces, cut, other);
    for (const Piece &piece : pieces)
    {
      // Ends lie on multiples of 3/n or of 3/m.
      const double x = 3. - (static_cast<double>(piece.cut_segment) + piece.end) * 3. / n;
      EXPECT_NEAR(std::min(std::abs(std::remainder(x, 3. / n)), std::abs(std::remainder(x, 3. / m))), 0.,
                  1e-14);
    }
  }
}

TEST(TraceRefinement, LeavesOutWhatNothingFaces)
{
  const Trace cut = make_line(4., 0., 1., 4), other = make_line(.3, 2.6, 1., 3);
  const auto pieces = refinement(cut, other);
  EXPECT_NEAR(covered(pieces, cut), 2.3, 1e-14);
  expect_faithful(pieces, cut, other);
  for (const Piece &piece : pieces)
    for (const double s : {piece.start, piece.end})
    {
      const double x = 4. - static_cast<double>(piece.cut_segment) - s;
      EXPECT_GT(x, .3 - 1e-14);
      EXPECT_LT(x, 2.6 + 1e-14);
    }
}

TEST(TraceRefinement, IsEmptyWhereNothingFaces)
{
  const Trace cut = make_line(1., 0., 1., 3);
  EXPECT_TRUE(refinement(cut, make_line(3., 5., 1., 3)).empty()) << "beside";
  EXPECT_TRUE(refinement(cut, make_line(1., 0., 2., 3)).empty()) << "the back of a body";
}

TEST(TraceRefinement, OverlappingBodiesPairAsFarAsTheyMay)
{
  const Trace cut = make_line(3., 0., 1., 2), other = make_line(0., 3., .75, 3);
  const auto pieces = refinement(cut, other);
  EXPECT_NEAR(covered(pieces, cut), 3., 1e-14);
  for (const Piece &piece : pieces)
    EXPECT_NEAR(CommonNormal(cut, other)
                    .project(piece.cut_segment, .5 * (piece.start + piece.end), piece.other_segment)
                    .gap,
                -.25, 1e-15);
  EXPECT_FALSE(refinement(cut, other, .26).empty());
  EXPECT_TRUE(refinement(cut, other, .24).empty());
}

TEST(TraceRefinement, ClosedCurvesPairWithTheNearSide)
{
  const Trace disc = make_arc(1., 0., 2. * M_PI, 40, 1), hole = make_arc(1.1, 2. * M_PI, 0., 56, 1);
  for (const bool disc_is_cut : {true, false})
  {
    const Trace &cut = disc_is_cut ? disc : hole, &other = disc_is_cut ? hole : disc;
    const auto pieces = refinement(cut, other);
    expect_faithful(pieces, cut, other);
    EXPECT_NEAR(covered(pieces, cut), cut.length(), 1e-12);
    const CommonNormal normal(cut, other);
    for (const Piece &piece : pieces)
      EXPECT_NEAR(normal.project(piece.cut_segment, .5 * (piece.start + piece.end), piece.other_segment).gap,
                  .1,
                  1e-6); // the far side would give 2.1
  }
}

namespace
{
  /// All of them, one by one.
  std::vector<double> places_one_by_one(const CommonNormal &normal, const Trace &other, const std::size_t i)
  {
    std::vector<double> places;
    for (std::size_t j = 0; j < other.segments().size(); ++j)
      for (const double t : {0., 1.})
        if (const auto place = normal.place_opposite(i, j, t))
          places.push_back(*place);
    return places;
  }
} // namespace

TEST(CommonNormal, BlocksOfSegmentsLeaveNothingOut)
{
  const auto wave = [](const double height, const double first, const double last, const unsigned int n) {
    return make_curve([=](const double x) { return Vector2(x, height + .1 * std::sin(9. * x)); },
                      parameters(first, last, n), 1, 3);
  };
  const std::pair<Trace, Trace> pairs[] = {
      {make_line(4., 0., 1., 130), make_line(0., 4., 1.01, 87)},
      {make_arc(1., 0., 2. * M_PI, 150, 1), make_arc(1.02, 2. * M_PI, 0., 90, 1)},
      {make_arc(1., .2, 2.9, 140, 2), make_line(-3., 3., 1.1, 77)},
      {wave(1., 3., 0., 120), wave(1.1, -1., 4., 211)},
      {make_arc(2., .1, 3., 101, 1), wave(2.2, -3., 3., 99)}};
  for (const auto &[cut, other] : pairs)
  {
    const CommonNormal normal(cut, other);
    std::size_t n_places = 0;
    for (std::size_t i = 0; i < cut.segments().size(); ++i)
    {
      const std::vector<double> expected = places_one_by_one(normal, other, i);
      EXPECT_EQ(normal.places_opposite_ends(i), expected) << i;
      n_places += expected.size();
    }
    EXPECT_GT(n_places, 50u);
  }
}

TEST(CommonNormal, IsThatOfTheFlatSide)
{
  const Trace flat = make_line(3., -3., -1., 6), disc = make_arc(1., M_PI, 2. * M_PI, 24, 1);
  for (const bool disc_is_cut : {true, false})
  {
    const Trace &cut = disc_is_cut ? disc : flat, &other = disc_is_cut ? flat : disc;
    const CommonNormal normal(cut, other);
    for (const Piece &piece : refinement(cut, other))
    {
      const Opposite opposite =
          normal.project(piece.cut_segment, .5 * (piece.start + piece.end), piece.other_segment);
      if (std::abs(cut.point(cut.segments()[piece.cut_segment], piece.start).x()) > .5)
        continue;
      // The flat side has ends: a share of epsilon times the disc's radius by their distance remains.
      EXPECT_LT((opposite.normal - Vector2(0., disc_is_cut ? -1. : 1.)).norm(), 1e-6);
    }
  }
}

TEST(CommonNormal, IsThatOfAConcaveSide)
{
  // A ball in a shallower seat: the seat's normal leads to its centre.
  const Vector2 centre(0., .5);
  const Trace ball = make_arc(1., M_PI, 2. * M_PI, 24, 1);
  const auto seat_place = [&](const double angle) -> Vector2 {
    return centre + 1.5 * Vector2(std::cos(angle), std::sin(angle));
  };
  const Trace seat = make_curve(seat_place, parameters(-.2, -M_PI + .2, 30), 1, 4);
  const CommonNormal normal(ball, seat);
  for (const Piece &piece : refinement(ball, seat))
  {
    const double s = .5 * (piece.start + piece.end);
    const Vector2 x = ball.point(ball.segments()[piece.cut_segment], s);
    if (std::abs(x.x()) > .5)
      continue;
    const Opposite opposite = normal.project(piece.cut_segment, s, piece.other_segment);
    EXPECT_LT((opposite.normal - (x - centre).normalized()).norm(), 1e-4);
    EXPECT_NEAR((x + opposite.gap * opposite.normal - centre).norm(), 1.5, 1e-6);
  }
}

TEST(CommonNormal, DiscsPairAlongOneDirection)
{
  // Of two circles: points with the same share of turning, n constant (the line of centres).
  const Trace upper = make_arc(1., M_PI, 2. * M_PI, 24, 1);
  const auto lower_place = [](const double angle) -> Vector2 {
    return Vector2(0., -3.) + 2. * Vector2(std::cos(angle), std::sin(angle));
  };
  const Trace lower = make_curve(lower_place, parameters(0., M_PI, 30), 1, 4);
  const CommonNormal normal(upper, lower);
  for (const Piece &piece : refinement(upper, lower))
  {
    const double s = .5 * (piece.start + piece.end);
    if (std::abs(upper.point(upper.segments()[piece.cut_segment], s).x()) > .4)
      continue;
    const Opposite opposite = normal.project(piece.cut_segment, s, piece.other_segment);
    EXPECT_LT((opposite.normal - Vector2(0., -1.)).norm(), 1e-4);
  }
}

TEST(CommonNormal, IsTheFacesAtACorner)
{
  // A square that stands on its corner: both of its faces pair along the normal of the face below, in their
  // last segments as well.
  const auto corner = [](const double r) -> Vector2 { return Vector2(r, .1 + std::abs(r)); };
  std::vector<double> places = parameters(-1., 1., 8);
  const Trace square = make_curve(corner, places, 1, 1);
  const Trace face = make_line(3., -3., 0., 6);
  for (const bool square_is_cut : {true, false})
  {
    const Trace &cut = square_is_cut ? square : face, &other = square_is_cut ? face : square;
    const CommonNormal normal(cut, other);
    double nearest = 1e9;
    for (const Piece &piece : refinement(cut, other))
      for (const double s : {piece.start, piece.end})
      {
        const Opposite opposite = normal.project(piece.cut_segment, s, piece.other_segment);
        nearest = std::min(nearest, opposite.gap);
        if (std::abs(cut.point(cut.segments()[piece.cut_segment], s).x()) < .2)
        {
          EXPECT_GT(std::abs(opposite.normal.y()), .999);
        }
      }
    EXPECT_NEAR(nearest, .1, 1e-3);
  }
}

TEST(CommonNormal, WhichSideIsCutMakesNoDifference)
{
  const Trace disc = make_arc(1., M_PI, 2. * M_PI, 24, 1);
  const auto hill_place = [](const double x) -> Vector2 { return Vector2(x, -1.02 - .1 * x * x); };
  const Trace hill = make_curve(hill_place, parameters(2., -2., 30), 1, 4);
  const CommonNormal there(disc, hill), back(hill, disc);
  unsigned int n_compared = 0;
  for (const Piece &piece : refinement(disc, hill))
  {
    const double s = .5 * (piece.start + piece.end);
    const Opposite opposite = there.project(piece.cut_segment, s, piece.other_segment);
    if (opposite.t < .01 || opposite.t > .99)
      continue;
    const Opposite again = back.project(piece.other_segment, opposite.t, piece.cut_segment);
    EXPECT_NEAR(again.t, s, 1e-9);
    EXPECT_NEAR(again.gap, opposite.gap, 1e-12);
    EXPECT_LT((again.normal + opposite.normal).norm(), 1e-9);
    ++n_compared;
  }
  EXPECT_GT(n_compared, 20u);
}
