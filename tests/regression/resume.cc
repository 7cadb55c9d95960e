// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Going on with runs that have not come to their end. Here they stop when their results are to be written: a
// folder stands where history.csv should. tests/mpi/killed_runs.cc kills them.

#include <gtest/gtest.h>

#include "program.h"
#include "result_folders.h"
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sys/file.h>
#include <unistd.h>

using namespace abut::testing;
namespace fs = std::filesystem;

namespace
{
  const std::string resumed_scene = project_file("prm/two-layers-tolerance.prm");
  const std::vector<std::string> saved = {"--quiet", "--set", "Output/Checkpoint=every pass", "--set",
                                          "Tolerance=0.003"};

  std::string new_folder()
  {
    return fs::path(temporary_file("marker", "")).parent_path() / "results";
  }

  /// The folder of a run that has left nothing but its checkpoint.
  std::string interrupted(const std::string &file, const std::vector<std::string> &options = saved)
  {
    const std::string folder = new_folder();
    const fs::path obstacle = fs::path(folder) / "history.csv";
    fs::create_directories(obstacle / "inside");
    const Answer answer = run_in(folder, with({file}, options));
    EXPECT_EQ(answer.status, 1) << answer.err;
    EXPECT_NE(answer.err.find("history.csv could not be written"), std::string::npos) << answer.err;
    fs::remove_all(obstacle);
    EXPECT_TRUE(fs::exists(fs::path(folder) / "checkpoint"));
    return folder;
  }

  /// One sentence, and every file as it was.
  void expect_refused_and_kept(const std::string &folder, const std::vector<std::string> &phrases)
  {
    const auto before = files_in(folder);
    const Answer answer = resume(folder);
    EXPECT_EQ(answer.status, 1);
    EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << answer.err;
    for (const std::string &phrase : phrases)
      EXPECT_NE(answer.err.find(phrase), std::string::npos) << phrase << " is missing in: " << answer.err;
    EXPECT_TRUE(files_in(folder) == before);
  }

  TEST(Resume, EndsWithTheResultsOfTheWholeRun)
  {
    const Answer whole = run(with({resumed_scene}, saved));
    ASSERT_EQ(whole.status, 0) << whole.err;
    const std::string folder = interrupted(resumed_scene);
    const Answer rest = resume(folder);
    EXPECT_EQ(rest.status, 0) << rest.err;
    EXPECT_NE(rest.out.find("Going on with " + resumed_scene + " after pass"), std::string::npos) << rest.out;
    expect_same_results(folder, whole.directory);
  }

  TEST(Resume, CountsTheSecondsOfBefore)
  {
    const std::string folder = interrupted(resumed_scene);
    const Answer rest = resume(folder, {"--quiet"});
    ASSERT_EQ(rest.status, 0) << rest.err;
    EXPECT_EQ(rest.out, "");
    const std::vector<double> seconds = column(folder + "/history.csv", "wall_time_s");
    for (std::size_t i = 1; i < seconds.size(); ++i)
      EXPECT_GT(seconds[i], seconds[i - 1]);
    EXPECT_GT(rest.summary["time_s"]["total"].get<double>(), seconds.back());
  }

  TEST(Resume, FindsItsRunInAFolderThatWasMoved)
  {
    const std::string folder = interrupted(resumed_scene), moved = new_folder();
    fs::rename(folder, moved);
    const fs::path before = fs::current_path();
    fs::current_path(fs::path(moved).parent_path());
    const Answer rest = resume("results", {"--quiet"});
    fs::current_path(before);
    EXPECT_EQ(rest.status, 0) << rest.err;
    EXPECT_TRUE(fs::exists(fs::path(moved) / "summary.json"));
    EXPECT_FALSE(fs::exists(folder));
  }

  TEST(Resume, OfARunWithNothingSavedIsRefused)
  {
    const std::string folder = new_folder();
    const Answer none = resume(folder);
    EXPECT_EQ(none.status, 1);
    EXPECT_NE(none.err.find("allowed is the folder of a run"), std::string::npos) << none.err;
    EXPECT_FALSE(fs::exists(folder));
    fs::create_directories(folder);
    expect_refused_and_kept(folder, {"there is no checkpoint in `" + folder + "`"});
  }

  TEST(Resume, OfARunThatHasEndedIsRefused)
  {
    const Answer whole = run(with({resumed_scene}, saved));
    ASSERT_EQ(whole.status, 0) << whole.err;
    EXPECT_FALSE(fs::exists(whole.directory + "/checkpoint"));
    expect_refused_and_kept(whole.directory, {"has ended"});
  }

  TEST(Resume, OfAStudyIsRefused)
  {
    const Answer study = run({"study", project_file("prm/two-layers-tolerance.prm"), "--quiet", "--set",
                              "Study/Variants=10: Tolerance=0.1"});
    ASSERT_EQ(study.status, 0) << study.err;
    expect_refused_and_kept(study.directory, {"the folder of a study"});
  }

  TEST(Resume, OfADamagedCheckpointIsRefused)
  {
    const std::string folder = interrupted(resumed_scene), path = folder + "/checkpoint",
                      content = read_file(path);
    for (const double share : {0., .001, .3, .7, 1.})
    {
      const auto place = static_cast<std::size_t>(share * static_cast<double>(content.size() - 1));
      std::ofstream(path, std::ios::binary) << content.substr(0, place);
      expect_refused_and_kept(folder, {path});
      std::string flipped = content;
      flipped[place] = static_cast<char>(flipped[place] ^ 1);
      std::ofstream(path, std::ios::binary) << flipped;
      expect_refused_and_kept(folder, {path});
    }
    std::ofstream(path, std::ios::binary) << content;
    EXPECT_EQ(resume(folder).status, 0);
  }

  TEST(Resume, OfARunThatStillGoesOnIsRefused)
  {
    const std::string folder = interrupted(resumed_scene);
    const int taken = open(folder.c_str(), O_RDONLY | O_DIRECTORY);
    ASSERT_EQ(flock(taken, LOCK_EX), 0);
    expect_refused_and_kept(folder, {"another run writes its results to `" + folder + "`"});
    close(taken);
    EXPECT_EQ(resume(folder).status, 0);
  }

  TEST(Resume, TakesNothingElse)
  {
    const std::string folder = interrupted(resumed_scene);
    const auto before = files_in(folder);
    const std::vector<std::vector<std::string>> others = {
        {resumed_scene}, {"--set", "Tolerance=0.1"}, {"--output", new_folder()}, {"--check"}, {"study"},
        {"schemes"}};
    for (const std::vector<std::string> &other : others)
    {
      const Answer answer = resume(folder, other);
      EXPECT_EQ(answer.status, 1) << other.front();
      EXPECT_NE(answer.err.find("--resume"), std::string::npos) << answer.err;
      EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << answer.err;
    }
    EXPECT_TRUE(files_in(folder) == before);
  }

  // A new run in the folder is another one.
  TEST(Resume, IsNotForARunThatWasBegunAnew)
  {
    const std::string folder = interrupted(resumed_scene);
    const Answer again = run_in(folder, {resumed_scene, "--quiet", "--set", "Output/Checkpoint=never"});
    EXPECT_EQ(again.status, 0) << again.err;
    EXPECT_FALSE(fs::exists(folder + "/checkpoint"));
  }

  TEST(Resume, RemovesWhatAKilledRunWasWriting)
  {
    const std::string folder = interrupted(resumed_scene);
    std::ofstream(folder + "/checkpoint.partial-1234") << "half";
    std::ofstream(folder + "/mine.partial-x") << "not ours";
    EXPECT_EQ(resume(folder).status, 0);
    EXPECT_FALSE(fs::exists(folder + "/checkpoint.partial-1234"));
    EXPECT_TRUE(fs::exists(folder + "/mine.partial-x"));
  }

  TEST(Resume, KeepsItsWarnings)
  {
    // Without a modulus of its own, which only the lines of the file tell.
    const std::string text = read_file(resumed_scene);
    const std::string line = "set Young modulus = 2.1e5\n";
    std::string first = text;
    first.erase(first.find(line), line.size());
    const std::string file = temporary_file("scene.prm", first);
    const Answer whole = run(with({file}, saved));
    const std::string folder = interrupted(file);
    fs::remove(file);
    const Answer rest = resume(folder);
    EXPECT_EQ(rest.status, whole.status);
    EXPECT_EQ(warning_codes(rest).count("default-material"), 1u);
    EXPECT_EQ(warning_codes(rest), warning_codes(whole));
  }

  // A folder stands where the file should.
  TEST(Resume, IsToldWhereNothingCouldBeSaved)
  {
    const std::string folder = new_folder();
    fs::create_directories(folder + "/checkpoint/inside");
    const Answer told = run_in(folder, with({resumed_scene}, saved)),
                 silent = run(with({resumed_scene}, saved));
    EXPECT_EQ(told.status, 0);
    EXPECT_EQ(warning_codes(told).count("checkpoint-not-saved"), 1u) << told.err;
    EXPECT_EQ(warning_codes(silent).count("checkpoint-not-saved"), 0u) << silent.err;
  }
} // namespace
