// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Rigid obstacles: bodies of an outline without a mesh.
#include <gtest/gtest.h>

#include "program.h"
#include <cmath>
#include <sstream>
#include <tuple>

using namespace abut::testing;

namespace
{
  using Overrides = std::vector<std::string>;

  constexpr double young = 1000., plane = young / (1. - .3 * .3);

  /// Something rigid on a block of 20 x 10, in a frame turned by an angle (degrees).
  std::string pressed_block(const std::string &rigid, const std::string &sides, const double angle = 0.)
  {
    const double c = std::cos(angle * M_PI / 180.), s = std::sin(angle * M_PI / 180.);
    std::ostringstream text;
    text.precision(16);
    text << "set Bodies = block, tool\nset Contacts = c\nsubsection Body block\n set Size = 20, 10\n"
            " set Cells = 40, 20\n set Young modulus = 1000\n set Adapt = true\n set Rotation angle = "
         << angle << "\n set Shift = " << -10. * c + 10. * s << ", " << -10. * s - 10. * c
         << "\n set Conditions = bottom: displacement: 0, 0\nend\n"
            "subsection Body tool\n set Shape = rigid outline\n set Rotation angle = "
         << angle << "\n"
         << rigid << "\nend\nsubsection Contact c\n"
         << sides << "\nend\n";
    return text.str();
  }

  const std::string
      wheel = " set Outline = tread: circle (0, 5) 5\n",
      tip = " set Outline = (2, 5) -> (-2, 5) -> (-2, 0.4) -> tread: y = x^2/10 to (2, 0.4) -> close\n";
  const std::string master = " set Slave = block:top\n set Master = tool:tread",
                    slave = " set Slave = tool:tread\n set Master = block:top";

  Overrides adapting(const int passes)
  {
    return {"Discretisation/Degree=3", "Adaptation/Estimator=kelly", "Adaptation/Marking=doerfler",
            "Adaptation/Maximum passes=" + std::to_string(passes)};
  }

  /// Force 10 per thickness, radius 5.
  double hertz_pressure()
  {
    return std::sqrt(10. * plane / (M_PI * 5.));
  }

  /// A ring of radii 5, 10.01 in a rigid bore of radius 10.
  std::string shrunk_ring(const std::string &sides)
  {
    return "set Bodies = ring, plate\nset Contacts = c\nsubsection Body ring\n set Shape = ring\n"
           " set Size = 5, 10.01\n set Cells = 8, 6\n set Young modulus = 1000\n"
           " set Conditions = (0, 5): displacement x: 0; (0, -5): displacement x: 0\nend\n"
           "subsection Body plate\n set Shape = rigid outline\n"
           " set Outline = (-20, -20) -> base: (20, -20) -> (20, 20) -> (-20, 20) -> close;\\\n"
           " bore: circle (0, 0) 10\n set Conditions = base: displacement: 0, 0\nend\n"
           "subsection Contact c\n" +
           sides + "\nend\n";
  }
} // namespace

TEST(RigidOutlines, PressAsHertzSays)
{
  const std::string carried = " set Conditions = tread: resultant: 0, -10";
  for (const auto &[shape, sides, angle] :
       {std::tuple(wheel, master, 0.), {wheel, slave, 30.}, {tip, master, 30.}})
  {
    const Answer answer = run_text(pressed_block(shape + carried, sides, angle), adapting(7));
    ASSERT_EQ(answer.status, 0) << answer.err;
    EXPECT_NEAR(contact_value(answer, "c", "max_pressure") / hertz_pressure(), 1., .005);
    EXPECT_NEAR(contact_value(answer, "c", "normal_force"), 10., 1e-6);
    expect_balance(answer);
  }
}

TEST(RigidOutlines, TakeForcesAndMotionsAlike)
{
  const Overrides passes = adapting(3);
  const Answer carried =
      run_text(pressed_block(wheel + " set Conditions = tread: resultant: 0, -10", master), passes);
  const Answer loaded =
      run_text(pressed_block(wheel + " set Conditions = tread: traction: 0, -10/(10*pi)", master), passes);
  ASSERT_EQ(carried.status, 0) << carried.err;
  ASSERT_EQ(loaded.status, 0) << loaded.err;
  std::ostringstream motion;
  motion.precision(16);
  motion << " set Conditions = tread: displacement: 0, "
         << -carried.summary["bodies"][1]["rigid_displacement"].get<double>();
  const Answer moved = run_text(pressed_block(wheel + motion.str(), master), passes);
  ASSERT_EQ(moved.status, 0) << moved.err;
  for (const Answer *other : {&loaded, &moved})
    for (const char *const key : {"normal_force", "max_pressure", "contact_length"})
      EXPECT_NEAR(contact_value(*other, "c", key) / contact_value(carried, "c", key), 1., 1e-6) << key;
  EXPECT_NEAR(moved.summary["bodies"][1]["reactions"]["tread"][1].get<double>(), -10., 1e-5);
}

TEST(RigidOutlines, AreTheLimitOfStiffBodies)
{
  const std::string motion = "displacement: 0, -0.02";
  const Answer rigid =
      run_text(pressed_block(wheel + " set Conditions = tread: " + motion, master), adapting(4));
  std::string text = pressed_block("", master);
  text.replace(text.find("rigid outline"), 13,
               "disc\n set Size = 5\n set Cells = 16, 6\n set Shift = 0, 5\n"
               " set Young modulus = 1e9\n set Conditions = outer: " +
                   motion);
  text.replace(text.find("tool:tread"), 10, "tool:outer");
  const Answer stiff = run_text(text, adapting(4));
  ASSERT_EQ(rigid.status, 0) << rigid.err;
  ASSERT_EQ(stiff.status, 0) << stiff.err;
  EXPECT_NEAR(contact_value(rigid, "c", "normal_force") / contact_value(stiff, "c", "normal_force"), 1.,
              1e-3);
  EXPECT_NEAR(contact_value(rigid, "c", "max_pressure") / contact_value(stiff, "c", "max_pressure"), 1., .01);
}

TEST(RigidOutlines, ABoreHoldsARingAsLameSays)
{
  constexpr double a = 5., b = 10.01, ratio = .3 / .7;
  const double exact =
      .01 * plane / b / ((b * b + a * a) / (b * b - a * a) - ratio); // the ring yields by .01 outside
  for (const char *const sides : {" set Slave = ring:outer\n set Master = plate:bore",
                                  " set Slave = plate:bore\n set Master = ring:outer"})
  {
    const Answer answer = run_text(shrunk_ring(sides), {"Discretisation/Degree=3"});
    ASSERT_EQ(answer.status, 0) << answer.err;
    EXPECT_NEAR(contact_value(answer, "c", "normal_force") / (2. * M_PI * b * exact), 1., 1e-4);
    // Loads act along the side that is called slave: its length and the master's differ by the misfit.
    EXPECT_NEAR(contact_value(answer, "c", "max_pressure") / exact, 1., 1.1e-3);
    expect_balance(answer);
  }
}

TEST(RigidOutlines, ABeamFloatsOnWhatCarriesIt)
{
  const auto column = [](const std::string &name, const double shift) {
    std::ostringstream text;
    text << "subsection Body " << name
         << "\n set Size = 1, 1\n set Young modulus = 1000\n set Conditions = bottom: displacement: 0, 0\n "
            "set "
            "Shift = "
         << shift << ", 0\nend\n";
    return text.str();
  };
  const Answer answer = run_text(
      "set Bodies = left, right, beam\nset Contacts = automatic\n" + column("left", 0.) +
      column("right", 9.) +
      "subsection Body beam\n set Shape = rigid outline\n"
      " set Outline = (0, 1) -> under: (10, 1) -> (10, 2) -> (3, 2) -> load: (2, 2) -> (0, 2) -> close\n"
      " set Conditions = load: pressure: 3; (0, 1): displacement x: 0\nend\n");
  ASSERT_EQ(answer.status, 0) << answer.err;
  expect_balance(answer);
  const double left = contact_value(answer, "left.top-beam.under", "normal_force"),
               right = contact_value(answer, "right.top-beam.under", "normal_force");
  EXPECT_NEAR(left + right, 3., 1e-9);
  EXPECT_NEAR(right, 3. * 2. / 9., .02); // about the left column's middle; forces wander within the columns
}

TEST(RigidOutlines, GraphsEndWithTheTangentOfTheirFormula)
{
  // Half a foot of radius 10 as an elastic body: the graph ends at the plane of symmetry, where it presses.
  const Answer answer =
      run_text("set Bodies = foot, pin\nset Contacts = c\nsubsection Body foot\n set Shape = outline\n"
               " set Outline = (0, 0) -> symmetry: (0, -10) -> base: (5, -10) -> (5, -1.25) -> "
               "top: y = -x^2/20 to (0, 0)\n"
               " set Conditions = symmetry: normal displacement: 0; base: normal displacement: 0\n"
               " set Young modulus = 1000\n set Mesh size = 1; top: 0.05\nend\n"
               "subsection Body pin\n set Size = 10, 10\n set Cells = 80, 40\n set Grading = 20, 20\n"
               " set Young modulus = 1000\n"
               " set Conditions = left: normal displacement: 0; top: resultant: 0, -2\nend\n"
               "subsection Contact c\n set Slave = pin:bottom\n set Master = foot:top\nend\n",
               {"Discretisation/Degree=2"});
  ASSERT_EQ(answer.status, 0) << answer.err;
  EXPECT_NEAR(contact_value(answer, "c", "max_pressure") / std::sqrt(4. * plane / 2. / (M_PI * 10.)), 1.,
              .01);
}

TEST(RigidOutlines, WavesAreFollowed)
{
  const std::string loaded = " set Conditions = tread: displacement: 0, -0.02";
  const Answer outline = run_text(pressed_block(" set Outline = (8, 5) -> (-8, 5) -> (-8, 0) -> tread: y = "
                                                "0.01*(1 - cos(4*pi*x)) to (8, 0) -> close\n" +
                                                    loaded,
                                                master),
                                  {"Body block/Adapt=false"});
  std::string text =
      pressed_block(" set Outline = (8, 5) -> (-8, 5) -> (-8, 0) -> tread: (8, 0) -> close\n" + loaded,
                    master + "\n set Gap = 0.01*(1 - cos(4*pi*x))");
  const Answer gap = run_text(text, {"Body block/Adapt=false"});
  ASSERT_EQ(outline.status, 0) << outline.err;
  ASSERT_EQ(gap.status, 0) << gap.err;
  EXPECT_NEAR(contact_value(outline, "c", "normal_force") / contact_value(gap, "c", "normal_force"), 1., .01);
  expect_refused(
      run_text(pressed_block(" set Outline = (8, 5) -> (-8, 5) -> (-8, 0) -> tread: y = sin(1e5*pi*x) to "
                             "(8, 0) -> close\n" +
                                 loaded,
                             master),
               {"Body block/Adapt=false"}),
      {"changes too fast"});
}

TEST(RigidOutlines, RefuseWhatOnlyElasticBodiesHave)
{
  const std::string good = " set Slave = ring:outer\n set Master = plate:bore";
  const auto changed = [&](const std::string &from, const std::string &to) {
    std::string text = shrunk_ring(good);
    text.replace(text.find(from), from.size(), to);
    return run_text(text);
  };
  const std::string shape = "set Shape = rigid outline\n";
  for (const char *const entry : {"Young modulus = 3", "Adapt = true", "Degree = 2", "Body force = 0, 1",
                                  "Cell type = triangles", "Cells = 2, 2", "Poisson ratio = 0"})
  {
    const std::string name = std::string(entry).substr(0, std::string(entry).find(" ="));
    expect_refused(changed(shape, shape + " set " + entry + "\n"), {"Body plate/" + name, "rigid"});
  }
  expect_refused(changed(shape, shape + " set Mesh size = 3\n"), {"Body plate/Mesh size"});
  expect_refused(changed("plate:bore", "plate:hole"), {"no side 'hole'", "0, base, bore"});
  expect_refused(changed("base: displacement: 0, 0", "base: displacement: 0.1*x, 0"), {"plate", "rigid"});
  expect_refused(changed("plate:bore", "plate:bore\n set Multipliers = master"), {"Contact c/Multipliers"});
  expect_refused(changed("bore: circle (0, 0) 10", "(5, 0) -> y = x^2 to (0, 5) -> close"),
                 {"y = 25", "x = 5"});
  expect_refused(run_text("set Bodies = a\nsubsection Body a\n set Shape = rigid outline\n"
                          " set Outline = circle (0, 0) 1\n set Conditions = 0: displacement: 0, 0\nend\n"),
                 {"rigid", "deform"});
}
