// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What a Tolerance chooses, what it leaves alone and what it refuses.
#include <gtest/gtest.h>

#include "scene_file.h"
#include "scene_testing.h"

using namespace abut;

namespace
{
  using Cells = std::array<unsigned int, 2>;

  Scene read_squares(const std::vector<std::string> &overrides)
  {
    return SceneFile(two_squares).read(overrides);
  }

  void expect_tolerance_refused(const std::vector<std::string> &overrides, const std::string &phrase)
  {
    const std::string message = message_of([&] { read_squares(overrides); });
    EXPECT_NE(message.find(phrase), std::string::npos) << message;
  }

  TEST(SceneTolerance, IsNoneByDefaultAndChangesNothing)
  {
    const Scene scene = read_squares({});
    EXPECT_FALSE(scene.has_tolerance());
    EXPECT_EQ(scene.adaptation.estimator, "none");
    EXPECT_EQ(scene.bodies[0].degree, 1u);
    EXPECT_EQ(scene.bodies[0].cells, (Cells{{8, 8}}));
  }

  TEST(SceneTolerance, ChoosesWhatIsNotGiven)
  {
    const Scene scene = read_squares({"Tolerance=1e-3", "Body upper/Size=6, 2"});
    EXPECT_EQ(scene.tolerance, 1e-3);
    EXPECT_EQ(scene.adaptation.estimator, "automatic");
    EXPECT_EQ(scene.adaptation.marking, "automatic");
    EXPECT_TRUE(scene.bodies[0].adapt && scene.bodies[1].adapt);
    EXPECT_EQ(scene.bodies[0].cells, (Cells{{6, 2}})); // as long as wide, two across
    EXPECT_EQ(scene.bodies[1].cells, (Cells{{2, 2}}));
    EXPECT_EQ(scene.bodies[0].degree, 3u);
    EXPECT_LT(scene.decomposition.tolerance, .1 * scene.tolerance);
    EXPECT_EQ(read_squares({"Tolerance=0.05"}).bodies[0].degree, 2u);
  }

  TEST(SceneTolerance, KeepsWhatIsGiven)
  {
    const Scene scene = read_squares({"Tolerance=1e-3", "Body upper/Cells=5, 7", "Body upper/Adapt=false",
                                      "Discretisation/Degree=1", "Adaptation/Estimator=zz",
                                      "Adaptation/Marking=fixed fraction", "Adaptation/Maximum passes=3",
                                      "Decomposition/Tolerance=1e-8"});
    EXPECT_EQ(scene.bodies[0].cells, (Cells{{5, 7}}));
    EXPECT_FALSE(scene.bodies[0].adapt);
    EXPECT_TRUE(scene.bodies[1].adapt);
    EXPECT_EQ(scene.bodies[1].degree, 1u);
    EXPECT_EQ(scene.adaptation.estimator, "zz");
    EXPECT_EQ(scene.adaptation.marking, "fixed fraction");
    EXPECT_EQ(scene.adaptation.maximum_passes, 3u);
    EXPECT_EQ(scene.decomposition.tolerance, 1e-8);
  }

  TEST(SceneTolerance, KnowsOtherShapes)
  {
    const Scene round = read_squares({"Tolerance=1e-3", "Body upper/Shape=ring", "Body upper/Size=1, 2",
                                      "Body upper/Conditions=outer: displacement: 0, 0",
                                      "Contact interface/Master=upper:inner", "Body lower/Shape=disc",
                                      "Body lower/Size=1", "Body lower/Conditions=(0, 0): displacement: 0, 0",
                                      "Contact interface/Slave=lower:outer"});
    EXPECT_EQ(round.bodies[0].cells, (Cells{{3, 2}}));
    EXPECT_EQ(round.bodies[1].cells[0] % 2, 0u); // a disc needs an even number
    const Scene triangles = read_squares({"Tolerance=1e-3", "Body upper/Cell type=triangles"});
    EXPECT_EQ(triangles.bodies[0].degree, 2u);
    EXPECT_EQ(triangles.bodies[1].degree, 3u);
  }

  TEST(SceneTolerance, WritesItsChoicesDownSoThatTheyCanBeRunAgain)
  {
    const Scene scene = read_squares({"Tolerance=1e-3"});
    const Scene again = SceneFile(scene.parameters).read();
    EXPECT_EQ(again.tolerance, 1e-3);
    EXPECT_EQ(again.bodies[0].degree, 3u);
    EXPECT_EQ(again.bodies[0].cells, scene.bodies[0].cells);
    EXPECT_EQ(again.adaptation.estimator, "automatic");
    EXPECT_EQ(again.decomposition.tolerance, scene.decomposition.tolerance);
  }

  TEST(SceneTolerance, RefusesWhatDoesNotGoWithIt)
  {
    expect_tolerance_refused({"Tolerance=1"},
                             "Tolerance: received `1`, allowed are 0 and numbers from 1e-10 to below 1");
    expect_tolerance_refused(
        {"Tolerance=0.01", "Adaptation/Estimator=none", "Body upper/Adapt=false", "Body lower/Adapt=false"},
        "which needs an estimate");
    expect_tolerance_refused({"Adaptation/Estimator=automatic"}, "which needs a Tolerance above 0");
    expect_tolerance_refused({"Adaptation/Marking=automatic"}, "which needs a Tolerance above 0");
    expect_tolerance_refused({"Tolerance=1e-30"}, "allowed are 0 and numbers from 1e-10");
    expect_tolerance_refused({"Tolerance=0.01", "Adaptation/Estimator=none"}, "which needs an estimate");
    expect_tolerance_refused({"Goal=force"}, "without a Tolerance");
    expect_tolerance_refused(
        {"Tolerance=0.01", "Goal=moment"},
        "Goal: received `moment`, allowed are energy, force, peak pressure, stress at (x, y)");
    for (const std::string place : {"(1; 2)", "(1.2.3, 0)", "(., 0)", "(1e999, 0)"})
      expect_tolerance_refused({"Tolerance=0.01", "Goal=stress at " + place},
                               "Goal: received `stress at " + place + "`");
    expect_tolerance_refused({"Tolerance=0.01", "Adaptation/Combined=true", "Adaptation/Limit=0.1",
                              "Decomposition/Scheme=neumann", "Contact interface/Penalty coefficient=0.05"},
                             "Adaptation/Combined: received `true` with a Tolerance");
  }

  TEST(SceneTolerance, ReadsGoals)
  {
    EXPECT_TRUE(read_squares({"Tolerance=0.01"}).goal.is_energy());
    EXPECT_EQ(Goal::parse("force").kind, Goal::Kind::force);
    EXPECT_EQ(Goal::parse("peak pressure").kind, Goal::Kind::peak_pressure);
    const Goal stress = Goal::parse("stress at ( -1.5e-1, 2 )");
    EXPECT_EQ(stress.kind, Goal::Kind::stress);
    EXPECT_EQ(stress.point, Vector2(-.15, 2.));
    EXPECT_EQ(Goal::parse(stress.text()).point, stress.point);
  }
} // namespace
