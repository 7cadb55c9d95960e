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

TEST(RefusedScenes, ABodyThatMerelyTouchesStays)
{
  const Answer answer = run_refused_case(
      "not-held", {"Body steel/Conditions=left: normal displacement: 0; top: displacement y: 0"});
  ASSERT_EQ(answer.status, 0) << answer.err;
  EXPECT_EQ(contact(answer, "joint")["normal_force"].get<double>(), 0.);
}
