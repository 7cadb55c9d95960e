// SPDX-License-Identifier: LGPL-2.1-or-later
//
// `abut study`: sweeps, columns, the fine run that stands in for an exact solution, the page.
#include <gtest/gtest.h>

#include "program.h"
#include "study_files.h"
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>

using namespace abut::testing;

namespace
{
  const std::string layers_file = "prm/two-layers-rollers.prm";

  std::vector<std::string> set_options(const std::vector<std::string> &overrides)
  {
    std::vector<std::string> options;
    for (const std::string &override : overrides)
      options.insert(options.end(), {"--set", override});
    return options;
  }

  Answer run_layers_study(const std::vector<std::string> &overrides,
                          const std::vector<std::string> &more = {})
  {
    return run(with(with({"study", project_file(layers_file)}, set_options(overrides)), more));
  }

  TEST(Study, SweptValuesHaveColumnsAndQuantitiesAreThoseOfSingleRuns)
  {
    const std::string steel = "Body lower/Young modulus", gap = "Constants/Values";
    const Answer answer =
        run_layers_study({"Study/Common=Body upper/Cells=16, 4 | Body lower/Cells=16, 4",
                          "Study/Variants=", "Study/Load cases=near: Body upper/Shift=0, 1",
                          "Study/Sweep=" + steel + " = 1e5 | 2.1e5; " + gap + " = 1e-3, 1.366e-3"});
    ASSERT_EQ(answer.status, 0) << answer.err;
    const CsvFile file(answer.directory + "/study.csv");
    ASSERT_EQ(file.n_rows(), 2u);
    for (std::size_t row = 0; row < 2; ++row)
    {
      EXPECT_EQ(file.text(row, gap), "1e-3, 1.366e-3");
      EXPECT_EQ(file.text(row, "load_case"), "near");
      EXPECT_EQ(file.text(row, "reference"), "layers sliding");
      const std::vector<std::string> alone = {"Body upper/Cells=16, 4", "Body lower/Cells=16, 4",
                                              steel + "=" + file.text(row, steel)};
      const Answer single = run_scene("two-layers-rollers", alone);
      ASSERT_EQ(single.status, 0) << single.err;
      const auto &contact = single.summary["contacts"][0];
      EXPECT_EQ(file.number(row, "contact_force"), contact["normal_force"]);
      EXPECT_EQ(file.number(row, "contact_force_interface"), contact["normal_force"]);
      EXPECT_EQ(file.number(row, "max_pressure"), contact["max_pressure"]);
      EXPECT_EQ(file.number(row, "contact_length"), contact["contact_length"]);
      double von_mises = 0., energy = 0.;
      for (const auto &body : single.summary["bodies"])
      {
        von_mises = std::max(von_mises, body["max_von_mises"].get<double>());
        energy += body["energy"].get<double>();
      }
      EXPECT_EQ(file.number(row, "max_von_mises"), von_mises);
      EXPECT_EQ(file.number(row, "strain_energy"), energy);
      EXPECT_EQ(file.number(row, "true_error_stress"), single.summary["true_error"]["stress"]);
    }
    EXPECT_NE(file.number(0, "contact_force"), file.number(1, "contact_force"));
  }

  TEST(Study, TheBudgetIsThatOfThePass)
  {
    const Answer answer =
        run_layers_study({"Study/Variants=a: Adaptation/Estimator=spr | Adaptation/Maximum passes=2"});
    ASSERT_EQ(answer.status, 0) << answer.err;
    const CsvFile file(answer.directory + "/study.csv");
    ASSERT_EQ(file.n_rows(), 2u);
    for (std::size_t row = 0; row < 2; ++row)
    {
      EXPECT_EQ(file.number(row, "budget_discretisation"), file.number(row, "error_discretisation"));
      double squares = 0.;
      for (const std::string part :
           {"discretisation", "contact", "iteration", "penalty", "linear_algebra", "geometry"})
        if (const double error = file.number(row, "budget_" + part); std::isfinite(error))
          squares += error * error;
      EXPECT_NEAR(file.number(row, "budget_estimate"), std::sqrt(squares), 1e-14);
    }
  }

  TEST(Study, CheckLooksAtEveryVariantAndNamesTheBadOne)
  {
    const std::string good = "one: Body upper/Cells=8, 2; two: Body upper/Cells=16, 4";
    const Answer checked = run_layers_study({"Study/Common=", "Study/Variants=" + good}, {"--check"});
    EXPECT_EQ(checked.status, 0) << checked.err;
    EXPECT_NE(checked.out.find("Variant one: 2 bodies, 1 contacts"), std::string::npos) << checked.out;
    EXPECT_NE(checked.out.find("Variant two: 2 bodies"), std::string::npos) << checked.out;
    EXPECT_FALSE(std::filesystem::exists(checked.directory));

    // what reading finds, and what only bodies and pairs tell
    for (const std::string bad : {"Body upper/Poisson ratio=0.7", "Body lower/Size=5, 1"})
    {
      const std::vector<std::string> study = {"Study/Common=", "Study/Variants=" + good + "; wrong: " + bad};
      const Answer answer = run_layers_study(study, {"--check"});
      expect_refused(answer, {"variant `wrong`", "two-layers-rollers.prm"});
      EXPECT_NE(answer.out.find("Variant two"), std::string::npos);
      EXPECT_EQ(answer.out.find("Variant wrong"), std::string::npos);
    }
    const Answer unread = run_layers_study({"Study/Common=", "Study/Variants=" + good + "; wrong: Bodies=x"});
    expect_refused(unread, {"variant `wrong`"}); // and nothing has run before
    EXPECT_EQ(unread.out, "");
  }

  TEST(Study, AVariantWithoutResultsDoesNotTakeTheOthersAway)
  {
    const auto study = [](const std::string &variants) {
      return run_layers_study({"Study/Common=", "Body upper/Cells=8, 2", "Body lower/Cells=8, 2",
                               "Reference/Exact solution=none", "Study/Variants=" + variants});
    };
    const std::string huge = "huge: Body upper/Young modulus=1e307 | Body lower/Young modulus=1e307";
    const Answer answer = study(huge + "; steel:");
    EXPECT_EQ(answer.status, 2);
    EXPECT_NE(answer.err.find("the variant `huge` has no results: Body upper"), std::string::npos)
        << answer.err;
    const CsvFile file(answer.directory + "/study.csv");
    ASSERT_EQ(file.n_rows(), 1u);
    EXPECT_EQ(file.text(0, "variant"), "steel");

    const Answer none = study(huge);
    EXPECT_EQ(none.status, 2);
    EXPECT_NE(none.err.find("No results were written"), std::string::npos) << none.err;
    EXPECT_FALSE(std::filesystem::exists(none.directory + "/study.csv"));
  }

  // With rollers the fine run can be held against the exact solution itself.
  class FineRun : public ::testing::Test
  {
  protected:
    static std::vector<std::string> study(const std::string &reference,
                                          const std::vector<std::string> &changes = {})
    {
      std::vector<std::string> overrides = {
          "Study/Common=Body upper/Cells=16, 4 | Body lower/Cells=16, 4 | Body upper/Adapt=true | "
          "Body lower/Adapt=true | Adaptation/Maximum passes=3",
          "Study/Variants=spr: Adaptation/Estimator=spr; kelly: Adaptation/Estimator=kelly",
          "Body upper/Cells=32, 8",
          "Body lower/Cells=32, 8",
          "Study/Reference=fine run",
          "Study/Reference run=Discretisation/Degree=2 | Adaptation/Estimator=spr | "
          "Adaptation/Fraction=0.7 | Adaptation/Maximum passes=8",
          "Reference/Exact solution=" + reference};
      overrides.insert(overrides.end(), changes.begin(), changes.end());
      return overrides;
    }
  };

  TEST_F(FineRun, GivesTheErrorsThatTheExactSolutionGives)
  {
    const Answer exact = run_layers_study(study("layers sliding")), fine = run_layers_study(study("none"));
    ASSERT_EQ(exact.status, 0) << exact.err;
    ASSERT_EQ(fine.status, 0) << fine.err;
    const CsvFile wanted(exact.directory + "/study.csv"), found(fine.directory + "/study.csv");
    ASSERT_EQ(found.n_rows(), wanted.n_rows());
    for (std::size_t row = 0; row < found.n_rows(); ++row)
    {
      EXPECT_EQ(wanted.text(row, "reference"), "layers sliding");
      EXPECT_EQ(found.text(row, "reference"), "fine run");
      const double own = found.number(row, "reference_error"),
                   error = wanted.number(row, "true_error_energy");
      EXPECT_LE(own, .1 * error);
      // the triangle inequality, and both relative to norms that differ by as little
      EXPECT_NEAR(found.number(row, "true_error_energy"), error, 2. * own);
      EXPECT_NEAR(found.number(row, "true_error_stress"), wanted.number(row, "true_error_stress"), 4. * own);
      EXPECT_NEAR(found.number(row, "true_error_pressure"), wanted.number(row, "true_error_pressure"),
                  .1 * error);
      std::cout << "row " << row << ": energy " << error << ", against the fine run "
                << found.number(row, "true_error_energy") << ", whose own is " << own << '\n';
      EXPECT_TRUE(std::isfinite(found.number(row, "true_error_peak_pressure")));
      EXPECT_TRUE(std::isfinite(found.number(row, "true_error_strain_energy")));
    }
  }

  TEST_F(FineRun, IsKeptAndMadeAnewWhereTheSceneHasChanged)
  {
    const std::string folder = std::filesystem::path(temporary_file("x", "")).parent_path() / "results";
    const auto quick = [&](const std::vector<std::string> &changes) {
      const std::string reference = "Study/Reference run=Discretisation/Degree=2 | Adaptation/Estimator=spr "
                                    "| Adaptation/Maximum passes=4";
      const std::vector<std::string> overrides =
          study("none", {reference, "Study/Variants=spr: Adaptation/Estimator=spr"});
      return run_in(folder,
                    with({"study", project_file(layers_file)}, set_options(with(overrides, changes))));
    };
    const auto n_kept = [&] {
      std::size_t n = 0;
      for (const auto &entry : std::filesystem::directory_iterator(folder))
        n += entry.path().extension() == ".bin" ? 1 : 0;
      return n;
    };
    const Answer first = quick({});
    const std::string before = "Fine run, to compare with: ";
    ASSERT_NE(first.out.find("Fine run, now in "), std::string::npos) << first.out << first.err;
    EXPECT_LT(first.out.find(before), first.out.find("Fine run, now in ")) << first.out;
    EXPECT_NE(first.out.find("up to 4 passes"), std::string::npos) << first.out;
    EXPECT_EQ(n_kept(), 1u);
    const CsvFile made(folder + "/study.csv");
    // other meshes, marking and passes of the variants are no matter of the fine run
    const Answer second = quick({"Study/Variants=spr: Adaptation/Estimator=spr | Body upper/Cells=16, 4"});
    EXPECT_NE(second.out.find("Fine run, kept in "), std::string::npos) << second.out << second.err;
    EXPECT_EQ(second.out.find(before), std::string::npos) << second.out;
    EXPECT_EQ(n_kept(), 1u);
    const CsvFile kept(folder + "/study.csv");
    for (std::size_t row = 0; row < made.n_rows(); ++row)
      for (const std::string column : {"true_error_stress", "true_error_energy", "true_error_pressure",
                                       "true_error_force", "true_error_peak_pressure", "reference_error"})
        EXPECT_EQ(made.text(row, column), kept.text(row, column)) << column;
    for (const std::string change : {"Body upper/Young modulus=1e5", "Constants/Values=1e-3, 1.4e-3"})
      EXPECT_NE(quick({change}).out.find("Fine run, now in "), std::string::npos) << change;
    EXPECT_EQ(n_kept(), 3u);
    // a variant that changes the problem has a fine run of its own
    const Answer swept = quick({"Study/Sweep=Body upper/Young modulus = 2.1e5 | 3e5"});
    EXPECT_NE(swept.out.find("Fine run, kept in "), std::string::npos);
    EXPECT_NE(swept.out.find("Fine run, now in "), std::string::npos);
    EXPECT_EQ(n_kept(), 4u);
    // a damaged file is no fine run
    for (const auto &entry : std::filesystem::directory_iterator(folder))
      if (entry.path().extension() == ".bin")
        std::filesystem::resize_file(entry.path(), std::filesystem::file_size(entry.path()) / 2);
    EXPECT_NE(quick({}).out.find("Fine run, now in "), std::string::npos);
  }

  TEST_F(FineRun, IsRefusedWhereItIsNotMuchBetter)
  {
    const Answer answer = run_layers_study(
        study("none", {"Study/Reference run=Adaptation/Estimator=spr | Adaptation/Maximum passes=2"}));
    EXPECT_EQ(answer.status, 2);
    EXPECT_NE(answer.err.find("the fine run is no reference for pass"), std::string::npos) << answer.err;
    EXPECT_NE(answer.err.find("of the variant `spr`"), std::string::npos) << answer.err;
    const CsvFile file(answer.directory + "/study.csv");
    ASSERT_EQ(file.n_rows(), 6u);
    for (const std::string column :
         {"true_error_stress", "true_error_energy", "true_error_pressure", "true_error_force",
          "true_error_peak_pressure", "true_error_strain_energy"})
      EXPECT_EQ(file.text(2, column), "") << column;
    EXPECT_GT(file.number(2, "contact_force"), 0.);

    expect_refused(run_layers_study(study("none", {"Study/Reference run=Body upper/Adapt=false | "
                                                   "Body lower/Adapt=false"})),
                   {"variant `spr`", "Study/Reference run", "Adaptation/Estimator"});
  }
} // namespace
