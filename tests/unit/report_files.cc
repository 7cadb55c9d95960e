// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/report/atomic_file.h>
#include <abut/report/contact_csv.h>
#include <abut/report/history.h>
#include <abut/report/write_all.h>

#include <nlohmann/json.hpp>

#include "report_testing.h"
#include "scene_testing.h"
#include <algorithm>
#include <filesystem>

namespace
{
  using namespace abut;
  namespace fs = std::filesystem;

  class ReportFolder : public ::testing::Test
  {
  protected:
    SceneFile scene_{""};
    fs::path folder_ = scene_.directory();

    std::size_t n_files() const
    {
      return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), {}));
    }
  };

  TEST_F(ReportFolder, FileIsReplacedAndNothingElseIsLeft)
  {
    const fs::path path = folder_ / "a.txt";
    write_file(path, "old");
    write_file_to_disk(path, "newer");
    EXPECT_EQ(content_of(path), "newer");
    write_file(path, "new\n");
    EXPECT_EQ(content_of(path), "new\n");
    EXPECT_EQ(n_files(), 2u); // with the scene
  }

  TEST_F(ReportFolder, FailedRenameLeavesWhatWasThereAndNamesThePath)
  {
    const fs::path path = folder_ / "taken";
    fs::create_directory(path);
    std::ofstream(path / "inside") << "old";
    expect_phrase(message_of([&] { write_file(path, "new"); }), path.string());
    EXPECT_EQ(content_of(path / "inside"), "old");
    EXPECT_EQ(n_files(), 2u);
  }

  TEST_F(ReportFolder, FullDiskLeavesTheOldFile)
  {
    // The temporary file is a link to a device that is always full.
    const fs::path path = folder_ / "a.txt";
    write_file(path, "old");
    fs::create_symlink("/dev/full", path.string() + ".partial-" + std::to_string(getpid()));
    expect_phrase(message_of([&] { write_file(path, "new"); }), "No space left");
    EXPECT_EQ(content_of(path), "old");
    EXPECT_EQ(n_files(), 2u);
  }

  TEST_F(ReportFolder, MissingFolderIsReported)
  {
    expect_phrase(message_of([&] { write_file(folder_ / "none" / "a", ""); }), "No such file");
  }

  TEST_F(ReportFolder, OutputDirectoryIsMadeWithItsParents)
  {
    const std::string path = folder_ / "a" / "b";
    {
      const OutputDirectory first(path);
    }
    const OutputDirectory second(path);
    EXPECT_TRUE(fs::is_empty(path));
  }

  TEST_F(ReportFolder, OutputDirectoryIsForOneRunAtATime)
  {
    const OutputDirectory first(folder_ / "a");
    expect_phrase(message_of([&] { OutputDirectory{folder_ / "a"}; }), "another run writes its results to");
    const OutputDirectory other(folder_ / "b");
  }

  TEST_F(ReportFolder, OutputDirectoryIsRidOfWhatAKilledRunWasWriting)
  {
    write_file(folder_ / "a.vtu.partial-12", "half");
    write_file(folder_ / "a.vtu.partial-", "another's");
    write_file(folder_ / "a.vtu.partial-1x", "another's");
    const OutputDirectory directory(folder_);
    EXPECT_EQ(n_files(), 3u); // with the scene
    EXPECT_FALSE(fs::exists(folder_ / "a.vtu.partial-12"));
  }

  TEST_F(ReportFolder, OutputDirectoryMustBeAWritableFolder)
  {
    const std::string taken = folder_ / "file";
    write_file(taken, "old");
    expect_phrase(message_of([&] { OutputDirectory{taken}; }), "`" + taken + "`, which is a file");
    expect_phrase(message_of([&] { OutputDirectory{taken + "/below"}; }), "could not be made");
    expect_phrase(message_of([&] { OutputDirectory{"/proc/self"}; }), "nothing can be written");
    EXPECT_EQ(content_of(taken), "old");
  }

  TEST(ReportNumbers, ReadBackExactlyOrEmpty)
  {
    EXPECT_EQ(std::stod(exact_number(1. / 3.)), 1. / 3.);
    EXPECT_EQ(exact_number(std::numeric_limits<double>::infinity()), "");
    EXPECT_EQ(exact_number(std::nan("")), "");
    EXPECT_EQ(short_number(1234.5678, 6), "1234.57");
    EXPECT_EQ(short_number(std::nan("")), "-");
    EXPECT_EQ(aligned({{"a", "long"}, {"name", "1"}}), "  a     long\n  name     1\n");
  }

  TEST(ReportHistory, HasTheHeaderAndARowForEveryStep)
  {
    History history;
    history.begin_pass(0, {8, 100, 20});
    StepRecord record;
    record.step = 1;
    record.increment = .5;
    record.normal_force = 3.;
    record.max_pressure = 2.;
    history.add(record, .25);
    record.step = 2;
    record.bound = .125;
    history.add(record, .75);
    const auto lines = lines_of(history.csv());
    ASSERT_EQ(lines.size(), 3u);
    EXPECT_EQ(lines[0],
              "pass,step,dofs,boundary_dofs,cells,eta_max,increment,error_discretisation,error_penalty,"
              "error_iteration,error_total,true_error_energy,true_error_stress,effectivity,"
              "effectivity_total,normal_force,max_pressure,wall_time_s,true_error_pressure,true_error_force,"
              "error_stress,change,step_discretisation,step_bound,step_true_error,"
              "step_discretisation_ratio,step_bound_ratio,error_contact,error_linear_algebra,"
              "error_geometry,error_bound,error_estimate,error_pressure");
    EXPECT_EQ(lines[1], "0,1,100,20,8,,0.5,,,,,,,,,3,2,0.25,,,,,,,,,,,,,,,");
    EXPECT_EQ(lines[2], "0,2,100,20,8,,0.5,,,0.125,,,,,,3,2,0.75,,,,,,,,,,,,,,,");
  }

  TEST(ReportHistory, WhatAPassHasFoundStandsInItsLastRow)
  {
    History history;
    for (const unsigned int pass : {0u, 1u})
    {
      history.begin_pass(pass, {8, 100, 20});
      StepRecord step;
      for (step.step = 1; step.step <= 2; ++step.step)
        history.add(step, 1.);
      if (pass == 1)
        history.add(StepEstimate{.5, .75, .25, 2., 3.});
      PassRecord record;
      record.pass = pass;
      record.eta_max = .5 - .25 * pass;
      record.discretisation = .25;
      record.total = .375;
      record.true_errors = {.125, .0625, .03125, .75};
      record.quality.emplace();
      record.quality->whole = {4., 1., 0.};
      record.effectivity_total = 3.;
      record.stress = 7.;
      record.pressure = .015625;
      record.change = 9.;
      history.end_pass(record);
    }
    const auto lines = lines_of(history.csv());
    ASSERT_EQ(lines.size(), 5u);
    EXPECT_EQ(lines[1], "0,1,100,20,8,,0,,,,,,,,,0,0,1,,,,,,,,,,,,,,,");
    EXPECT_EQ(lines[2],
              "0,2,100,20,8,0.5,0,0.25,,,0.375,0.125,0.0625,2,3,0,0,1,0.03125,0.75,7,9,,,,,,,,,,,0.015625");
    EXPECT_EQ(lines[4], "1,2,100,20,8,0.25,0,0.25,,,0.375,0.125,0.0625,2,3,0,0,1,0.03125,0.75,7,9,0.5,0.75,0."
                        "25,2,3,,,,,,0.015625");
  }

  TEST_F(ReportedScene, ContactRowsFollowTheParts)
  {
    // The top of the lower square runs from (1, 1) to (0, 1).
    const auto lines = lines_of(contact_csv(results.pairs[0]));
    ASSERT_EQ(lines.size(), 3u);
    EXPECT_EQ(lines[0], "x,y,arc_length,gap,pressure,length,load,load_x,load_y");
    const std::vector<std::vector<double>> expected = {{1., 1., 0., -.125, 6., .5, 7., .75, 1.},
                                                       {0., 1., 1., .25, 1., .5, 0., .25, 1.}};
    for (std::size_t row = 0; row < expected.size(); ++row)
    {
      std::istringstream cells(lines[row + 1]);
      std::string cell;
      for (const double value : expected[row])
      {
        ASSERT_TRUE(std::getline(cells, cell, ','));
        EXPECT_NEAR(std::stod(cell), value, 1e-14);
      }
      EXPECT_FALSE(std::getline(cells, cell, ','));
    }
  }

  TEST_F(ReportedScene, AllFilesAreWrittenAndTheSummaryKnowsWhatIsMissing)
  {
    const fs::path folder = fs::path(file.directory()) / "out";
    fs::create_directories(folder);
    write_file(folder / "solution.svg", "stale");
    const Written written = write_all(results, History(), PassDrawings(), folder, 1.);
    std::vector<std::string> names;
    for (const auto &entry : fs::directory_iterator(folder))
      names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    EXPECT_EQ(names, (std::vector<std::string>{"contact_interface.csv", "history.csv", "parameters.prm",
                                               "report.html", "solution.pvd", "solution.pvtu", "solution.svg",
                                               "solution_lower.vtu", "solution_upper.vtu", "summary.json"}));
    EXPECT_EQ(content_of(folder / "parameters.prm"), scene.parameters);
    EXPECT_NE(content_of(folder / "solution.svg"), "stale");
    EXPECT_TRUE(written.left_out.empty());
    const auto json = nlohmann::json::parse(content_of(folder / "summary.json"));
    EXPECT_DOUBLE_EQ(json["time_s"]["output"], written.seconds);
    EXPECT_DOUBLE_EQ(json["time_s"]["total"], 1. + written.seconds);
  }

  TEST_F(ReportedScene, AFailedRunLeavesNoSummary)
  {
    for (const std::string blocked : {"solution_upper.vtu", "report.html"})
    {
      const fs::path folder = fs::path(file.directory()) / ("without " + blocked);
      fs::create_directories(folder);
      write_file(folder / "summary.json", "{}");
      fs::create_directories(folder / blocked / "in the way");
      EXPECT_THROW(write_all(results, History(), PassDrawings(), folder, 1.), UserError) << blocked;
      EXPECT_FALSE(fs::exists(folder / "summary.json")) << blocked;
    }
  }
} // namespace
