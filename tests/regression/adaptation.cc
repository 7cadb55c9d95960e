// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Scenes whose meshes follow the error, run through the command line.

#include <gtest/gtest.h>

#include "program.h"
#include <cmath>

namespace
{
  using abut::testing::Answer;
  using abut::testing::column;
  using abut::testing::expect_balance;
  using abut::testing::project_file;
  using abut::testing::run;
  using abut::testing::run_scene;
  using Overrides = std::vector<std::string>;

  Overrides operator+(Overrides a, const Overrides &b)
  {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  }

  const Overrides both_adapt = {"Body upper/Adapt=true", "Body lower/Adapt=true", "Adaptation/Estimator=spr"};
  const Overrides coarse = {"Body upper/Cells=16, 4", "Body lower/Cells=16, 4",
                            "Contact interface/Penalty coefficient=5e-3"};

  /// A parabola of curvature 0.05 pressed by 2e-5 into layers of four cells: contact on some 0.03 of a cell's
  /// width of 1, with its middle at x = 0.37.
  Overrides contact_in_a_cell(const std::string &middle)
  {
    return {"Constants/Values=0.05, 2e-5",
            "Contact interface/Gap=r0*(x-" + middle + ")^2",
            "Body upper/Cells=4, 1",
            "Body lower/Cells=4, 1",
            "Decomposition/Stopping rule=bound",
            "Decomposition/Initial guess=elastic layer response",
            "Decomposition/Relaxation=automatic",
            "Decomposition/Tolerance=1e-6"};
  }
} // namespace

TEST(Adaptation, TenPassesLeaveDisplacementTractionAndForcesConsistent)
{
  const Answer answer =
      run_scene("two-layers-rollers", coarse + both_adapt + Overrides{"Adaptation/Coarsening=0.02"});
  ASSERT_EQ(answer.status, 0) << answer.err;
  EXPECT_EQ(answer.summary["passes"], 10);
  EXPECT_EQ(answer.summary["stopped_by"], "maximum passes");
  expect_balance(answer);
  // The supports carry what the contact presses with, and on both sides the same.
  const double force = answer.summary["contacts"][0]["normal_force"];
  EXPECT_NEAR(answer.summary["bodies"][0]["reactions"]["top"][1].get<double>(), -force, 1e-9 * force);
  EXPECT_NEAR(answer.summary["bodies"][1]["reactions"]["bottom"][1].get<double>(), force, 1e-9 * force);
  // Uniform meshes have the energy error 1.75/sqrt(unknowns), doc/results.md; adaptation gains a quarter at
  // least.
  const double unknowns = answer.summary["pass_table"].back()["dofs"];
  EXPECT_LT(answer.summary["true_error"]["energy"].get<double>(), 1.75 / 1.25 / std::sqrt(unknowns));
  EXPECT_NEAR(answer.summary["error"]["effectivity"].get<double>(), 1., .05);
}

TEST(Adaptation, ABodyThatDoesNotAdaptIsNeitherRebuiltNorFactorisedAgain)
{
  const Answer answer =
      run_scene("two-layers-rollers", coarse + Overrides{"Body lower/Adapt=true", "Adaptation/Estimator=zz",
                                                         "Adaptation/Maximum passes=4"});
  ASSERT_EQ(answer.status, 0) << answer.err;
  const auto &bodies = answer.summary["counters"]["bodies"];
  for (const std::string counter : {"meshes", "assemblies", "factorisations"})
  {
    EXPECT_EQ(bodies["upper"][counter], 1) << counter;
    EXPECT_EQ(bodies["lower"][counter], 4) << counter;
  }
}

TEST(Adaptation, BodiesThatNeverTouchConvergeWithoutPressure)
{
  const Answer answer =
      run_scene("two-layers", both_adapt + Overrides{"Contact interface/Gap=0.5", "Adaptation/Limit=0.1",
                                                     "Decomposition/Stopping rule=bound",
                                                     "Decomposition/Initial guess=elastic layer response"});
  ASSERT_EQ(answer.status, 0) << answer.err;
  EXPECT_EQ(answer.summary["status"], "converged");
  EXPECT_EQ(answer.summary["stopped_by"], "limit");
  EXPECT_EQ(answer.summary["passes"], 1);
  EXPECT_EQ(answer.summary["contacts"][0]["normal_force"], 0.);
  EXPECT_EQ(answer.summary["error"]["eta_max"], 0.);
}

TEST(Adaptation, ContactSmallerThanACellIsFound)
{
  // The curvature is so large that the bodies are half-planes for the contact: Hertz with the radius 1/(2 r0)
  // relates force, half-width and peak (eight cells to the half-width: (1/8)^2 and some for the discrete
  // peak) by p0 = 2 P/(pi a), and a = pi p0 R/(2 E*) with 1/E* = 2 (1 - nu^2)/E.
  for (const std::string middle : {"0.5", "0.37", "0.58"})
  {
    const Answer answer = run_scene(
        "two-layers", contact_in_a_cell(middle) + both_adapt +
                          Overrides{"Adaptation/Maximum passes=14", "Contact interface/Penalty=1e-9"});
    ASSERT_EQ(answer.status, 0) << answer.err;
    const auto &contact = answer.summary["contacts"][0];
    EXPECT_EQ(contact["missed_contact"], 0);
    const double peak = contact["max_pressure"], modulus = 2.1e5 / (2. * .91);
    const double half_width = 2. * peak * 10. / modulus; // p0 = a E*/(2 R)
    EXPECT_GT(peak, 10.);
    EXPECT_NEAR(contact["normal_force"].get<double>(), std::acos(-1.) / 2. * peak * half_width,
                .025 * contact["normal_force"].get<double>())
        << "middle at " << middle;
    expect_balance(answer);
  }
}

TEST(Adaptation, ContactSmallerThanACellIsNotSilentlyMissedOnAFixedMesh)
{
  const Answer answer = run_scene("two-layers", contact_in_a_cell("0.5"));
  EXPECT_GT(answer.summary["contacts"][0]["missed_contact"].get<int>(), 0);
  EXPECT_EQ(warning_codes(answer).count("missed-contact"), 1u);
  EXPECT_NE(answer.err.find(" at (0.5"), std::string::npos) << answer.err; // the place
  EXPECT_NE(answer.err.find("contact smaller than a cell"), std::string::npos) << answer.err;
}

TEST(Adaptation, TheLimitEndsTheRunOrStatusTwoDoes)
{
  const Overrides limit = {"Adaptation/Limit=0.2", "Adaptation/Marking=threshold"};
  const Answer reached = run_scene("two-layers-rollers", coarse + both_adapt + limit);
  ASSERT_EQ(reached.status, 0) << reached.err;
  EXPECT_EQ(reached.summary["stopped_by"], "limit");
  EXPECT_LE(reached.summary["error"]["eta_max"].get<double>(), .2);

  const Answer missed =
      run_scene("two-layers-rollers", coarse + both_adapt + limit + Overrides{"Adaptation/Maximum passes=2"});
  EXPECT_EQ(missed.status, 2);
  EXPECT_EQ(missed.summary["status"], "not converged");
  EXPECT_EQ(missed.summary["stopped_by"], "maximum passes");
  EXPECT_NE(missed.err.find("Adaptation/Limit = 0.2"), std::string::npos) << missed.err;
}

TEST(Adaptation, TurningMirroringAndUnitsChangeNoMesh)
{
  const Overrides passes =
      coarse + both_adapt + Overrides{"Adaptation/Maximum passes=5", "Reference/Exact solution=none"};
  const Answer plain = run_scene("two-layers-rollers", passes);
  const Answer moved = run_scene(
      "two-layers-rollers", passes + Overrides{"Body upper/Rotation angle=90", "Body lower/Rotation angle=90",
                                               "Body upper/Scale=1e-3", "Body lower/Scale=1e-3",
                                               "Body upper/Shift=4.999, 7", "Body lower/Shift=5, 7"});
  ASSERT_EQ(plain.status, 0) << plain.err;
  ASSERT_EQ(moved.status, 0) << moved.err;
  for (const std::size_t body : {0u, 1u})
    EXPECT_EQ(plain.summary["bodies"][body]["cells"], moved.summary["bodies"][body]["cells"]);
  const double force = plain.summary["contacts"][0]["normal_force"];
  EXPECT_NEAR(moved.summary["contacts"][0]["normal_force"].get<double>(), 1e-3 * force, 1e-9 * force);
}

TEST(Adaptation, TrianglesAndHigherDegreesAdaptToo)
{
  for (const std::string change :
       {"Body upper/Cell type=triangles", "Discretisation/Degree=2", "Discretisation/Degree=3"})
  {
    const Answer answer = run_scene("two-layers-rollers",
                                    coarse + both_adapt + Overrides{"Adaptation/Maximum passes=5", change});
    ASSERT_EQ(answer.status, 0) << change << ": " << answer.err;
    const auto &table = answer.summary["pass_table"];
    EXPECT_LT(table[4]["true_error_energy"].get<double>(), .6 * table[0]["true_error_energy"].get<double>())
        << change;
    expect_balance(answer);
  }
}

// A step of the scheme newton gains everything: the other two can stop early.
TEST(Adaptation, EveryPassIteratesToItsShareOfTheEstimatedError)
{
  const Overrides neumann =
      coarse + both_adapt +
      Overrides{"Decomposition/Scheme=neumann", "Contact interface/Penalty coefficient=5e-4"};
  const Answer answer = run_scene("two-layers-rollers", neumann + Overrides{"Adaptation/Maximum passes=5"});
  ASSERT_EQ(answer.status, 0) << answer.err;
  for (const auto &pass : answer.summary["pass_table"])
  {
    const double discretisation = pass["error_discretisation"], iteration = pass["error_iteration"];
    EXPECT_LE(iteration, .1 * discretisation);
    EXPECT_GT(iteration, 1e-4 * discretisation); // and not much further
    const double penalty = pass["error_penalty"];
    EXPECT_GT(penalty, 0.);
    EXPECT_NEAR(pass["error_total"].get<double>(), std::hypot(discretisation, iteration, penalty),
                1e-12); // round-off is the rest
  }
  const Answer to_the_end =
      run_scene("two-layers-rollers",
                neumann + Overrides{"Adaptation/Maximum passes=2", "Adaptation/Iteration fraction=0"});
  EXPECT_LE(to_the_end.summary["pass_table"][1]["error_iteration"].get<double>(), 1e-6);
}

TEST(Adaptation, TheEnergyGrowsByTheSquareOfTheChange)
{
  // Galerkin's orthogonality on nested meshes under the same load: |u_2|^2 = |u_1|^2 + |u_2 - u_1|^2.
  const auto bracket = [](const std::string &passes) {
    return run_scene("corner", {"Body bracket/Conditions=bottom: displacement: 0, 0; right: traction: 0, -1",
                                "Reference/Exact solution=none", "Adaptation/Maximum passes=" + passes});
  };
  const Answer one = bracket("1"), two = bracket("2");
  ASSERT_EQ(two.status, 0) << two.err;
  const double before = one.summary["bodies"][0]["energy"], after = two.summary["bodies"][0]["energy"];
  const double change = two.summary["pass_table"][1]["change"];
  EXPECT_GT(change, .01);
  EXPECT_NEAR((after - before) / after, change * change, 1e-9);
}

TEST(Adaptation, TheMaximumOfUnknownsEndsTheRun)
{
  const Answer answer =
      run_scene("two-layers-rollers", coarse + both_adapt + Overrides{"Adaptation/Maximum unknowns=600"});
  ASSERT_EQ(answer.status, 0) << answer.err;
  EXPECT_EQ(answer.summary["stopped_by"], "maximum unknowns");
  const auto &table = answer.summary["pass_table"];
  EXPECT_GE(table[table.size() - 1]["dofs"].get<int>(), 600);
  EXPECT_LT(table[table.size() - 2]["dofs"].get<int>(), 600);
}

TEST(Adaptation, ZZAtDegreeTwoIsWarnedOf)
{
  const Overrides zz = {"Adaptation/Estimator=zz"};
  EXPECT_EQ(run_scene("patch-test", zz).summary["warnings"].size(), 0u);
  EXPECT_EQ(run_scene("patch-test", zz + Overrides{"Discretisation/Degree=2"}).summary["warnings"].size(),
            1u);
}

TEST(Adaptation, FiniteLayersDifferFromInfiniteOnesByTheirFreeEnds)
{
  // Known of these scenes, four heights long, by an independent computation: the stress differs by 2.3e-4 on
  // a sliding base and by 8.4e-3 on a bonded one; the penalty of c = 1e-3 adds some 6e-4.
  for (const auto &[scene, solution, lowest, highest] :
       {std::tuple("two-layers", "sliding", 0., 1.2e-3),
        std::tuple("two-layers-bonded", "bonded", 7.6e-3, 9.2e-3)})
  {
    const Answer answer = run_scene(
        scene,
        both_adapt + Overrides{std::string("Reference/Exact solution=infinite layers ") + solution,
                               "Reference/Approach=approach", "Reference/Gap curvature=r0",
                               "Contact interface/Penalty coefficient=1e-3", "Discretisation/Degree=3",
                               "Body upper/Cells=16, 4", "Body lower/Cells=16, 4",
                               "Decomposition/Stopping rule=bound", "Decomposition/Relaxation=automatic",
                               "Decomposition/Initial guess=elastic layer response",
                               "Decomposition/Tolerance=1e-6", "Adaptation/Maximum passes=8"});
    ASSERT_EQ(answer.status, 0) << answer.err;
    const double stress = answer.summary["true_error"]["stress"],
                 force = answer.summary["true_error"]["force"];
    std::cout << scene << ": stress differs from the infinite layers' by " << stress << ", force by " << force
              << '\n';
    EXPECT_GE(stress, lowest);
    EXPECT_LE(stress, highest);
    EXPECT_LE(force, 1e-3);
    EXPECT_TRUE(answer.summary["error"]["effectivity"].is_null());
  }
}

TEST(Adaptation, AStudyPrintsAndWritesEveryPassOfEveryVariant)
{
  const Answer answer =
      run({"study", project_file("prm/two-layers-rollers.prm"), "--set",
           "Study/Variants=a: Adaptation/Estimator=zz; b: Adaptation/Estimator=kelly", "--set",
           "Study/Crossed with=two: Adaptation/Maximum passes=2; three: Adaptation/Maximum passes=3"});
  ASSERT_EQ(answer.status, 0) << answer.err;
  const auto unknowns = column(answer.directory + "/study.csv", "dofs");
  EXPECT_EQ(unknowns.size(), 10u);
  for (const std::string name : {"a, two", "a, three", "b, two", "b, three"})
    EXPECT_NE(answer.out.find(name), std::string::npos) << name;
}
