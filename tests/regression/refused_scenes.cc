// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Scenes that have no solution, or none that anyone can mean: refused in one sentence, where their neighbours
// run.

#include <gtest/gtest.h>

#include "program.h"

using namespace abut::testing;

namespace
{
  Answer run_refused_case(const std::string &name, const std::vector<std::string> &overrides = {})
  {
    std::vector<std::string> arguments = {project_file("tests/data/cases/" + name + ".prm")};
    for (const std::string &override : overrides)
      arguments.insert(arguments.end(), {"--set", override});
    return run(arguments);
  }
} // namespace

TEST(RefusedScenes, SidesOfOneBodyThatLookThroughIt)
{
  expect_refused(run_refused_case("same-body"), {"Contact joint", "the sides overlap by 10"});
  EXPECT_EQ(run_refused_case("same-body", {"Contact joint/Master=nylon:top"}).status, 0);
}

TEST(RefusedScenes, ABodyThatContactPushesAwayIsNamed)
{
  const std::string left = "Body nylon/Conditions=left: normal displacement: 0";
  for (const std::string scheme : {"Decomposition/Scheme=newton", "Decomposition/Scheme=conjugate"})
  {
    expect_refused(
        run_refused_case("not-held", {scheme}),
        {"Body nylon: translation along (0, -1) is held by nothing", "as they are placed or moved, by 0.01"});
    for (const std::string held : {"; bottom: displacement: 0, 0", "; bottom: pressure: 3"})
    {
      const Answer answer = run_refused_case("not-held", {scheme, left + held});
      ASSERT_EQ(answer.status, 0) << answer.err;
      EXPECT_GT(contact(answer, "joint")["normal_force"].get<double>(), 1.);
    }
  }
  EXPECT_EQ(run({project_file("tests/data/cases/not-held.prm"), "--check"}).status, 1);
}

// A block on a floor that a wall moves aside: it rests on the floor where the wall has left it.
TEST(RefusedScenes, ALoadedBodyThatIsPushedAsideIsSolved)
{
  for (const std::string wall : {"set Shift = -0.9999, 0\n set Conditions = left: displacement: 0, 0",
                                 "set Shift = -1.0001, 0\n set Conditions = left: displacement: 1e-3, 0"})
  {
    const Answer answer = run(
        {temporary_file("pushed.prm", "set Bodies = block, floor, wall\nset Contacts = below, aside\n"
                                      "subsection Body block\n set Cells = 8, 8\n"
                                      " set Conditions = top: pressure: 10\n set Young modulus = 1e5\nend\n"
                                      "subsection Body floor\n set Size = 3, 1\n set Shift = -1, -1\n"
                                      " set Cells = 20, 6\n set Young modulus = 1e5\n"
                                      " set Conditions = bottom: displacement: 0, 0\nend\n"
                                      "subsection Body wall\n set Cells = 6, 6\n set Young modulus = 1e5\n " +
                                          wall +
                                          "\nend\nsubsection Contact below\n set Slave = block:bottom\n"
                                          " set Master = floor:top\nend\nsubsection Contact aside\n"
                                          " set Slave = block:left\n set Master = wall:right\nend\n")});
    ASSERT_EQ(answer.status, 0) << answer.err;
    EXPECT_NEAR(contact(answer, "below")["normal_force"].get<double>(), 10., 1e-9);
    EXPECT_NEAR(contact(answer, "aside")["normal_force"].get<double>(), 0., 1e-9);
  }
}

TEST(RefusedScenes, ABodyThatMerelyTouchesStays)
{
  const Answer answer = run_refused_case(
      "not-held", {"Body steel/Conditions=left: normal displacement: 0; top: displacement y: 0"});
  ASSERT_EQ(answer.status, 0) << answer.err;
  EXPECT_EQ(contact(answer, "joint")["normal_force"].get<double>(), 0.);
}

namespace
{
  /// A pin in the bore of a plate.
  std::string pin_in_plate(const std::string &of_plate, const std::string &of_pin)
  {
    return "set Bodies = plate, pin\nset Contacts = bore\n"
           "subsection Body plate\n set Shape = ring\n set Size = 10.05, 30\n set Cells = 32, 8\n"
           " set Young modulus = 7e4\n" +
           of_plate + "\nend\nsubsection Body pin\n set Shape = disc\n set Size = 10\n set Cells = 32, 8\n" +
           " set Young modulus = 2.1e5\n" + of_pin +
           "\nend\nsubsection Contact bore\n set Slave = pin:outer\n set Master = plate:inner\nend\n";
  }

  const std::string held = " set Conditions = outer: displacement: 0, 0",
                    held_pin = " set Conditions = (0, 0): displacement: 0, 0; (5, 0): displacement: 0, 0",
                    weight = " set Body force = 0, -1";
} // namespace

// Whichever of the two is loaded, what is missing is a support of the plate or of the pin.
TEST(RefusedScenes, BodiesThatFallTogetherAreNamedTogether)
{
  const std::vector<std::string> both = {"Body plate: translation along (0, 1)", "together with",
                                         "Body pin: translation along (0, 1)", "give one of them"};
  expect_refused(run_text(pin_in_plate(weight, "")), both);
  expect_refused(run_text(pin_in_plate("", weight)), both);
  for (const Answer &answer :
       {run_text(pin_in_plate(held, weight)), run_text(pin_in_plate(weight, held_pin))})
    EXPECT_EQ(answer.status, 0) << answer.err;
}

// Round the bore's centre no normal resists: the weight acts beside it, by its moment about that centre.
TEST(RefusedScenes, APinBesideTheAxisOfItsBoreIsToldWhatItSlidesRound)
{
  expect_refused(run_text(pin_in_plate(held, weight + "\n set Shift = 0.02, 0")),
                 {"Body pin: rotation about (0, 0)", "no contact resists", "place the body (Shift)"});
  const Answer below = run_text(pin_in_plate(held, weight + "\n set Shift = 0, -0.02"));
  EXPECT_EQ(below.status, 0) << below.err;
}

// Its resultant is round-off beside what adds up to it.
TEST(RefusedScenes, ALoadThatBalancesItselfIsNoLoad)
{
  const Answer answer = run_text(pin_in_plate(" set Conditions = outer: pressure: 1", held_pin));
  ASSERT_EQ(answer.status, 0) << answer.err;
  EXPECT_EQ(warning_codes(answer), std::multiset<std::string>{"nothing-touches"}) << answer.err;
}
