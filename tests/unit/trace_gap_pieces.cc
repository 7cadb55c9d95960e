// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/trace/gap_samples.h>

#include <gtest/gtest.h>

#include "surface_testing.h"
#include <algorithm>
#include <cmath>

using namespace abut;

namespace
{
  /// Lines of length 2 opposite each other, in equal segments. The surface runs from x = 2 to 0.
  struct Lines : TestSurface
  {
    Lines() : TestSurface(make_line(2., 0., 1., 5), make_line(0., 2., 1.1, 5)) {}
    GapPieces resolved(const GapFunction &gap) const
    {
      return resolved_pieces(surface, normals[0], partition, 0, gap);
    }
    /// The mean of the gap, as its quadrature points see it.
    double mean(const GapFunction &gap) const
    {
      const Coupling coupling =
          abut::couple(surface, normals[0], resolved(gap).pieces, parts().size(), 0, gap);
      return coupling.gap.sum() / coupling.weights.sum();
    }
  };

  GapFunction wave(const double length)
  {
    return [length](const Vector2 &x, const Opposite &) {
      return .5 * (1. - std::cos(2. * M_PI * x.x() / length));
    };
  }

  void expect_same(const std::vector<Piece> &pieces, const std::vector<Piece> &expected)
  {
    ASSERT_EQ(pieces.size(), expected.size());
    for (std::size_t i = 0; i < pieces.size(); ++i)
    {
      EXPECT_EQ(pieces[i].start, expected[i].start);
      EXPECT_EQ(pieces[i].end, expected[i].end);
      EXPECT_EQ(pieces[i].part, expected[i].part);
    }
  }
} // namespace

TEST(GapPieces, SmoothGapsLeaveThePieces)
{
  const Lines lines;
  const std::vector<Piece> pieces = pieces_of_link(lines.partition, 0).pieces;
  for (const GapFunction &gap : std::vector<GapFunction>{
           [](const Vector2 &, const Opposite &) { return .1; },
           [](const Vector2 &x, const Opposite &) { return x.x() * x.x() / 20. - .003; }, wave(2.)})
  {
    const GapPieces found = lines.resolved(gap);
    expect_same(found.pieces, pieces);
    EXPECT_TRUE(found.steps.empty());
  }
}

TEST(GapPieces, WavesWithinThemAreFollowed)
{
  // The first of these look flat at five equally spaced points of a segment.
  const Lines lines;
  for (const double length : {.1, .05, .08, .2})
  {
    EXPECT_NEAR(lines.mean(wave(length)), .5, .01) << length;
    const GapPieces found = lines.resolved(wave(length));
    const GapSamples samples = sample_gaps(lines.surface, lines.normals[0], found.pieces, 0, wave(length));
    EXPECT_LT(samples.gap.minCoeff(), .05);
    EXPECT_GT(samples.gap.maxCoeff(), .95);
    EXPECT_TRUE(found.steps.empty());
  }
}

TEST(GapPieces, StepsAreFoundWhereTheyAre)
{
  const Lines lines;
  for (const double place : {.03, .4, 1.37})
  {
    const GapPieces found = lines.resolved(
        [place](const Vector2 &x, const Opposite &) { return x.x() > place ? x.x() : x.x() + .01; });
    ASSERT_EQ(found.steps.size(), 1u) << place;
    EXPECT_NEAR(found.steps[0].place.x(), place, 1e-6);
    EXPECT_NEAR(found.steps[0].height, .01, 1e-6);
    const Part &part = lines.parts()[found.steps[0].part];
    EXPECT_GE(2. - place, part.start - 1e-9);
    EXPECT_LE(2. - place, part.end + 1e-9);
  }
  const GapPieces ramp = lines.resolved(
      [](const Vector2 &x, const Opposite &) { return std::clamp(10. * (x.x() - .7), 0., .1); });
  EXPECT_TRUE(ramp.steps.empty());
}
