// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Blocks that contact alone holds and sides that carry given forces, against statics.
#include <gtest/gtest.h>

#include "program.h"
#include <cmath>
#include <regex>
#include <sstream>

using namespace abut::testing;

namespace
{
  double normal_force(const Answer &answer, const std::string &name)
  {
    return contact(answer, name)["normal_force"].get<double>();
  }
} // namespace

// A rigid side is not held by contact where its own body resists, whatever the unit of length.
TEST(FloatingBodies, ARigidSideFarFromContact)
{
  for (const std::string scale : {"1e-6", "1", "1e7"})
  {
    const std::string column =
        "set Bodies = column\nsubsection Body column\n  set Size = 2, 3\n  set Scale = " + scale +
        "\n  set Cells = 4, 6\n  set Young modulus = 7\n  set Conditions = "
        "left: normal displacement: 0; bottom: normal displacement: 0; "
        "top: resultant: 0, -5\nend\n";
    const Answer answer = run({temporary_file("column.prm", column)});
    ASSERT_EQ(answer.status, 0) << scale << ": " << answer.err;
    EXPECT_NEAR(answer.summary["bodies"][0]["reactions"]["bottom"][1].get<double>(), 5., 1e-9) << scale;
  }
}

namespace
{
  /// A block that lies between the plates, touching both on its whole sides.
  std::vector<std::string> block(const std::string &force)
  {
    return {"Body disc/Shape=rectangle",
            "Body disc/Size=2, 2",
            "Body disc/Shift=-1, -1",
            "Body disc/Body force=" + force,
            "Body upper/Conditions=top: displacement: 0, 0",
            "Contact below/Master=disc:bottom",
            "Contact above/Master=disc:top"};
  }
} // namespace

TEST(FloatingBodies, TouchingWithoutForce)
{
  for (const std::string scheme : {"Decomposition/Scheme=newton", "Decomposition/Scheme=conjugate"})
  {
    std::vector<std::string> weightless_block = block("0, 0");
    weightless_block.push_back(scheme);
    for (const Answer &answer : {run_scene("disc-between-plates", weightless_block),
                                 run_scene("v-groove", {"Body disc/Body force=0, 0", scheme})})
    {
      ASSERT_EQ(answer.status, 0) << scheme << ": " << answer.err;
      for (const auto &pair : answer.summary["contacts"])
        EXPECT_LT(pair["normal_force"].get<double>(), 1e-9) << scheme;
    }
  }
}

/// The first mesh is too coarse for any of its parts to touch: there is no force that round-off could be
/// measured by.
TEST(FloatingBodies, ContactSmallerThanTheFirstCellsIsFound)
{
  const std::string scene = std::regex_replace(read_file(project_file("prm/disc-between-plates.prm")),
                                               std::regex("  set Cells[^\n]*\n"), "");
  const auto force = [&](const std::string &tolerance) {
    const Answer answer =
        run_text(scene, {"Tolerance=" + tolerance, "Body lower/Young modulus=100",
                         "Body disc/Body force=0, 0", "Body upper/Conditions=top: displacement: 0, -0.001"});
    EXPECT_EQ(answer.status, 0) << answer.err;
    return normal_force(answer, "below");
  };
  const double rough = force("0.05"), fine = force("0.005");
  EXPECT_GT(fine, 0.);
  EXPECT_NEAR(rough, fine, .02 * fine);
}

TEST(FloatingBodies, LoadsThatContactCannotBalance)
{
  expect_refused(run_scene("v-groove", {"Body disc/Body force=0, 3"}),
                 {"Body disc", "translation along (0, 1)", "held by contact alone", "a resultant of 9.42",
                  "unbalanced"});
  // 0.25 times the area sideways: frictionless plates do not hold it
  expect_refused(run_scene("disc-between-plates", block("0.25, -1")),
                 {"Body disc", "translation along (1, 0)", "a resultant of 1 along it"});
  expect_refused(
      run_scene("v-groove", {"Decomposition/Scheme=neumann", "Contact left-flank/Penalty coefficient=0.01",
                             "Contact right-flank/Penalty coefficient=0.01"}),
      {"Body disc", "held by contact alone", "conjugate or newton"});
}

namespace
{
  /// A block in a corner of two others, pressed by 3 from above and by 2 from the right; nothing else holds
  /// it. All turned about the corner, which both pairs share.
  std::string block_in_a_corner(const double degrees)
  {
    const double angle = degrees * std::acos(0.) / 90., c = std::cos(angle), s = std::sin(angle);
    std::ostringstream file;
    file.precision(17);
    const auto body = [&](const std::string &name, const double x, const double y, const std::string &rest) {
      file << "subsection Body " << name << "\n  set Size = 1, 1\n  set Rotation angle = " << degrees
           << "\n  set Shift = " << c * x - s * y << ", " << s * x + c * y << '\n'
           << rest << "end\n";
    };
    file << "set Bodies = block, floor, wall\nset Contacts = on-floor, at-wall\n";
    const std::string rollers =
        "  set Conditions = left: normal displacement: 0; bottom: normal displacement: 0\n";
    body("block", 0., 0.,
         "  set Cells = 6, 5\n  set Young modulus = 100\n  set Poisson ratio = 0.3\n"
         "  set Conditions = top: pressure: 3; right: pressure: 2\n");
    body("floor", 0., -1.,
         "  set Cells = 4, 3\n  set Young modulus = 1000\n  set Poisson ratio = 0.2\n" + rollers);
    body("wall", -1., 0.,
         "  set Cells = 3, 4\n  set Young modulus = 50\n  set Poisson ratio = 0.4\n" + rollers);
    file << "subsection Contact on-floor\n  set Slave = block:bottom\n  set Master = floor:top\nend\n"
            "subsection Contact at-wall\n  set Slave = block:left\n  set Master = wall:right\nend\n";
    return file.str();
  }
} // namespace

TEST(FloatingBodies, ACornerThatTwoPairsShareIsAPatchTest)
{
  for (const double degrees : {0., 33.})
    for (const std::string scheme : {"newton", "conjugate"})
    {
      const Answer answer = run({temporary_file("corner.prm", block_in_a_corner(degrees)), "--set",
                                 "Decomposition/Scheme=" + scheme});
      ASSERT_EQ(answer.status, 0) << answer.err;
      const double allowed = scheme == "newton" ? 1e-10 : 1e-6;
      for (const double pressure : column(answer.directory + "/contact_on-floor.csv", "pressure"))
        EXPECT_NEAR(pressure, 3., 3. * allowed) << scheme << ' ' << degrees;
      for (const double pressure : column(answer.directory + "/contact_at-wall.csv", "pressure"))
        EXPECT_NEAR(pressure, 2., 2. * allowed) << scheme << ' ' << degrees;
      expect_balance(answer);
    }
}

// Boundary elements need loads in balance: those of the contact law are not, while the iteration has not
// ended.
TEST(FloatingBodies, BoundaryElementsTakeTheTractionInBalance)
{
  for (const std::string scheme : {"newton", "conjugate"})
    for (const std::string c : {"0", "1e-8", "0.05"})
    {
      const Answer answer =
          run({temporary_file("corner.prm", block_in_a_corner(0.)), "--set", "Decomposition/Scheme=" + scheme,
               "--set", "Contact at-wall/Penalty coefficient=" + c, "--set", "Body block/Body force=0, -1",
               "--set", "Body block/Adapt=true", "--set", "Adaptation/Estimator=fe-be", "--set",
               "Adaptation/Maximum passes=3"});
      ASSERT_EQ(answer.status, 0) << scheme << ' ' << c << ": " << answer.err;
      EXPECT_EQ(answer.summary["passes"], 3);
      EXPECT_NEAR(contact(answer, "on-floor")["normal_force"].get<double>(), 4., 1e-8); // pressure and weight
      EXPECT_NEAR(contact(answer, "at-wall")["normal_force"].get<double>(), 2., 1e-8);
    }
}

TEST(FloatingBodies, SeveralRigidSidesWithGivenForces)
{
  const Answer answer = run_scene(
      "three-bodies", {"Decomposition/Scheme=newton", "Decomposition/Tolerance=1e-9",
                       "Body steel/Conditions=left: normal displacement: 0; top: resultant: 0, -45"});
  ASSERT_EQ(answer.status, 0) << answer.err;
  EXPECT_NEAR(normal_force(answer, "left"), 45., 45e-10);
  EXPECT_NEAR(normal_force(answer, "right"), 60., 60e-10);
  EXPECT_LE(answer.summary["steps"].get<int>(), 10);
  expect_balance(answer);
}

TEST(FloatingBodies, AForceAsAnUnknownIsThatOfTheSecant)
{
  const std::vector<std::string> coarse = {"Decomposition/Tolerance=1e-8",
                                           "Contact left/Penalty coefficient=0.05",
                                           "Contact right/Penalty coefficient=0.05"};
  std::vector<std::string> by_secant = coarse;
  by_secant.emplace_back("Decomposition/Scheme=neumann");
  const Answer secant = run_scene("three-bodies", by_secant), unknown = run_scene("three-bodies", coarse);
  ASSERT_EQ(secant.status, 0) << secant.err;
  ASSERT_EQ(unknown.status, 0) << unknown.err;
  const double delta = secant.summary["iteration"]["rigid_displacement"];
  EXPECT_NEAR(unknown.summary["iteration"]["rigid_displacement"].get<double>(), delta,
              1e-6 * std::abs(delta));
  EXPECT_NEAR(normal_force(unknown, "left"), normal_force(secant, "left"),
              1e-6 * normal_force(secant, "left"));
}
