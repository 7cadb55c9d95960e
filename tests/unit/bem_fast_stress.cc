// SPDX-License-Identifier: LGPL-2.1-or-later
// Expansions against sums: series that are moved, clusters, the stress inside whole bodies.
#include <abut/bem/fast_stress.h>

#include <gtest/gtest.h>

#include "bem_exact_field.h"
#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

using namespace abut;

namespace
{
  using Index = Eigen::Index;

  /// Sources with strengths t in a disc: the sums of Re(t) ln|z - zeta|, of t/(zeta - z), and the companion
  /// of the latter, for -conj(zeta - z) t/(zeta - z)^2.
  struct PointSources
  {
    Disc disc;
    std::vector<Complex> places, strengths;

    explicit PointSources(const Disc &around) : disc(around)
    {
      std::mt19937 random(7);
      std::uniform_real_distribution<double> part(-.7, .7);
      for (int i = 0; i < 9; ++i)
      {
        places.push_back(disc.centre + disc.radius * Complex(part(random), part(random)));
        strengths.emplace_back(part(random), part(random));
      }
    }

    HolomorphicSeries outgoing(const unsigned int order) const
    {
      HolomorphicSeries series = HolomorphicSeries::Zero(order + 1, 3);
      for (std::size_t i = 0; i < places.size(); ++i)
      {
        const Complex y = (places[i] - disc.centre) / disc.radius, t = strengths[i];
        series(0, 0) += t.real();
        for (Index k = 1; k <= order; ++k)
        {
          const auto n = static_cast<double>(k);
          series(k, 0) -= t.real() / n * std::pow(y, k);
          series(k, 1) -= t / disc.radius * std::pow(y, k - 1);
          if (k > 1)
            series(k, 2) -= (n - 1.) * std::conj(y) * t / disc.radius * std::pow(y, k - 2);
        }
      }
      return series;
    }

    std::array<Complex, 3> sums(const Complex z) const
    {
      std::array<Complex, 3> sums{};
      for (std::size_t i = 0; i < places.size(); ++i)
      {
        const Complex w = places[i] - z;
        sums[0] += strengths[i].real() * std::log(std::abs(w));
        sums[1] += strengths[i] / w;
        sums[2] -= std::conj(w) * strengths[i] / (w * w);
      }
      return sums;
    }
  };

  /// The same from a series: f(y) by powers of y or 1/y.
  std::array<Complex, 3> values(const HolomorphicSeries &series, const Disc &disc, const Complex z,
                                const bool incoming)
  {
    const Complex y = (z - disc.centre) / disc.radius;
    std::array<Complex, 3> f{};
    Complex slope = 0.; // of the Cauchy function
    for (Index k = 0; k < series.rows(); ++k)
    {
      const auto n = static_cast<double>(k);
      const Complex power = incoming ? std::pow(y, k) : std::pow(y, -k);
      for (std::size_t j = 0; j < 3; ++j)
        if (incoming || k > 0)
          f[j] += series(k, static_cast<Index>(j)) * power;
      slope += (incoming ? n : -n) * series(k, 1) * power / y / disc.radius;
    }
    if (!incoming)
      f[0] += series(0, 0) * std::log(std::abs(z - disc.centre));
    return {{f[0].real(), f[1], f[2] + std::conj(z - disc.centre) * slope}};
  }

  double difference(const std::array<Complex, 3> &a, const std::array<Complex, 3> &b)
  {
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
  }

  const std::vector<SeriesTranslation::Companions> companions = {{1, 2}};

  std::vector<Complex> tilted(std::vector<Complex> corners)
  {
    for (Complex &corner : corners)
      corner = Complex(.05, .02) + corner * std::polar(1., .3);
    return corners;
  }

  std::vector<std::vector<BoundaryElement>> fast_stress_bodies()
  {
    const std::vector<Complex> rectangle = {{0., 0.}, {.9, 0.}, {.9, .6}, {0., .6}},
                               strip = {{0., 0.}, {1., 0.}, {1., .01}, {0., .01}},
                               l_shape = {{0., -.5}, {.6, -.5}, {.6, .4}, {-.6, .4}, {-.6, 0.}, {0., 0.}};
    std::vector<std::vector<BoundaryElement>> all = {
        divided_polygon(tilted(rectangle), uniform_places(60)), divided_polygon(strip, uniform_places(50)),
        divided_polygon(rectangle, graded_places(20, 2.)), divided_polygon(l_shape, graded_places(15, 1.7)),
        divided_polygon(tilted(rectangle), uniform_places(30))};
    for (const BoundaryElement &element :
         divided_polygon(tilted({{.3, .2}, {.4, .4}, {.6, .3}}), graded_places(8, 1.7)))
      all.back().push_back(element);
    return all;
  }

  /// Along the inner side of all elements, and far inside.
  std::vector<Complex> points_along(const std::vector<BoundaryElement> &elements)
  {
    std::vector<Complex> points;
    for (const BoundaryElement &element : elements)
      for (const double distance : {1e-6, .01, .1, .5, 1.5, 4.})
        for (const double eta : {-.9, -.2, .6})
          points.push_back(element.point(eta) +
                           distance * element.length * Complex(0., 1.) * element.direction);
    return points;
  }

  double largest_difference(const std::vector<Stress> &a, const std::vector<Stress> &b)
  {
    double largest = 0.;
    for (std::size_t i = 0; i < a.size(); ++i)
      largest = std::max(largest, stress_distance(a[i], b[i]));
    return a.size() == b.size() ? largest : INFINITY;
  }
} // namespace

TEST(BemFastStress, SeriesConvergeAsTheyOught)
{
  const PointSources sources({{.3, .2}, .1});
  const Disc around{{.33, .17}, .16}, target{{.9, -.1}, .2}, inside{{.95, -.02}, .07};
  const Complex z(.97, .01), outside(.9, .5);
  ASSERT_TRUE(are_apart(around, target, .6));
  for (const unsigned int order : {4u, 8u, 16u, 32u})
  {
    const SeriesTranslation translation(order, companions);
    const auto zero = [&] { return HolomorphicSeries::Zero(order + 1, 3).eval(); };
    const HolomorphicSeries first = sources.outgoing(order);
    HolomorphicSeries second = zero(), third = zero(), fourth = zero();
    translation.out_to_out(first, sources.disc, around, second);
    translation.out_to_in(second, around, target, third);
    translation.in_to_in(third, target, inside, fourth);
    // Terms fall by 0.6 at most; a slope has a factor of the order, by the radius.
    const double tolerance = 1e-13 + 100. * (1. + order) * std::pow(.6, order);
    EXPECT_LT(difference(values(first, sources.disc, outside, false), sources.sums(outside)), tolerance);
    EXPECT_LT(difference(values(second, around, outside, false), sources.sums(outside)), tolerance);
    EXPECT_LT(difference(values(third, target, z, true), sources.sums(z)), tolerance) << order;
    EXPECT_LT(difference(values(fourth, inside, z, true), sources.sums(z)), tolerance) << order;
    // Moving inside loses nothing.
    EXPECT_LT(difference(values(fourth, inside, z, true), values(third, target, z, true)), 1e-12) << order;
  }
}

TEST(BemFastStress, ClustersHoldTheirMembers)
{
  std::mt19937 random(3);
  std::normal_distribution<double> place;
  std::vector<Disc> members(300, {{.1, .1}, .01}); // many in one place
  for (int i = 0; i < 1000; ++i)
    members.push_back({{place(random), .1 * place(random)}, .01 * std::abs(place(random))});
  const ClusterTree tree(members, 5);
  std::vector<std::size_t> sorted = tree.order();
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 0; i < sorted.size(); ++i)
    ASSERT_EQ(sorted[i], i);
  for (const ClusterTree::Cluster &cluster : tree.clusters())
  {
    for (std::size_t i = cluster.first; i < cluster.last; ++i)
    {
      const Disc &member = members[tree.order()[i]];
      EXPECT_LE(std::abs(member.centre - cluster.disc.centre) + member.radius,
                cluster.disc.radius * (1. + 1e-12));
    }
    if (cluster.is_leaf())
      EXPECT_TRUE(cluster.size() <= 5 || cluster.size() >= 300);
    else
    {
      EXPECT_EQ(tree.clusters()[cluster.children].first, cluster.first);
      EXPECT_EQ(tree.clusters()[cluster.children].last, tree.clusters()[cluster.children + 1].first);
      EXPECT_EQ(tree.clusters()[cluster.children + 1].last, cluster.last);
    }
  }
}

TEST(BemFastStress, IsAsAccurateAsAskedFor)
{
  for (const std::vector<BoundaryElement> &elements : fast_stress_bodies())
    for (unsigned int degree = 0; degree <= max_density_degree; degree += 2)
    {
      const ExactField field{.8, .3, .2, degree};
      const BoundaryValues boundary = field.values(elements);
      const std::vector<Complex> points = points_along(elements);
      const std::vector<Stress> expected = InteriorStress(elements, boundary, .8, .3).at(points);
      for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10})
        // Every point gets something from several clusters.
        EXPECT_LT(largest_difference(FastStress(elements, boundary, .8, .3, tolerance).at(points), expected),
                  3. * tolerance * field.scale(elements) + 1e-12)
            << elements.size() << " " << degree << " " << tolerance;
    }
}

TEST(BemFastStress, TakesAnyPoints)
{
  const std::vector<BoundaryElement> elements = fast_stress_bodies().front();
  const ExactField field{.8, .3};
  const FastStress fast(elements, field.values(elements), .8, .3, 1e-8);
  const InteriorStress exact(elements, field.values(elements), .8, .3);
  EXPECT_TRUE(fast.at({}).empty());
  const Complex inside(.4, .3);
  // One, many at one place, outside, far outside.
  for (const std::vector<Complex> &points : {std::vector<Complex>{inside}, std::vector<Complex>(500, inside),
                                             std::vector<Complex>{{-.3, .2}, inside, {1e6, 1.}}})
    EXPECT_LT(largest_difference(fast.at(points), exact.at(points)), 1e-8 * field.scale(elements));
}

TEST(BemFastStress, IsTheSameToTheLastBitWithManyPoints)
{
  // So many that threads share them, twice.
  const std::vector<BoundaryElement> elements = fast_stress_bodies().front();
  const ExactField field{.8, .3};
  const FastStress fast(elements, field.values(elements), .8, .3, 1e-6);
  std::vector<Complex> points;
  for (int i = 0; i < 100; ++i)
    for (int j = 0; j < 101; ++j)
      points.push_back(tilted({Complex(.0089 * (i + .5), .0059 * (j + .5))})[0]);
  EXPECT_EQ(largest_difference(fast.at(points), fast.at(points)), 0.);
}

TEST(BemFastStress, RefusesValuesThatDoNotFit)
{
  const std::vector<BoundaryElement> elements = fast_stress_bodies().front();
  BoundaryValues boundary = ExactField{.8, .3}.values(elements);
  boundary.slope.conservativeResize(Eigen::NoChange, 3);
  EXPECT_THROW(FastStress(elements, boundary, .8, .3, 1e-6), std::invalid_argument);
}
