// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Runs that are killed at moments that nobody chose, several times on end, and go on each time: they end with
// the files of the run that was left alone.

#include <gtest/gtest.h>

#include "../regression/result_folders.h"
#include "killed_process.h"
#include "mpirun.h"
#include <filesystem>
#include <random>

using namespace abut::testing;
namespace fs = std::filesystem;

namespace
{
  struct KilledScene
  {
    std::string name, file;
    std::vector<std::string> overrides;
  };

  /// How many processes the run has each time it is started, and after how many saved states, and some
  /// milliseconds more, it is killed.
  struct Plan
  {
    std::vector<unsigned int> n_processes;
    unsigned int seed, most_states, most_milliseconds;
  };

  constexpr std::size_t n_kills = 4;

  std::vector<std::string> arguments_of(const KilledScene &scene)
  {
    std::vector<std::string> arguments = {project_file(scene.file), "--quiet", "--set",
                                          "Output/Checkpoint=every pass"};
    for (const std::string &override : scene.overrides)
      arguments.insert(arguments.end(), {"--set", override});
    return arguments;
  }

  std::string new_folder()
  {
    return fs::path(temporary_file("marker", "")).parent_path() / "results";
  }

  struct Ended
  {
    std::string folder;
    unsigned int n_resumed = 0;
  };

  /// Kills the run until it has been killed often enough, or has been faster.
  Ended run_and_kill(const KilledScene &scene, const Plan &plan)
  {
    std::mt19937 random(plan.seed);
    const auto up_to = [&](const unsigned int most) {
      return std::uniform_int_distribution<unsigned int>(0, most)(random);
    };
    Ended ended{new_folder()};
    const std::string checkpoint = ended.folder + "/checkpoint";
    for (std::size_t start = 0; !fs::exists(ended.folder + "/summary.json"); ++start)
    {
      const bool goes_on = fs::exists(checkpoint);
      ended.n_resumed += goes_on ? 1 : 0;
      KilledProcess process(plan.n_processes[start % plan.n_processes.size()],
                            goes_on ? std::vector<std::string>{"--quiet", "--resume", ended.folder}
                                    : with(arguments_of(scene), {"--output", ended.folder}));
      if (start >= n_kills)
      {
        EXPECT_EQ(process.wait(), 0);
        break;
      }
      // At first something is to be there to go on from.
      process.wait_for_changes(checkpoint, std::max(up_to(plan.most_states), start == 0 ? 1u : 0u));
      process.wait_for(std::chrono::milliseconds(up_to(plan.most_milliseconds)));
      process.kill();
    }
    fs::remove(checkpoint); // left by a run that was killed when all its results were there
    return ended;
  }

  class KilledRun : public ::testing::TestWithParam<KilledScene>
  {
  protected:
    void expect_same_after(const Plan &plan)
    {
      SCOPED_TRACE("seed " + std::to_string(plan.seed));
      const Ended ended = run_and_kill(GetParam(), plan);
      EXPECT_GE(ended.n_resumed, 1u);
      expect_same_results(ended.folder, whole_.directory);
    }

    void SetUp() override
    {
      ASSERT_EQ(whole_.status, 0) << whole_.err;
      ASSERT_GE(whole_.summary["passes"], 4);
    }

    const Answer whole_ = run(arguments_of(GetParam()));
  };

  TEST_P(KilledRun, OfOneProcessEndsAsTheOneThatWasNotKilled)
  {
    expect_same_after({{1}, 1, 2, 20});
    expect_same_after({{1}, 2, 1, 200});
    expect_same_after({{1}, 3, 0, 400});
  }

  TEST_P(KilledRun, OfTwoProcessesEndsAsTheOneThatWasNotKilled)
  {
    expect_same_after({{2}, 4, 2, 50});
  }

  TEST_P(KilledRun, MayGoOnInAnotherNumberOfProcesses)
  {
    expect_same_after({{2, 1, 3, 2, 1}, 5, 1, 50});
  }

  const std::vector<std::string> adaptive_to_be_killed = {
      "Body upper/Cells=16, 4",      "Body lower/Cells=16, 4",     "Body upper/Adapt=true",
      "Body lower/Adapt=true",       "Adaptation/Estimator=fe-be", "Adaptation/Marking=doerfler",
      "Adaptation/Maximum passes=6", "Output/Points=(0.5, 0.5)"};

  const std::vector<KilledScene> killed_scenes = {
      {"tolerance", "prm/two-layers-tolerance.prm", {"Tolerance=0.0001"}},
      {"hanging_nodes_by_fe_be", "prm/two-layers-rollers.prm", adaptive_to_be_killed},
      {"penalised", "prm/two-layers-rollers.prm",
       with(adaptive_to_be_killed, {"Contact interface/Penalty coefficient=0.05"})},
      {"floating_disc",
       "prm/v-groove.prm",
       {"Body disc/Adapt=true", "Adaptation/Estimator=zz", "Adaptation/Maximum passes=4"}}};

  INSTANTIATE_TEST_SUITE_P(Scenes, KilledRun, ::testing::ValuesIn(killed_scenes),
                           [](const auto &scene) { return scene.param.name; });

  const KilledScene distributed = {"distributed",
                                   "prm/two-layers-rollers.prm",
                                   {"Body upper/Cells=16, 4", "Body lower/Cells=16, 4",
                                    "Body upper/Adapt=true", "Body lower/Adapt=true",
                                    "Body upper/Distributed mesh=true", "Body lower/Distributed mesh=true",
                                    "Adaptation/Estimator=kelly", "Adaptation/Maximum passes=6"}};

  // Numbers of cells and unknowns depend on the processes that share the mesh.
  TEST(KilledRunOfADistributedMesh, GoesOnInAsManyProcesses)
  {
    const Ended ended = run_and_kill(distributed, {{2}, 6, 2, 50});
    EXPECT_GE(ended.n_resumed, 1u);
    expect_same_results(ended.folder, run_processes({{2, arguments_of(distributed)}}).directory);
  }

  TEST(KilledRunOfADistributedMesh, DoesNotGoOnInOthers)
  {
    const std::string folder = new_folder();
    KilledProcess process(2, with(arguments_of(distributed), {"--output", folder}));
    process.wait_for_changes(folder + "/checkpoint", 1);
    process.kill();
    const Answer answer = run_processes_with({{3, {"--resume", folder}}});
    EXPECT_EQ(answer.status, 1);
    EXPECT_EQ(lines(answer.err).size(), 1u) << answer.err;
    EXPECT_NE(answer.err.find("is distributed; go on with mpirun -np 2"), std::string::npos) << answer.err;
  }

  // What is wrong is said once by several processes too.
  TEST(ResumedProcesses, RefuseAFolderInOneSentence)
  {
    const std::string folder = new_folder();
    fs::create_directories(folder);
    const Answer answer = run_processes_with({{2, {"--resume", folder}}});
    EXPECT_EQ(answer.status, 1);
    EXPECT_EQ(lines(answer.err).size(), 1u) << answer.err;
    EXPECT_NE(answer.err.find("there is no checkpoint"), std::string::npos) << answer.err;
  }
} // namespace
