// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Sides of other shapes: both lips of a slot under one name, chains of discs, bodies on axles, wedges, rows
// of blocks.
#include <gtest/gtest.h>

#include "program.h"
#include <cmath>
#include <sstream>

using namespace abut::testing;

namespace
{
  std::string shaped_body(const std::string &name, const std::string &entries)
  {
    return "subsection Body " + name + "\n set Young modulus = 1000\n set Poisson ratio = 0.3\n" + entries +
           "\nend\n";
  }

  std::string touching(const std::string &name, const std::string &slave, const std::string &master)
  {
    return "subsection Contact " + name + "\n set Slave = " + slave + "\n set Master = " + master + "\nend\n";
  }

  double normal_force_of(const Answer &answer, const std::string &name)
  {
    return contact(answer, name)["normal_force"].get<double>();
  }
} // namespace

TEST(ContactShapes, ATongueInASlotWhoseLipsHaveOneName)
{
  for (const double shift : {1.1, 1.02, .97})
    for (const std::string cells : {"4, 5", "3, 2", "7, 3"})
    {
      double first = 0.;
      for (const bool swapped : {false, true})
      {
        std::ostringstream place;
        place << " set Size = 2.5, 1.02\n set Shift = " << shift << ", 0.99\n set Cells = " << cells;
        const std::string up = "W:top", down = "W:bottom", lips = "C:2";
        const Answer answer = run_text(
            "set Bodies = C, W\nset Contacts = up, lo\n" +
            shaped_body("C", " set Mesh file = " + project_file("tests/data/cases/slot.msh") +
                                 "\n set Conditions = 3: displacement: 0, 0") +
            shaped_body("W", place.str()) + touching("up", swapped ? lips : up, swapped ? up : lips) +
            touching("lo", swapped ? lips : down, swapped ? down : lips));
        ASSERT_EQ(answer.status, 0) << answer.err;
        const double above = normal_force_of(answer, "up"), below = normal_force_of(answer, "lo");
        EXPECT_GT(above, 0.);
        EXPECT_NEAR(above / below, 1., 1e-9) << shift << ' ' << cells; // nothing else holds the tongue
        if (swapped)
        {
          EXPECT_NEAR(above / first, 1., 1e-6) << shift << ' ' << cells;
        }
        first = above;
      }
    }
}

TEST(ContactShapes, AChainOfDiscsCarriesOneForce)
{
  constexpr int n = 8;
  for (const double from : {0., .3, -12., 100.})
  {
    std::ostringstream text, names, pairs;
    text << shaped_body("low", " set Size = 4, 1\n set Shift = -2, " + std::to_string(from - 2.) +
                                   "\n set Cells = 9, 2\n set Conditions = bottom: displacement: 0, 0")
         << shaped_body("high", " set Size = 4, 1\n set Shift = -2, " + std::to_string(from + 2. * n - 1.) +
                                    "\n set Cells = 9, 2\n set Conditions = top: displacement: 0, -0.1");
    names << "low";
    for (int i = 0; i < n; ++i)
    {
      names << ", d" << i;
      pairs << "p" << i << ", ";
      text << shaped_body("d" + std::to_string(i),
                          " set Shape = disc\n set Size = 1\n set Cells = 16, 3\n set Shift = 0, " +
                              std::to_string(from + 2. * i))
           << touching("p" + std::to_string(i), i == 0 ? "low:top" : "d" + std::to_string(i - 1) + ":outer",
                       "d" + std::to_string(i) + ":outer");
    }
    text << touching("last", "d" + std::to_string(n - 1) + ":outer", "high:bottom");
    const Answer answer = run_text("set Bodies = " + names.str() + ", high\nset Contacts = " + pairs.str() +
                                   "last\n" + text.str());
    ASSERT_EQ(answer.status, 0) << answer.err;
    const double force = normal_force_of(answer, "last");
    EXPECT_GT(force, .1);
    for (const auto &pair : answer.summary["contacts"])
    {
      EXPECT_NEAR(pair["force"][0].get<double>(), 0., 1e-6 * force);
      EXPECT_NEAR(std::abs(pair["force"][1].get<double>()) / force, 1., 1e-9) << from << ' ' << pair["name"];
    }
  }
}

TEST(ContactShapes, DiscsOnAxlesTurnFreely)
{
  for (const std::string scheme : {"newton", "conjugate"})
    for (const std::string cells : {"8, 4", "16, 6", "24, 8", "32, 8"})
      for (const std::string distance : {"1.99", "1.97"})
      {
        const std::string disc = " set Shape = disc\n set Size = 1\n set Cells = " + cells,
                          axle = "\n set Conditions = (0, 0): displacement: 0, 0";
        const auto force = [&](const std::string &also_held) {
          const Answer answer =
              run_text("set Bodies = A, B\nset Contacts = ab\n" + shaped_body("A", disc + axle + also_held) +
                       shaped_body("B", disc + "\n set Shift = 0, " + distance + axle + also_held) +
                       touching("ab", "A:outer", "B:outer") +
                       "subsection Decomposition\n set Scheme = " + scheme + "\nend\n");
          EXPECT_EQ(answer.status, 0) << scheme << ' ' << cells << ": " << answer.err;
          if (answer.status == 0)
            expect_balance(answer);
          return normal_force_of(answer, "ab");
        };
        // The second held point stiffens the disc a little.
        const double turning = force(""), held = force("; (-1, 0): displacement y: 0");
        EXPECT_GT(turning, 0.);
        EXPECT_NEAR(turning / held, 1., .02) << scheme << ' ' << cells << ' ' << distance;
      }
}

TEST(ContactShapes, APairThatOtherBodiesHideCarriesNothing)
{
  const auto between = [](const std::string &middle) {
    return run_text(
        "set Bodies = U, M, L\nset Contacts = um, ul, ml\n" +
        shaped_body("U",
                    " set Shift = 0, 2\n set Cells = 4, 4\n set Conditions = top: displacement: 0, -0.01") +
        shaped_body("M", middle + " set Conditions = left: normal displacement: 0") +
        shaped_body("L", " set Size = 4, 1\n set Shift = -1, 0\n set Cells = 9, 2\n set Conditions = bottom: "
                         "displacement: 0, 0") +
        touching("um", "U:bottom", "M:top") + touching("ul", "U:bottom", "L:top") +
        touching("ml", "M:bottom", "L:top"));
  };
  const Answer hidden = between(" set Size = 2, 1\n set Shift = -.5, 1\n set Cells = 5, 4\n");
  ASSERT_EQ(hidden.status, 0) << hidden.err;
  EXPECT_EQ(normal_force_of(hidden, "ul"), 0.);
  EXPECT_EQ(warning_codes(hidden).count("hidden-pair"), 1u) << hidden.err;
  EXPECT_NEAR(normal_force_of(hidden, "um") / normal_force_of(hidden, "ml"), 1., 1e-9);
  const Answer seen = between(" set Size = .5, 1\n set Shift = .25, 1\n set Cells = 5, 4\n");
  ASSERT_EQ(seen.status, 0) << seen.err;
  EXPECT_EQ(warning_codes(seen).count("hidden-pair"), 0u) << seen.err;
}

TEST(ContactShapes, ARigidWedgeIsSymmetric)
{
  // A clamped end is no plane of symmetry.
  double first = 0.;
  for (const bool swapped : {false, true})
    for (const std::string held : {"", "; left: displacement: 0, 0; bottom: displacement: 0, 0"})
    {
      const std::string left = "Q:left", right = "Q:bottom", floor = "F:top";
      const Answer answer = run_text(
          "set Bodies = Q, F\nset Contacts = l, r\n" +
          shaped_body(
              "Q",
              " set Rotation angle = 45\n set Shift = 0, -0.03\n set Cells = 8, 8\n set Young modulus = 1e5\n"
              " set Conditions = top: displacement: 0, 0; right: displacement: 0, 0" +
                  held) +
          shaped_body("F", " set Size = 3, 1\n set Shift = -1.5, -1\n set Cells = 61, 20\n set Conditions = "
                           "bottom: displacement: 0, 0") +
          touching("l", swapped ? floor : left, swapped ? left : floor) +
          touching("r", swapped ? floor : right, swapped ? right : floor));
      ASSERT_EQ(answer.status, 0) << answer.err;
      const double force = normal_force_of(answer, "l");
      EXPECT_NEAR(force / normal_force_of(answer, "r"), 1., 1e-6);
      first = first > 0. ? first : force;
      EXPECT_NEAR(force / first, 1., .1) << swapped << held; // parts of a corner pressed into a few cells
    }
}

TEST(ContactShapes, ANarrowBlockInARowKeepsItsOwnParts)
{
  // Joints of a third of the middle block's width: as in a row, and as if its neighbours were not there.
  const std::string pressed = "\n set Conditions = top: displacement: 0, -0.01",
                    tilted = "\n set Conditions = top: displacement: 0, -0.01*(1+5*(x-0.1))";
  const std::string middle = shaped_body("B", " set Size = 0.2, 1\n set Shift = 1.07, 1\n set Cells = 1, 5" +
                                                  tilted),
                    base = shaped_body("L", " set Size = 4, 1\n set Shift = -1, 0\n set Cells = 4, 2\n set "
                                            "Conditions = bottom: displacement: 0, 0");
  const Answer answer =
      run_text("set Bodies = A, B, C, L\nset Contacts = a, b, c\n" +
               shaped_body("A", " set Shift = 0, 1\n set Cells = 1, 1" + pressed) + middle +
               shaped_body("C", " set Shift = 1.27, 1\n set Cells = 1, 1" + pressed) + base +
               touching("a", "A:bottom", "L:top") + "subsection Contact a\n set Multipliers = slave\nend\n" +
               touching("b", "B:bottom", "L:top") + "subsection Contact b\n set Multipliers = slave\nend\n" +
               touching("c", "C:bottom", "L:top") + "subsection Contact c\n set Multipliers = slave\nend\n");
  ASSERT_EQ(answer.status, 0) << answer.err;
  const auto loads = column(answer.directory + "/contact_b.csv", "load");
  ASSERT_EQ(loads.size(), 2u);
  EXPECT_GT(std::abs(loads[0] - loads[1]), 1.);
}

TEST(ContactShapes, SidesThatEndWhereTheOthersBeginDoNotTouch)
{
  for (const std::string overlap : {"0", "1e-13"})
    expect_refused(
        run_text(
            "set Bodies = U, L\nset Contacts = c\n" +
            shaped_body("U", " set Shift = " + std::string(overlap == "0" ? "1" : "0.9999999999999") +
                                 ", 0.99\n set Cells = 3, 3\n set Conditions = top: displacement: 0, 0") +
            shaped_body("L", " set Cells = 4, 4\n set Conditions = bottom: displacement: 0, 0") +
            touching("c", "L:top", "U:bottom")),
        {"Contact c: no part of the slave L:top faces the master U:bottom"});
}
