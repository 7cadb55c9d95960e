// SPDX-License-Identifier: LGPL-2.1-or-later
// Ends of contact by the square root, and the reported pressure between the parts' places.
#include <abut/trace/pressure_curve.h>

#include <gtest/gtest.h>

#include "surface_testing.h"
#include <cmath>
#include <cstdlib>

using namespace abut;

namespace
{
  using Index = Eigen::Index;

  /// Twenty boxes and two half ones, cut from x = 20 to x = 0; the softer side carries.
  TestSurface line()
  {
    return TestSurface(make_line(21., 0., 0., 21), make_line(0., 21., 0., 21), .1);
  }

  double middle(const Part &part)
  {
    return .5 * (part.start + part.end);
  }

  /// Loads whose last four in [first, last] have force and moment of K sqrt(L - t) outwards from where they
  /// begin; the others are the same at their middles.
  Eigen::VectorXd root_loads(const Partition &partition, const std::size_t first, const std::size_t last,
                             const double amplitude, const double length)
  {
    const auto &parts = partition.parts();
    Eigen::VectorXd loads = Eigen::VectorXd::Zero(static_cast<Index>(parts.size()));
    const double start = parts[last - 3].start;
    double force = 2. / 3. * amplitude * std::pow(length, 1.5),
           moment = 4. / 15. * amplitude * std::pow(length, 2.5);
    for (std::size_t k = first; k <= last; ++k)
    {
      const double t = middle(parts[k]) - start;
      double &load = loads[static_cast<Index>(k)];
      load = amplitude * std::sqrt(std::max(0., length - t));
      if (k + 3 < last || k + 1 >= last)
        continue;
      force -= load * parts[k].length; // what is left for the last two
      moment -= load * parts[k].length * t;
    }
    if (last < 3 + first)
      return loads;
    const double a = middle(parts[last - 1]) - start, b = middle(parts[last]) - start;
    loads[static_cast<Index>(last - 1)] = (moment - b * force) / (a - b) / parts[last - 1].length;
    loads[static_cast<Index>(last)] = (moment - a * force) / (b - a) / parts[last].length;
    return loads;
  }
} // namespace

TEST(ContactEnds, AreThoseOfTheSquareRootWithTheSameForceAndMoment)
{
  const TestSurface surface = line();
  for (const double length : {3.4, 3.9, 4., 4.3})
  {
    const Eigen::VectorXd loads = root_loads(surface.partition, 0, 14, 7., length);
    ASSERT_GT(loads.head(15).minCoeff(), 0.);
    const auto ends = find_contact_ends(surface.partition, loads);
    ASSERT_EQ(ends.size(), 1u) << length; // the other one is that of the stretch
    EXPECT_EQ(ends[0].direction, 1);
    EXPECT_NEAR(ends[0].length, length, 1e-12);
    EXPECT_NEAR(ends[0].amplitude, 7., 1e-12);
    EXPECT_NEAR(ends[0].start, surface.parts()[11].start, 1e-12);
    EXPECT_NEAR(ends[0].beyond, length - 4., 1e-12);
    EXPECT_EQ(ends[0].parts, (std::vector<std::size_t>{11, 12, 13, 14, 15}));
  }
}

TEST(ContactEnds, AreTheSameInBothDirections)
{
  const TestSurface surface = line();
  const Eigen::VectorXd loads = root_loads(surface.partition, 0, 16, 2., 4.2);
  const auto ends = find_contact_ends(surface.partition, loads),
             mirrored = find_contact_ends(surface.partition, loads.reverse());
  ASSERT_EQ(ends.size(), 1u);
  ASSERT_EQ(mirrored.size(), 1u);
  EXPECT_EQ(mirrored[0].direction, -1);
  EXPECT_NEAR(mirrored[0].length, ends[0].length, 1e-12);
  EXPECT_NEAR(mirrored[0].start, 21. - ends[0].start, 1e-12);
}

TEST(ContactEnds, AreNoneWhereAStretchEndsOrThePressureIsNoRoot)
{
  const TestSurface surface = line();
  const auto n = static_cast<Index>(surface.parts().size());
  EXPECT_TRUE(find_contact_ends(surface.partition, Eigen::VectorXd::Zero(n)).empty());
  EXPECT_TRUE(find_contact_ends(surface.partition, Eigen::VectorXd::Ones(n)).empty());
  Eigen::VectorXd loads = Eigen::VectorXd::Zero(n);
  loads.segment(3, 2).setOnes(); // two parts say nothing
  EXPECT_TRUE(find_contact_ends(surface.partition, loads).empty());
  loads.setZero();
  for (Index k = 0; k < 12; ++k)
    loads[k] = 1. / std::sqrt(12. - static_cast<double>(k)); // as under the edge of a punch
  EXPECT_TRUE(find_contact_ends(surface.partition, loads).empty());
}

TEST(ContactEnds, GoRoundAClosedSide)
{
  const unsigned int n = 40;
  const TestSurface surface(make_arc(1., 0., 2. * M_PI, n, 1), make_arc(1.001, 2. * M_PI, 0., n, 1), 1., 2.);
  ASSERT_EQ(surface.parts().size(), n);
  ASSERT_TRUE(surface.partition.stretches()[0].closed);
  // The same contact at every place of the circle, over its start too.
  std::vector<double> lengths;
  for (unsigned int turned = 0; turned < n; ++turned)
  {
    Eigen::VectorXd loads = Eigen::VectorXd::Zero(n);
    for (unsigned int i = 0; i < 15; ++i)
      loads[(turned + i) % n] = std::sqrt(49. - std::pow(i - 7., 2.));
    loads[turned] = loads[(turned + 14) % n] = 1.;
    const auto ends = find_contact_ends(surface.partition, loads);
    ASSERT_EQ(ends.size(), 2u) << turned;
    for (const ContactEnd &end : ends)
      lengths.push_back(end.length);
    const PressureCurve curve(surface.partition, loads, true);
    const double there = curve.at_places()[(turned + 13) % n];
    EXPECT_GT(there, 0.);
    EXPECT_NEAR(there, curve.at_places()[(turned + 1) % n], 1e-9);
    EXPECT_NEAR(there,
                PressureCurve(surface.partition, loads, true)
                    .at((turned + 13) % n, surface.parts()[(turned + 13) % n].place_arc),
                1e-12);
  }
  for (const double length : lengths)
    EXPECT_NEAR(length, lengths[0], 1e-9);
}

TEST(PressureCurves, GoThroughWhatIsReportedAndStayBetweenIt)
{
  const TestSurface surface = line();
  std::srand(7);
  const auto n = static_cast<Index>(surface.parts().size());
  const Eigen::VectorXd loads = (Eigen::VectorXd::Random(n).array() + .3).max(0.);
  const PressureCurve curve(surface.partition, loads, false);
  EXPECT_EQ((curve.at_places() - surface.partition.reported_pressures(loads)).norm(), 0.);
  for (Index k = 0; k < n; ++k)
  {
    const Part &part = surface.parts()[static_cast<std::size_t>(k)];
    EXPECT_NEAR(curve.at(static_cast<std::size_t>(k), part.place_arc), curve.at_places()[k], 1e-12);
    const double largest =
        curve.at_places().segment(std::max<Index>(k - 1, 0), std::min<Index>(3, n - k)).maxCoeff();
    for (const double share : {0., .2, .5, .9, 1.})
    {
      const double value =
          curve.at(static_cast<std::size_t>(k), part.start + share * (part.end - part.start));
      EXPECT_GE(value, 0.);
      EXPECT_LE(value, largest + 1e-12);
    }
  }
}

TEST(PressureCurves, AreExactForUniformAndLinearPressures)
{
  const TestSurface surface = line();
  const auto n = static_cast<Index>(surface.parts().size());
  for (const double slope : {0., .3})
  {
    Eigen::VectorXd loads(n);
    for (Index k = 0; k < n; ++k)
      loads[k] = 10. - slope * middle(surface.parts()[static_cast<std::size_t>(k)]);
    const PressureCurve curve(surface.partition, loads, true);
    EXPECT_TRUE(curve.ends().empty());
    for (std::size_t k = 4; k + 4 < surface.parts().size(); ++k) // the means at ends are of half boxes
      for (const double share : {0., .3, 1.})
      {
        const Part &part = surface.parts()[k];
        const double arc = part.start + share * (part.end - part.start);
        EXPECT_NEAR(curve.at(k, arc), 10. - slope * arc, 1e-12);
      }
  }
}

TEST(PressureCurves, AreOfTheThirdOrderBetweenTheirPlaces)
{
  // What is reported of loads e^x is (1, 6, 1)/8 of three of them: a multiple of e^x. The polyline would be
  // of the second order.
  double before = 0.;
  for (const unsigned int n : {16u, 32u, 64u})
  {
    const TestSurface surface(make_line(1., 0., 0., n), make_line(0., 1., 0., n), .1);
    Eigen::VectorXd loads(static_cast<Index>(surface.parts().size()));
    for (Index k = 0; k < loads.size(); ++k)
      loads[k] = std::exp(surface.parts()[static_cast<std::size_t>(k)].place_arc);
    const PressureCurve curve(surface.partition, loads, true);
    const double multiple = (6. + 2. * std::cosh(1. / n)) / 8.;
    double largest = 0.;
    for (std::size_t k = 4; k + 4 < surface.parts().size(); ++k)
    {
      const double arc = surface.parts()[k].end;
      largest = std::max(largest, std::abs(curve.at(k, arc) - multiple * std::exp(arc)));
    }
    if (before > 0.)
    {
      EXPECT_GT(std::log2(before / largest), 2.5) << n;
    }
    before = largest;
  }
}

TEST(PressureCurves, EndWithTheRootUnlessThereIsAPenalty)
{
  const TestSurface surface = line();
  const double length = 4.3;
  const Eigen::VectorXd loads = root_loads(surface.partition, 0, 14, 7., length);
  const PressureCurve curve(surface.partition, loads, true), plain(surface.partition, loads, false);
  EXPECT_TRUE(plain.ends().empty());
  const double start = surface.parts()[11].start;
  for (std::size_t k = 11; k <= 15; ++k)
    for (const double share : {0., .4, .8})
    {
      const Part &part = surface.parts()[k];
      const double arc = part.start + share * (part.end - part.start);
      EXPECT_NEAR(curve.at(k, arc), 7. * std::sqrt(std::max(0., length - (arc - start))), 1e-11);
    }
  EXPECT_EQ(curve.at_places()[15], 0.); // it does not press
  EXPECT_EQ((curve.at_places() - plain.at_places()).head(11).norm(), 0.);
}
