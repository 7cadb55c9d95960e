// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What is wrong in one process, or in all, is said once and ends them all.

#include <gtest/gtest.h>

#include "mpirun.h"
#include <fcntl.h>
#include <filesystem>
#include <sys/file.h>
#include <unistd.h>

using namespace abut::testing;

namespace
{
  const std::string scene = project_file("prm/two-layers.prm");

  std::vector<std::string> with_override(const std::string &override)
  {
    return {scene, "--quiet", "--set", override};
  }

  TEST(OneMessage, OfInputThatIsWrongInAllProcesses)
  {
    expect_refused(run_processes({{3, with_override("Body lower/Poisson ratio=0.7")}}),
                   {scene, "Poisson ratio: received `0.7`"});
    expect_refused(run_processes({{2, {"--nonsense"}}}), {"--nonsense"});
    expect_refused(run_processes({{2, {project_file("prm/no-such-scene.prm")}}}), {"no-such-scene.prm"});
  }

  TEST(OneMessage, OfInputThatIsWrongInOneProcess)
  {
    const std::vector<std::string> good = {scene, "--quiet"};
    for (const std::string wrong : {"Body lower/Poisson ratio=0.7", "Contact interface/Slave=lower:roof"})
    {
      const Answer last = run_processes({{2, good}, {1, with_override(wrong)}});
      EXPECT_EQ(last.status, 1) << wrong;
      EXPECT_EQ(lines(last.err).size(), 1u) << last.err;
      EXPECT_TRUE(last.summary.is_null());
      expect_refused(run_processes({{1, with_override(wrong)}, {2, good}}), {scene});
    }
  }

  TEST(OneMessage, OfABodyInMoreProcessesThanThereAre)
  {
    expect_refused(run_processes({{2, with_override("Body lower/Processes=3")}}),
                   {scene, "Body lower/Processes: received 3, but this run has only 2", "mpirun -np 3"});
    EXPECT_EQ(run(with_override("Body lower/Processes=3")).status, 0); // alone it is not asked for
  }

  TEST(OneMessage, OfABodyInSeveralProcessesThatCannotBeSolved)
  {
    for (const std::string material : {"Young modulus=1e308", "Poisson ratio=0.49999999999999994"})
    {
      std::vector<std::string> arguments = with_override("Body upper/" + material);
      arguments.insert(arguments.end(),
                       {"--set", "Body upper/Processes=2", "--set", "Body lower/Processes=2"});
      const Answer answer = run_processes({{2, arguments}});
      EXPECT_EQ(answer.status, 2) << material;
      EXPECT_EQ(lines(answer.err).size(), 1u) << answer.err;
      EXPECT_NE(answer.err.find("Body upper: "), std::string::npos) << answer.err;
      EXPECT_TRUE(answer.summary.is_null());
    }
  }

  TEST(OneMessage, OfWhatOneOfTheProcessesOfABodyCannotWrite)
  {
    // The first process writes the file, in a turn that the others take too.
    const std::filesystem::path folder = std::filesystem::path(temporary_file("marker", "")).parent_path();
    std::filesystem::create_directories(folder / "solution_lower.vtu" / "taken");
    std::vector<std::string> arguments = with_override("Body lower/Processes=3");
    arguments.insert(arguments.end(), {"--set", "Body upper/Processes=2"});
    const Answer answer = run_processes_in(folder, {{3, arguments}}),
                 alone = run_in(folder, {scene, "--quiet"});
    EXPECT_NE(alone.status, 0);
    EXPECT_EQ(answer.status, alone.status);
    EXPECT_EQ(lines(answer.err).size(), 1u) << answer.err;
    EXPECT_NE(answer.err.find("solution_lower.vtu"), std::string::npos) << answer.err;
  }

  TEST(OneMessage, OfABodyThatCannotBeFactorised)
  {
    for (const std::string body : {"upper", "lower"}) // one of them lives in the second process
    {
      const Answer answer = run_processes({{2, with_override("Body " + body + "/Young modulus=1e308")}});
      EXPECT_EQ(answer.status, 2);
      EXPECT_EQ(lines(answer.err).size(), 1u) << answer.err;
      EXPECT_NE(answer.err.find("Body " + body + ": "), std::string::npos) << answer.err;
      EXPECT_TRUE(answer.summary.is_null());
    }
  }

  TEST(OneMessage, OfProcessesThatReadDifferentScenes)
  {
    const std::vector<std::string> other = with_override("Body upper/Young modulus=1.000001e5");
    expect_refused(run_processes({{1, {scene, "--quiet"}}, {1, other}}),
                   {scene, "the processes 0 and 1 of this run have read different parameters"});
    expect_refused(
        run_processes({{2, {scene, "--quiet"}}, {1, {project_file("prm/two-layers-paper.prm"), "--quiet"}}}),
        {"the processes 0 and 2 of this run have read different parameters"});
  }

  TEST(OneMessage, OfAFolderThatIsTaken)
  {
    const std::string folder = std::filesystem::path(temporary_file("marker", "")).parent_path();
    const int taken = open(folder.c_str(), O_RDONLY | O_DIRECTORY);
    ASSERT_EQ(flock(taken, LOCK_EX), 0);
    const Answer answer = run_processes_in(folder, {{2, {scene, "--quiet"}}});
    close(taken);
    EXPECT_EQ(answer.status, 1);
    EXPECT_EQ(lines(answer.err).size(), 1u) << answer.err;
    EXPECT_NE(answer.err.find("another run writes its results"), std::string::npos) << answer.err;
    EXPECT_TRUE(answer.summary.is_null());
  }

  TEST(OneMessage, OfCommandsThatProcessesCannotShare)
  {
    for (const std::string word : {"study", "schemes", "reproduce"})
      expect_refused(run_processes({{2, {word, project_file("prm/two-layers-rollers.prm")}}}),
                     {"received 2 processes", "without mpirun"});
  }

  TEST(OneMessage, OfWhatIsAskedForOnce)
  {
    const Answer check = run_processes({{2, {scene, "--check"}}}), alone = run({scene, "--check"});
    EXPECT_EQ(check.status, 0) << check.err;
    EXPECT_EQ(check.out, alone.out);
    EXPECT_EQ(lines(run_processes({{3, {"--version"}}}).out).size(), 1u);
  }
} // namespace
