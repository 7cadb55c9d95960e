// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What the program answers when nothing is wrong.

#include <abut/program/command_line.h>

#include <gtest/gtest.h>

#include "program.h"
#include <cmath>
#include <filesystem>
#include <sstream>

namespace
{
  using abut::testing::Answer;
  using abut::testing::project_file;
  using abut::testing::read_file;
  using abut::testing::run;
  using abut::testing::temporary_file;

  const std::vector<std::string> all_scenes = {"two-layers", "two-layers-bonded", "two-layers-rollers",
                                               "patch-test", "three-bodies",      "shrink-fit",
                                               "hertz"};
} // namespace

TEST(Program, WritesTheFilesOfTheContract)
{
  const Answer answer = run({project_file("prm/patch-test.prm")});
  ASSERT_EQ(answer.status, 0) << answer.err;
  for (const std::string name :
       {"parameters.prm", "history.csv", "summary.json", "report.html", "contact_interface.csv",
        "solution.pvd", "solution.pvtu", "solution_upper.vtu", "solution_lower.vtu", "solution.svg"})
    EXPECT_TRUE(std::filesystem::exists(answer.directory + "/" + name)) << name;
  for (const auto &entry : std::filesystem::directory_iterator(answer.directory))
    EXPECT_EQ(entry.path().filename().string().find(".partial"), std::string::npos)
        << "left behind: " << entry.path();
  for (const std::string key : {"status", "stopped_by", "passes", "bodies", "contacts", "error", "true_error",
                                "time_s", "peak_memory_mb", "left_out"})
    EXPECT_TRUE(answer.summary.contains(key)) << key;
  const std::string history = read_file(answer.directory + "/history.csv");
  EXPECT_EQ(history.substr(0, history.find('\n')),
            "pass,step,dofs,boundary_dofs,cells,eta_max,increment,"
            "error_discretisation,error_penalty,error_iteration,"
            "error_total,true_error_energy,true_error_stress,"
            "effectivity,effectivity_total,normal_force,max_pressure,"
            "wall_time_s,true_error_pressure,true_error_force,"
            "error_stress,change,step_discretisation,step_bound,step_true_error,"
            "step_discretisation_ratio,step_bound_ratio,error_contact,error_linear_algebra,"
            "error_geometry,error_bound,error_estimate,error_pressure");
}

TEST(Program, ParametersCanBeRunAgain)
{
  const Answer first = run({project_file("prm/patch-test.prm"), "--set", "Body upper/Young modulus=50"});
  ASSERT_EQ(first.status, 0) << first.err;
  const Answer second = run({first.directory + "/parameters.prm"});
  ASSERT_EQ(second.status, 0) << second.err;
  EXPECT_EQ(read_file(first.directory + "/contact_interface.csv"),
            read_file(second.directory + "/contact_interface.csv"));
}

TEST(Program, ChecksEveryScene)
{
  for (const std::string &scene : all_scenes)
  {
    const Answer answer = run({project_file("prm/" + scene + ".prm"), "--check"});
    EXPECT_EQ(answer.status, 0) << scene << ": " << answer.err;
    for (const std::string phrase :
         {"unknowns", "supports:", "rigid motions left free: none", "gap (", "theta = "})
      EXPECT_NE(answer.out.find(phrase), std::string::npos) << scene << ": " << phrase;
    EXPECT_FALSE(std::filesystem::exists(answer.directory)) << "--check has written something";
  }
}

TEST(Program, QuietPrintsNothing)
{
  const Answer answer = run({project_file("prm/patch-test.prm"), "--quiet"});
  EXPECT_EQ(answer.status, 0);
  EXPECT_EQ(answer.out, "");
  EXPECT_EQ(answer.err, "");
}

TEST(Program, ExplainsItself)
{
  EXPECT_NE(run({"--help"}).out.find("--set"), std::string::npos);
  EXPECT_NE(run({"--version"}).out.find("abut 0."), std::string::npos);
  const std::string parameters = run({"--print-parameters"}).out;
  for (const std::string name : {"Young modulus", "Penalty coefficient", "Relaxation", "Exact solution"})
    EXPECT_NE(parameters.find(name), std::string::npos) << name;
}

TEST(Program, AStretchedBystanderDoesNotLoosenTheTolerance)
{
  const std::string scene = read_file(project_file("prm/patch-test.prm"));
  std::string crowded = scene;
  crowded.replace(crowded.find("upper, lower"), 12, "upper, lower, bystander");
  crowded += "subsection Body bystander\n  set Size = 1, 1\n  set Shift = 5, 0\n  set Cells = 2, 2\n"
             "  set Young modulus = 1e9\n  set Poisson ratio = 0.3\n"
             "  set Conditions = left: displacement: 0, 0; right: displacement: 1, 0\nend\n";
  const Answer alone = run({temporary_file("alone.prm", scene)});
  const Answer answer = run({temporary_file("crowded.prm", crowded)});
  ASSERT_EQ(answer.status, 0) << answer.err;
  EXPECT_EQ(answer.summary["steps"], alone.summary["steps"]);
}

TEST(Program, AFailedRunLeavesNoOldSummaryBehind)
{
  const Answer good = run({project_file("prm/patch-test.prm")});
  ASSERT_EQ(good.status, 0) << good.err;
  // The last `--output` counts: the second run goes into the first one's folder.
  std::ostringstream out, err;
  const std::string scene = project_file("prm/patch-test.prm");
  const std::vector<const char *> arguments = {
      "abut",     scene.c_str(),
      "--set",    "Decomposition/Scheme=neumann",
      "--set",    "Body upper/Conditions=left: normal displacement: 0; top: resultant: 0, 5",
      "--output", good.directory.c_str()};
  EXPECT_EQ(abut::run_command_line(static_cast<int>(arguments.size()), arguments.data(), out, err), 2);
  EXPECT_FALSE(std::filesystem::exists(good.directory + "/summary.json"));
}

TEST(Program, TheReadmesFirstSceneRuns)
{
  std::istringstream readme(read_file(project_file("README.md")));
  std::string scene;
  bool inside = false;
  for (std::string line; std::getline(readme, line);)
  {
    inside = inside || line.find("set Bodies   = steel, nylon") != std::string::npos;
    if (inside && !line.empty() && line[0] != ' ')
      break;
    if (inside)
      scene += line + '\n';
  }
  const Answer answer = run({temporary_file("blocks.prm", scene)});
  ASSERT_EQ(answer.status, 0) << answer.err << scene;
  EXPECT_EQ(warning_codes(answer), std::multiset<std::string>{"singular-pressure"}); // the edge of the steel
  const auto &bodies = answer.summary["bodies"];
  const double force = answer.summary["contacts"][0]["normal_force"];
  EXPECT_GT(force, 0.);
  EXPECT_NEAR(bodies[0]["reactions"]["top"][1].get<double>(), -force, 1e-9 * force);
  EXPECT_NEAR(bodies[1]["reactions"]["bottom"][1].get<double>(), force, 1e-9 * force);
}

TEST(Program, OneBodyWithoutContact)
{
  // A bar under its own weight, hung up at the top: u_y = -w/(2 M) (H^2 - y^2)... with rollers at the sides,
  // where M = E (1 - nu)/((1 + nu)(1 - 2 nu)) and w is the weight per volume; strain energy w^2 H^3 W / (6
  // M).
  const Answer answer = run(
      {temporary_file("bar.prm", "set Bodies = bar\n"
                                 "subsection Body bar\n"
                                 "  set Shape = rectangle\n  set Size = 2, 3\n  set Cells = 2, 40\n"
                                 "  set Degree = 2\n  set Young modulus = 10\n  set Poisson ratio = 0.25\n"
                                 "  set Body force = 0, -0.5\n"
                                 "  set Conditions = left: normal displacement: 0; "
                                 "right: normal displacement: 0; top: displacement: 0, 0\nend\n")});
  ASSERT_EQ(answer.status, 0) << answer.err;
  const double modulus = 10. * .75 / (1.25 * .5);
  EXPECT_NEAR(answer.summary["bodies"][0]["energy"].get<double>(), .25 * 27. * 2. / (6. * modulus), 1e-12);
  EXPECT_NEAR(answer.summary["bodies"][0]["reactions"]["top"][1].get<double>(), .5 * 6., 1e-10);
  EXPECT_TRUE(answer.summary["contacts"].empty());
}
