// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Scenes of other readers on which checks of the results once spoke up without cause, or did not end.
#include <gtest/gtest.h>

#include "program.h"

using namespace abut::testing;

namespace
{
  /// Round a closed side, from where nothing comes to an end.
  TEST(FalseAlarms, SlidingAThousandTimesRoundADisc)
  {
    const Answer answer = run({temporary_file("turned.prm", R"(set Bodies = disc, ring
set Contacts = fit
subsection Body disc
  set Shape = disc
  set Size = 1.001
  set Cells = 32, 4
  set Young modulus = 1e5
  set Conditions = (0, 0): displacement: 0, 0
end
subsection Body ring
  set Shape = ring
  set Size = 1, 2
  set Cells = 40, 4
  set Young modulus = 1e5
  set Conditions = outer: tangential displacement: 1e9; outer: normal displacement: 0
end
subsection Contact fit
  set Slave = ring:inner
  set Master = disc:outer
end
)")});
    EXPECT_NE(answer.err.find("side-leaves-master"), std::string::npos) << answer.err;
  }

  /// Three patches far from each other: each is smooth, the mean over all between them says nothing.
  TEST(FalseAlarms, SeparatePatchesAreNotRough)
  {
    const Answer answer = run({temporary_file("patches.prm", R"(set Bodies = a, b
set Contacts = c
subsection Body a
  set Size = 16, 1
  set Shift = -8, 1
  set Cells = 640, 10
  set Young modulus = 4e4
  set Conditions = top: displacement: 0, -3e-4
end
subsection Body b
  set Size = 16, 1
  set Shift = -8, 0
  set Cells = 340, 12
  set Young modulus = 1e5
  set Conditions = bottom: displacement: 0, 0
end
subsection Contact c
  set Slave = b:top
  set Master = a:bottom
  set Gap = 0.01*(1-cos(2*pi*x/8))
end
)")});
    EXPECT_EQ(warning_codes(answer), std::multiset<std::string>{}) << answer.err;
  }

  /// A quarter ring of a twentieth of its radius: its strain is the misfit by the radius, not by the depth.
  TEST(FalseAlarms, AThinRingTakesAMisfitUpByItsRadius)
  {
    const Answer answer =
        run_scene("shrink-fit", {"Body ring/Size=1, 1.05", "Body disc/Size=1.0012", "Body ring/Cells=40, 2"});
    EXPECT_EQ(warning_codes(answer).count("large-overlap"), 0u) << answer.err;
  }

  TEST(FalseAlarms, KeywordsInCapitalsAreKnown)
  {
    const Answer answer = run(
        {temporary_file("capitals.prm",
                        "SET Bodies = a\nSUBSECTION Body a\n  SET Cells = 2, 2\n  set Conditions = bottom: "
                        "displacement: 0, 0\nEND\n"),
         "--check"});
    EXPECT_EQ(answer.status, 0) << answer.err;
    EXPECT_EQ(answer.err, "");
  }

  /// A wall that merely touches a block at rest: its pressures are round-off, no narrow contact.
  TEST(FalseAlarms, RoundOffIsNoContact)
  {
    const Answer answer = run({temporary_file("touching.prm", R"(set Bodies = block, floor, wall
set Contacts = below, aside
subsection Body block
  set Cells = 8, 8
  set Young modulus = 1e5
  set Conditions = top: pressure: 10
end
subsection Body floor
  set Size = 3, 1
  set Shift = -1, -1
  set Cells = 20, 6
  set Young modulus = 1e5
  set Conditions = bottom: displacement: 0, 0
end
subsection Body wall
  set Shift = -1, 0
  set Cells = 6, 6
  set Young modulus = 1e5
  set Conditions = left: displacement: 0, 0
end
subsection Contact below
  set Slave = block:bottom
  set Master = floor:top
end
subsection Contact aside
  set Slave = block:left
  set Master = wall:right
end
)")});
    ASSERT_EQ(answer.status, 0) << answer.err;
    // The block's edges press into the wider floor.
    EXPECT_EQ(warning_codes(answer), std::multiset<std::string>{"singular-pressure"}) << answer.err;
    EXPECT_NEAR(contact(answer, "below")["normal_force"].get<double>(), 10., 1e-9);
  }

  /// What is estimated of layers under a uniform pressure is round-off.
  TEST(FalseAlarms, RoundOffIsNoRoughEstimate)
  {
    const Answer answer =
        run_text("set Bodies = lo, hi\nset Contacts = c\nset Tolerance = 0.01\n"
                 "subsection Body lo\n set Size = 2, 1\n set Young modulus = 1000\n"
                 " set Conditions = bottom: normal displacement: 0; left: normal displacement: 0\n"
                 "end\nsubsection Body hi\n set Size = 2, 1\n set Shift = 0, 1\n"
                 " set Young modulus = 3000\n set Conditions = top: displacement y: -0.01; "
                 "left: normal displacement: 0\nend\n"
                 "subsection Contact c\n set Slave = lo:top\n set Master = hi:bottom\nend\n");
    EXPECT_EQ(warning_codes(answer), std::multiset<std::string>{}) << answer.err;
  }

  /// Two sides that turn as the body does. With zeros at the nodes it stays at rest and the data are missed.
  TEST(FalseAlarms, ABodyThatTurnsFollowsItsData)
  {
    const auto turned = [](const std::string &more) {
      return warning_codes(
          run_text("set Bodies = b\nsubsection Body b\n set Size = 2, 1\n set Cells = 8, 4\n"
                   " set Young modulus = 1000\n set Conditions = left: displacement: -0.01*y, "
                   "0.01*x; right: displacement: -0.01*y" +
                   more + ", 0.01*x\nend\n"));
    };
    EXPECT_EQ(turned("").count("coarse-data"), 0u);
    EXPECT_EQ(turned("+0.001*sin(4*pi*y)").count("coarse-data"), 1u);
  }

  /// The point holds a disc that two plates press from both sides: it carries what their meshes differ by.
  TEST(FalseAlarms, APointThatHoldsWhatIsInBalance)
  {
    const Answer answer =
        run_scene("disc-between-plates",
                  {"Body lower/Conditions=bottom: displacement: 0, 0.02",
                   "Body upper/Conditions=top: displacement: 0, -0.02", "Body upper/Cells=68, 17",
                   "Body disc/Body force=0, 0", "Body disc/Conditions=(0,0): displacement: 0, 0"});
    ASSERT_EQ(answer.status, 0) << answer.err;
    EXPECT_EQ(warning_codes(answer).count("point-support"), 0u) << answer.err;
  }

  /// Symmetric, but for the billionth that its outline follows the formula to.
  TEST(FalseAlarms, ARollerThatRestsOnItsLowestPoint)
  {
    const Answer answer =
        run_text("set Bodies = strip, roller\nset Contacts = nip\nsubsection Body strip\n set Size = 20, 2\n"
                 " set Cells = 80, 8\n set Shift = -10.1, -2\n set Young modulus = 100\n"
                 " set Conditions = bottom: displacement: 0, 0\nend\n"
                 "subsection Body roller\n set Shape = rigid outline\n"
                 " set Outline = (3, 2) -> (-3, 2) -> (-3, 0.9) -> tread: y = x^2/10 to (3, 0.9) -> close\n"
                 " set Conditions = tread: resultant: 0, -5\nend\n"
                 "subsection Contact nip\n set Slave = strip:top\n set Master = roller:tread\nend\n");
    ASSERT_EQ(answer.status, 0) << answer.err;
    EXPECT_EQ(warning_codes(answer), std::multiset<std::string>{}) << answer.err;
  }
} // namespace
