// SPDX-License-Identifier: LGPL-2.1-or-later
//
// study.html: its data, its figures without scripts, names that are not meant well, points of other programs.
#include <gtest/gtest.h>

#include "program.h"
#include "study_files.h"
#include <cmath>

using namespace abut::testing;

namespace
{
  const std::string page_data_begin = "<script type=\"application/json\" id=\"study-data\">";

  nlohmann::json data_of(const std::string &page)
  {
    const auto begin = page.find(page_data_begin) + page_data_begin.size();
    return nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin));
  }

  Answer run_corner_study(const std::string &variants, const std::string &peers = "")
  {
    std::vector<std::string> arguments = {"study", project_file("prm/corner.prm"),
                                          "--set", "Study/Crossed with=",
                                          "--set", "Study/Common=Adaptation/Maximum passes=3",
                                          "--set", "Study/Variants=" + variants};
    if (!peers.empty())
      arguments.insert(arguments.end(), {"--set", "Study/Peers=" + temporary_file("peers.csv", peers)});
    return run(arguments);
  }

  TEST(StudyPage, HasTheDataOfTheCsvFile)
  {
    const Answer answer = run_corner_study("one: Adaptation/Estimator=spr; two: Adaptation/Estimator=zz");
    ASSERT_EQ(answer.status, 0) << answer.err;
    const CsvFile file(answer.directory + "/study.csv");
    const nlohmann::json data = data_of(read_file(answer.directory + "/study.html"));
    EXPECT_EQ(data["columns"], nlohmann::json(file.columns()));
    ASSERT_EQ(data["rows"].size(), file.n_rows());
    ASSERT_EQ(file.n_rows(), 6u);
    for (std::size_t row = 0; row < file.n_rows(); ++row)
      for (std::size_t i = 0; i < file.columns().size(); ++i)
      {
        const nlohmann::json &cell = data["rows"][row][i];
        const std::string &text = file.text(row, file.columns()[i]);
        if (cell.is_null())
          EXPECT_EQ(text, "");
        else if (cell.is_string())
          EXPECT_EQ(text, cell);
        else
          EXPECT_EQ(std::stod(text), cell.get<double>()) << file.columns()[i];
      }
    // and its lines are made of it
    const nlohmann::json &line = data["lines"][1];
    EXPECT_EQ(line["title"], "two");
    for (std::size_t pass = 0; pass < 3; ++pass)
    {
      EXPECT_EQ(line["points"][pass]["unknowns"], file.number(3 + pass, "dofs"));
      EXPECT_EQ(line["points"][pass]["seconds"], file.number(3 + pass, "wall_time_s"));
      EXPECT_EQ(line["points"][pass]["stress"], file.number(3 + pass, "true_error_stress"));
    }
  }

  TEST(StudyPage, NeedsNoScriptsAndNoOtherFile)
  {
    const Answer answer = run_corner_study("one: Adaptation/Estimator=spr");
    const std::string page = read_file(answer.directory + "/study.html");
    const nlohmann::json data = data_of(page);
    EXPECT_EQ(occurrences(page, "<figure class=\"static\""), data["errors"].size());
    EXPECT_EQ(occurrences(page, "<svg xmlns"), 2 * data["errors"].size());
    EXPECT_NE(page.find("data-error=\"stress\""), std::string::npos);
    EXPECT_EQ(occurrences(page, "<circle r="),
              2 * (3 + 2) * data["errors"].size());              // three passes, two in the legend
    EXPECT_EQ(occurrences(page, "<tr>"), (1u + 1u) + (1u + 3u)); // of the variant, of its passes
    EXPECT_EQ(occurrences(page, "<script src"), 0u);
    EXPECT_EQ(occurrences(page, "<link"), 0u);
    EXPECT_EQ(occurrences(page, "<?xml"), 0u);
    EXPECT_NE(page.find("Copyright (c) 2022 Leon Sorokin"), std::string::npos); // of uPlot, with its licence
  }

  TEST(StudyPage, ShowsQuantitiesAgainstWhatIsSwept)
  {
    const std::string steel = "Body lower/Young modulus";
    const Answer answer = run({"study", project_file("prm/two-layers-rollers.prm"), "--set",
                               "Study/Common=Body upper/Cells=16, 4 | Body lower/Cells=16, 4", "--set",
                               "Study/Variants=", "--set", "Reference/Exact solution=none", "--set",
                               "Study/Sweep=" + steel + " = 2e5 | 1e5"});
    ASSERT_EQ(answer.status, 0) << answer.err;
    const CsvFile file(answer.directory + "/study.csv");
    const std::string page = read_file(answer.directory + "/study.html");
    const nlohmann::json data = data_of(page);
    ASSERT_EQ(data["sweeps"].size(), 1u);
    EXPECT_EQ(data["sweeps"][0]["name"], steel);
    const nlohmann::json &points = data["sweeps"][0]["lines"][0]["points"];
    ASSERT_EQ(points.size(), 2u);
    for (std::size_t row = 0; row < 2; ++row)
    {
      const nlohmann::json &point = points[1 - row]; // from the smallest on
      EXPECT_EQ(point[steel], std::stod(file.text(row, steel)));
      for (const std::string column : {"contact_force", "max_pressure", "contact_length", "max_von_mises"})
        EXPECT_EQ(point[column], file.number(row, column)) << column;
    }
    EXPECT_EQ(occurrences(page, "data-quantity="), data["quantities"].size());
    // no errors: neither exact nor estimated
    EXPECT_EQ(page.find("<h2>Errors</h2>"), std::string::npos);
    // the swept value stands first in all tables, and nothing stands there twice
    EXPECT_EQ(occurrences(page, "<tr><th class=\"number\">" + steel), 1u);
    EXPECT_EQ(occurrences(page, "<tr><th class=\"text\">" + steel), 1u);
    for (const std::string twice : {">variant</th>", "interface</th>", "discretisation</th>"})
      EXPECT_EQ(page.find(twice), std::string::npos) << twice;
    EXPECT_NE(answer.out.find("  " + steel + "  contact force  peak pressure"), std::string::npos)
        << answer.out;
  }

  TEST(StudyPage, TellsTheOrderOfPointsOnAStraightLine)
  {
    const Answer answer = run_corner_study("one: Adaptation/Estimator=spr",
                                           "scene,program,variant,unknowns,seconds,error_stress\n"
                                           ",other,line,100,1,1e-1\n,other,line,10000,8,1e-2\n");
    ASSERT_EQ(answer.status, 0) << answer.err;
    const nlohmann::json data = data_of(read_file(answer.directory + "/study.html"));
    const nlohmann::json &order = data["lines"][1]["order"]["stress"];
    EXPECT_NEAR(order["unknowns"].get<double>(), .5, 1e-12);
    EXPECT_NEAR(order["seconds"].get<double>(), std::log(10.) / std::log(8.), 1e-12);
    EXPECT_TRUE(data["lines"][1]["order"]["energy"]["unknowns"].is_null());
  }

  TEST(StudyPage, EscapesHostileNames)
  {
    const std::string name = "</script><b>\"x\" & 'y', -->";
    const Answer answer =
        run_corner_study(name + ": Adaptation/Estimator=spr", "scene,program,variant,unknowns,error_stress\n"
                                                              "corner,\"<i>\"\"p\"\"</i>\",\"a,b\",10,0.1\n");
    ASSERT_EQ(answer.status, 0) << answer.err;
    const CsvFile file(answer.directory + "/study.csv");
    EXPECT_EQ(file.text(0, "variant"), name);
    const std::string page = read_file(answer.directory + "/study.html");
    EXPECT_EQ(page.find("</script><b>"), std::string::npos);
    EXPECT_EQ(page.find("<i>"), std::string::npos);
    const nlohmann::json data = data_of(page);
    EXPECT_EQ(data["lines"][0]["name"], name);
    EXPECT_EQ(data["lines"][1]["program"], "<i>\"p\"</i>");
    EXPECT_EQ(data["lines"][1]["name"], "a,b");
    EXPECT_NE(page.find("&lt;/script&gt;&lt;b&gt;&quot;x&quot; &amp; 'y'"), std::string::npos);
  }

  TEST(StudyPage, ShowsPointsOfOtherProgramsForItsSceneOnly)
  {
    const std::string head = "scene,program,variant,unknowns,seconds,seconds_without_start,cpu_seconds,"
                             "memory_mb,error_stress,error_pressure,error_force\n";
    const Answer answer =
        run_corner_study("one: Adaptation/Estimator=spr",
                         head + "corner,A,k=1,100,2,1.5,3,50,0.1,,\nother,B,k=1,1,1,1,1,1,1,1,1\n"
                                "corner,A,k=1,400,8,,9,60,0.05,,\n");
    ASSERT_EQ(answer.status, 0) << answer.err;
    const nlohmann::json data = data_of(read_file(answer.directory + "/study.html"));
    ASSERT_EQ(data["lines"].size(), 2u);
    EXPECT_EQ(data["lines"][1]["title"], "A: k=1");
    const nlohmann::json wanted = {
        {{"unknowns", 100.}, {"seconds", 1.5}, {"cpu_seconds", 3.}, {"memory_mb", 50.}, {"stress", .1}},
        {{"unknowns", 400.}, {"seconds", 8.}, {"cpu_seconds", 9.}, {"memory_mb", 60.}, {"stress", .05}}};
    EXPECT_EQ(data["lines"][1]["points"], wanted);
    EXPECT_EQ(data["rows"].size(), 3u); // they are no rows of the table

    const std::string spr = "one: Adaptation/Estimator=spr";
    expect_refused(run_corner_study(spr, head + "other,B,k=1,1,1,1,1,1,1,1,1\n"),
                   {"Study/Peers", "no row of the scene corner", "only of other"});
    expect_refused(run_corner_study(spr, head + "corner,B,k=1,many,1,1,1,1,1,1,1\n"),
                   {"line 2", "`many`", "unknowns"});
    expect_refused(run_corner_study(spr, head + "corner,B\n"), {"line 2", "2 cells", "11"});
    expect_refused(run_corner_study(spr, "program,variant\nA,b\n"), {"no column `scene`"});
  }
} // namespace
