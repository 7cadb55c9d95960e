// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Pairs of sides that have been got wrong without a word, at their right values. Inputs: tests/data/cases.
#include <gtest/gtest.h>

#include "program.h"
#include <algorithm>
#include <cmath>

using namespace abut::testing;

namespace
{
  double value(const Answer &answer, const std::string &name, const std::string &key)
  {
    return contact(answer, name)[key].get<double>();
  }

  /// The largest alternating part of the reported pressures over their peak, inside a share of the contact.
  double roughness(const Answer &answer, const std::string &name)
  {
    const std::string path = answer.directory + "/contact_" + name + ".csv";
    const auto p = column(path, "pressure");
    const double peak = *std::max_element(p.begin(), p.end());
    double largest = 0.;
    for (std::size_t i = 2; i + 2 < p.size(); ++i)
      if (std::min(p[i - 2], p[i + 2]) > .5 * peak)
        largest =
            std::max(largest, std::abs(p[i - 2] - 4. * p[i - 1] + 6. * p[i] - 4. * p[i + 1] + p[i + 2]));
    return largest / 16. / peak;
  }
} // namespace

TEST(ContactCases, ACornerAboveAFaceDoesNotPress)
{
  for (const std::string degree : {"1", "2", "3"})
    for (const bool swapped : {false, true})
    {
      std::vector<std::string> overrides = {"Discretisation/Degree=" + degree};
      if (swapped)
        overrides.insert(overrides.end(), {"Contact r/Slave=square:bottom", "Contact r/Master=block:top"});
      const Answer answer = run_case("corner-on-face", overrides);
      ASSERT_EQ(answer.status, 0) << answer.err;
      EXPECT_EQ(value(answer, "r", "normal_force"), 0.);
      EXPECT_GE(value(answer, "r", "min_gap"), .02);
      EXPECT_EQ(warning_codes(answer), std::multiset<std::string>{"nothing-touches"});
    }
}

TEST(ContactCases, ACornerIsFoundOrNamed)
{
  for (const bool swapped : {false, true})
    for (const int n : {20, 80, 160})
    {
      std::vector<std::string> overrides = {
          "Body punch/Cells=" + std::to_string(n) + ", " + std::to_string(n),
          "Body block/Cells=" + std::to_string(3 * n / 2) + ", " + std::to_string(n / 2)};
      if (swapped)
        overrides.insert(overrides.end(), {"Contact r/Slave=punch:bottom", "Contact r/Master=block:top"});
      const Answer answer = run_case("corner-on-face-tilted", overrides);
      ASSERT_EQ(answer.status, 0) << answer.err;
      const auto force = contact(answer, "r")["force"];
      const double size = std::abs(force[1].get<double>());
      if (size == 0.)
      {
        EXPECT_NE(answer.err.find("the bodies overlap by up to 0.00299 at (0.03, 1)"), std::string::npos)
            << answer.err;
      }
      if (n > 20)
      {
        EXPECT_NEAR(size, .24, .024) << n;
      }
      EXPECT_LE(std::abs(force[0].get<double>()), 5e-4 * .24); // along the face
    }
}

TEST(ContactCases, ASliverOfCoverMakesNoPeak)
{
  for (const std::string size : {"1", "1.0001", "1.001", "1.02"})
    for (const bool swapped : {false, true})
    {
      std::vector<std::string> overrides = {"Body punch/Size=" + size + ", 1"};
      if (swapped)
        overrides.insert(overrides.end(), {"Contact c/Slave=punch:bottom", "Contact c/Master=block:top"});
      const Answer answer = run_case("edge-dropping", overrides);
      ASSERT_EQ(answer.status, 0) << answer.err;
      // The punch of width 1; a wider one carries as much more.
      EXPECT_NEAR(value(answer, "c", "normal_force"), 4.693 * std::stod(size), .005 * 4.693) << size;
      // Under the edge it is infinite: the mean over a part that is covered by .3 to 1.3 of a box.
      EXPECT_GT(value(answer, "c", "max_pressure"), 7.) << size;
      EXPECT_LT(value(answer, "c", "max_pressure"), 13.) << size;
      if (size == "1.0001")
      {
        EXPECT_NEAR(value(answer, "c", "max_pressure"), 10.2, .05);
      }
    }
}

TEST(ContactCases, ThreeBlocks)
{
  for (const std::string degree : {"1", "2", "3"})
    for (const std::string cells : {"3, 1", "5, 2", "7, 3"})
    {
      const Answer answer =
          run_case("three-blocks", {"Discretisation/Degree=" + degree, "Body upper/Cells=" + cells});
      ASSERT_EQ(answer.status, 0) << answer.err;
      for (const std::string name : {"ul", "ur"})
      {
        for (const std::string what : {"pressure", "load"})
          for (const double p : column(answer.directory + "/contact_" + name + ".csv", what))
            EXPECT_NEAR(p, 12., 12e-9);
        EXPECT_NEAR(value(answer, name, "contact_length"), 1., 1e-12);
        EXPECT_NEAR(value(answer, name, "normal_force"), 12., 12e-9);
      }
    }
}

TEST(ContactCases, TwoPairsThatShareANode)
{
  for (const std::string degree : {"1", "2", "3"})
    for (const bool swapped : {false, true})
    {
      std::vector<std::string> overrides = {"Discretisation/Degree=" + degree};
      for (const auto &[body, file] :
           {std::pair("upper", "two-pairs-upper.msh"), {"lower", "two-pairs-lower.msh"}})
        overrides.push_back(std::string("Body ") + body + "/Mesh file=" + project_file("tests/data/cases/") +
                            file);
      if (swapped) // one of the pairs
        overrides.insert(overrides.end(), {"Contact l/Slave=upper:1", "Contact l/Master=lower:4"});
      const Answer answer = run_case("two-pairs-a-node", overrides);
      ASSERT_EQ(answer.status, 0) << answer.err;
      for (const std::string name : {"l", "r"})
      {
        EXPECT_NEAR(value(answer, name, "normal_force"), 16. / 3., 16e-9 / 3.);
        EXPECT_NEAR(value(answer, name, "max_pressure"), 16. / 3., 16e-9 / 3.);
      }
    }
}

TEST(ContactCases, AFineSlaveIsSmooth)
{
  const Answer one = run_case("fine-slave");
  ASSERT_EQ(one.status, 0) << one.err;
  EXPECT_NEAR(value(one, "c", "max_pressure"), 2.570, .005 * 2.570);
  EXPECT_LT(roughness(one, "c"), .005);
  for (const std::string degree : {"2", "3"})
  {
    const Answer answer = run_case("fine-slave", {"Discretisation/Degree=" + degree});
    ASSERT_EQ(answer.status, 0) << answer.err;
    EXPECT_NEAR(value(answer, "c", "max_pressure"), 2.570, .002 * 2.570);
    EXPECT_LT(roughness(answer, "c"), .005);
  }
}

TEST(ContactCases, AStiffFineSlaveIsSmooth)
{
  const Answer one = run_case("stiff-slave");
  ASSERT_EQ(one.status, 0) << one.err;
  // Five parts in contact: the peak of degree 3 within what a coarse mesh allows.
  EXPECT_NEAR(value(one, "interface", "max_pressure"), 234., .02 * 234.);
  EXPECT_LT(one.summary["true_error"]["force"].get<double>(), .015);
  const Answer three =
      run_case("stiff-slave", {"Body lower/Degree=3", "Body upper/Degree=3", "Adaptation/Estimator=none"});
  ASSERT_EQ(three.status, 0) << three.err;
  EXPECT_NEAR(value(three, "interface", "max_pressure"), 234., .002 * 234.);
  EXPECT_LT(three.summary["true_error"]["force"].get<double>(), 1e-3);
  EXPECT_LT(roughness(three, "interface"), .01);
}

TEST(ContactCases, OverlapAtAPointHeldOnBothSidesIsRefused)
{
  for (const std::string cells : {"16, 8", "24, 12", "36, 18", "48, 24"})
    for (const std::string degree : {"1", "2"})
    {
      const Answer answer =
          run_case("held-node", {"Body lower/Cells=" + cells, "Discretisation/Degree=" + degree});
      expect_refused(answer,
                     {"Contact c: at (0, 1) supports hold both bodies, and make them overlap by 0.001"});
    }
  const Answer touching = run_case("held-node", {"Contact c/Gap=0"});
  EXPECT_EQ(touching.status, 0) << touching.err;
  EXPECT_LT(value(touching, "c", "max_pressure"), 1.5); // under a pressure of 1
}

TEST(ContactCases, ADiscAsSlaveInAGrooveIsThatOfStatics)
{
  // Angles of the flanks; the disc's weight is 3 pi but for its mesh's share.
  const auto radians = [](const double degrees) { return degrees * std::acos(-1.) / 180.; };
  for (const std::string modulus : {"1e5", "9.42e5"}) // 1e4 and 1e5 times the weight by the radius
    for (const auto &[left, right] : {std::pair(1., 60.), {10., 75.}, {85., 85.}})
    {
      const auto placed = [&](const std::string &body, const double angle) {
        // A block of 3 x 1 whose top touches the unit disc at its middle.
        const double c = std::cos(radians(angle)), s = std::sin(radians(angle));
        std::ostringstream shift;
        shift.precision(17);
        shift << "Body " << body << "/Shift=" << s - 1.5 * c + s << ", " << -c - 1.5 * s - c;
        return shift.str();
      };
      const Answer answer = run_case(
          "v-groove-slave", {"Body disc/Young modulus=" + modulus,
                             "Body left/Rotation angle=" + std::to_string(-left), placed("left", -left),
                             "Body right/Rotation angle=" + std::to_string(right), placed("right", right)});
      ASSERT_EQ(answer.status, 0) << answer.err;
      const double weight = 3. * 2. * 32. * std::sin(std::acos(0.) / 32.);
      const double of_left = weight * std::sin(radians(right)) / std::sin(radians(left + right)),
                   of_right = weight * std::sin(radians(left)) / std::sin(radians(left + right));
      EXPECT_NEAR(value(answer, "lf", "normal_force"), of_left, .01 * of_left) << left << ' ' << right;
      EXPECT_NEAR(value(answer, "rf", "normal_force"), of_right, .01 * of_right) << left << ' ' << right;
      expect_balance(answer);
    }
}

TEST(ContactCases, NothingResistsASideLoadBetweenFlatPlates)
{
  expect_refused(run_case("cord"),
                 {"Body cord", "translation along (1, 0)", "no contact resists this motion"});
  const Answer alone = run_case("cord", {"Body cord/Body force=0, 0"});
  ASSERT_EQ(alone.status, 0) << alone.err;
  for (const std::string name : {"below", "above"})
  {
    const auto force = contact(alone, name)["force"];
    EXPECT_LT(std::abs(force[0].get<double>()), 1e-6 * std::abs(force[1].get<double>()));
  }
}

TEST(ContactCases, ACoatingThinnerThanTheGapElsewhere)
{
  const Answer answer = run_case("thin-coating"),
               deep = run_case("thin-coating", {"Body lower/Contact depth=1"});
  ASSERT_EQ(answer.status, 0) << answer.err;
  EXPECT_NEAR(value(answer, "interface", "normal_force") / value(deep, "interface", "normal_force"), 1.,
              1e-9);
  EXPECT_GT(value(answer, "interface", "normal_force"), 100.);
}

TEST(ContactCases, ACostlyInterfaceBecomesAMatrix)
{
  // A stiff slave with small cells on a soft master: the solves would be many, the matrix is not.
  const std::vector<std::string> smaller = {"Adaptation/Maximum passes=9"};
  const Answer answer = run_case("slow-interface", smaller);
  ASSERT_EQ(answer.status, 0) << answer.err;
  const Answer dense =
      run_case("slow-interface", {"Adaptation/Maximum passes=9", "Decomposition/Interface compliance=dense"});
  ASSERT_EQ(dense.status, 0) << dense.err;
  EXPECT_NEAR(value(answer, "c", "max_pressure") / value(dense, "c", "max_pressure"), 1., 1e-6);
  for (const std::string body : {"cyl", "flat"})
    EXPECT_LE(answer.summary["counters"]["bodies"][body]["solves"].get<double>(),
              1.5 * dense.summary["counters"]["bodies"][body]["solves"].get<double>());
}
