// SPDX-License-Identifier: LGPL-2.1-or-later
//
// `Tolerance` and `Goal` as a user meets them.
#include <gtest/gtest.h>

#include "program.h"
#include <cmath>

using namespace abut::testing;

namespace
{
  const std::string scene = "two-layers-tolerance";
  // prm/two-layers-rollers.prm
  constexpr double exact_force = 133.8365, exact_peak = 172.0703;

  double relative_error(const nlohmann::json &value, const double exact)
  {
    return std::abs(value.get<double>() / exact - 1.);
  }
} // namespace

TEST(Tolerance, IsAllThatAFileHasToSay)
{
  const Answer answer = run_scene(scene);
  ASSERT_EQ(answer.status, 0) << answer.err;
  EXPECT_EQ(answer.summary["stopped_by"], "tolerance");
  EXPECT_LE(answer.summary["error"]["total"].get<double>(), .01);
  EXPECT_LE(answer.summary["true_error"]["energy"].get<double>(), .01);
  EXPECT_TRUE(answer.summary["error"]["error_is_bound"].get<bool>());
  EXPECT_EQ(answer.summary["goal"]["name"], "energy");
  for (const char *part :
       {"discretisation", "contact", "penalty", "linear_algebra", "geometry", "bound", "estimate"})
    EXPECT_TRUE(answer.summary["error"][part].is_number()) << part;
  EXPECT_NE(answer.out.find("most of it discretisation"), std::string::npos) << answer.out;
  EXPECT_NE(answer.out.find("quadrilaterals of degree 3"), std::string::npos) << answer.out;
}

TEST(Tolerance, RunsAgainFromItsOwnParameters)
{
  const Answer first = run_scene(scene);
  const Answer second = run({first.directory + "/parameters.prm"});
  ASSERT_EQ(second.status, 0) << second.err;
  EXPECT_EQ(first.summary["error"], second.summary["error"]);
  EXPECT_EQ(first.summary["bodies"], second.summary["bodies"]);
}

TEST(Tolerance, IsKeptByForcePeakAndStress)
{
  const Answer fine = run_scene(scene, {"Tolerance=1e-5", "Goal=stress at (0.9, 0.8)"});
  ASSERT_EQ(fine.status, 0) << fine.err;
  for (const double tolerance : {1e-2, 1e-3, 1e-4})
  {
    SCOPED_TRACE(tolerance);
    const std::string asked = "Tolerance=" + std::to_string(tolerance);
    const Answer force = run_scene(scene, {asked, "Goal=force"}),
                 peak = run_scene(scene, {asked, "Goal=peak pressure"}),
                 stress = run_scene(scene, {asked, "Goal=stress at (0.9, 0.8)"});
    for (const Answer *answer : {&force, &peak, &stress})
    {
      ASSERT_EQ(answer->status, 0) << answer->err;
      EXPECT_LE(answer->summary["goal"]["error"].get<double>(), tolerance);
    }
    EXPECT_LE(relative_error(force.summary["goal"]["value"], exact_force), tolerance);
    EXPECT_LE(relative_error(peak.summary["goal"]["value"], exact_peak), tolerance);
    EXPECT_LE(relative_error(stress.summary["goal"]["value"], fine.summary["goal"]["value"].get<double>()),
              tolerance + 1e-5);
  }
}

TEST(Tolerance, SaysWhatPreventsIt)
{
  const auto expect_missed = [](const Answer &answer, const std::string &stopped_by,
                                const std::string &phrase) {
    EXPECT_EQ(answer.status, 2);
    EXPECT_EQ(answer.summary["stopped_by"], stopped_by);
    EXPECT_EQ(answer.summary["status"], "not converged");
    EXPECT_NE(answer.err.find(phrase), std::string::npos) << answer.err;
    EXPECT_NE(answer.err.find("where Tolerance = 1 %"), std::string::npos) << answer.err;
  };
  expect_missed(run_scene(scene, {"Body upper/Adapt=false", "Body lower/Adapt=false"}), "no body adapts",
                "No body has Adapt = true");
  expect_missed(run_scene(scene, {"Adaptation/Maximum passes=1"}), "maximum passes", "Maximum passes");
  expect_missed(run_scene(scene, {"Adaptation/Maximum unknowns=500"}), "maximum unknowns",
                "Maximum unknowns");
  expect_missed(run_scene(scene, {"Contact interface/Penalty coefficient=0.05"}), "penalty",
                "most of it penalty (3.1 %); lower Contact/Penalty coefficient");
  expect_missed(run_scene(scene, {"Contact interface/Penalty coefficient=0.05", "Goal=force"}), "penalty",
                "Goal = force is");
}

// A mesh that compares with itself may be blind: u = A (r - 1/r) around a ring, of which jumps saw a fifth.
TEST(Tolerance, IsNotReachedByAnEstimatorThatIsBlind)
{
  const std::string ring =
      "set Bodies = r\nset Tolerance = 0.004\nsubsection Body r\n set Shape = ring\n"
      " set Size = 1, 2\n set Young modulus = 1e5\n set Poisson ratio = 0.3\n"
      " set Conditions = inner: displacement: 0, 0; outer: displacement: -1e-3*y, 1e-3*x\nend\n";
  const double mu = 1e5 / 2.6, amplitude = 2e-3 / 1.5, exact = 1.5 * M_PI * mu * amplitude * amplitude;
  for (const std::string cells : {"", "4, 1", "8, 1"})
  {
    SCOPED_TRACE(cells);
    const Answer answer = run_text(ring, cells.empty() ? std::vector<std::string>()
                                                       : std::vector<std::string>{"Body r/Cells=" + cells});
    ASSERT_EQ(answer.status, 0) << answer.err;
    // The prescribed displacement makes the computed energy the larger one, by the square of the error.
    const double energy = answer.summary["bodies"][0]["energy"];
    EXPECT_LE(std::sqrt(std::max(0., energy / exact - 1.)), .004);
  }
}

TEST(Tolerance, EndsWhereItCannotBeReached)
{
  const Answer fixed = run_scene(scene, {"Body upper/Adapt=false", "Tolerance=1e-3"});
  EXPECT_EQ(fixed.status, 2);
  EXPECT_NE(fixed.err.find("The bodies with Adapt = false alone"), std::string::npos) << fixed.err;
  const Answer corner =
      run_scene("corner", {"Tolerance=0.01", "Goal=stress at (0, 0)", "Adaptation/Estimator=automatic",
                           "Adaptation/Marking=automatic", "Adaptation/Maximum passes=60"});
  EXPECT_EQ(corner.status, 2);
  EXPECT_NE(corner.err.find("The goal does not settle"), std::string::npos) << corner.err;
  EXPECT_NE(corner.err.find("the stress at (0, 0), the Goal, is infinite"), std::string::npos) << corner.err;
}

// Contact on a rigid outline has cells on one side only.
TEST(Tolerance, TakesRigidOutlines)
{
  const Answer answer = run_scene("coated-block", {"Tolerance=0.05"});
  EXPECT_NE(answer.status, 1) << answer.err;
  EXPECT_TRUE(answer.summary["error"]["total"].is_number());
}

// fe-be is not made for curved cells of degree 3: kelly stands in, and is named.
TEST(Tolerance, NamesTheEstimatorThatHasRun)
{
  const auto last = [](const Answer &answer) { return answer.summary["pass_table"].back()["estimated_by"]; };
  EXPECT_EQ(last(run_scene(scene)), "fe-be");
  EXPECT_EQ(last(run_scene("shrink-fit", {"Tolerance=0.01", "Discretisation/Degree=3"})), "kelly");
}

// What is given stays, and the goal is reached all the same.
TEST(Tolerance, WorksWithWhatIsGiven)
{
  for (const std::vector<std::string> &given :
       {std::vector<std::string>{"Discretisation/Degree=1", "Tolerance=0.05"},
        {"Adaptation/Estimator=kelly", "Adaptation/Marking=doerfler"},
        {"Adaptation/Estimator=fe-be", "Adaptation/Marking=fixed fraction", "Adaptation/Fraction=0.3"},
        {"Body upper/Cells=12, 3"},
        {"Body upper/Cell type=triangles", "Body lower/Cell type=triangles"},
        {"Decomposition/Scheme=conjugate"},
        {"Decomposition/Scheme=neumann", "Contact interface/Penalty coefficient=1e-3"},
        {"Contact interface/Slave=upper:bottom", "Contact interface/Master=lower:top"}})
  {
    SCOPED_TRACE(given.front());
    const Answer answer = run_scene(scene, given);
    ASSERT_EQ(answer.status, 0) << answer.err;
    const double tolerance = answer.summary["goal"]["tolerance"].get<double>();
    EXPECT_LE(answer.summary["true_error"]["energy"].get<double>(), tolerance);
  }
}

TEST(Tolerance, RefusesGoalsThatAreNowhere)
{
  expect_refused(run_scene(scene, {"Goal=stress at (9, 9)"}),
                 {"Goal: received `stress at (9, 9)`, but no elastic body has this point"});
  expect_refused(run_scene("corner", {"Tolerance=0.1", "Goal=force"}), {"in a scene without contacts"});
  expect_refused(run_scene(scene, {"Goal=stress at (0.9, 1)"}), {"upper", "lower", "both have this point"});
}
