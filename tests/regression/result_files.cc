// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The reference of the result files: summary.json follows its schema, CSV files have the columns of the page.

#include <abut/report/reference/csv_files.h>
#include <abut/report/reference/summary_keys.h>

#include <gtest/gtest.h>

#include "program.h"
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace
{
  using abut::testing::Answer;
  using abut::testing::project_file;
  using abut::testing::read_file;
  using abut::testing::run;
  using abut::testing::run_case;
  using abut::testing::run_scene;
  using abut::testing::run_text;
  using nlohmann::json;

  const std::string schema_file = "doc/reference/summary.schema.json";

  /// What Debian's validator complains of in a JSON file; empty for a valid one.
  std::string complaints(const std::string &file, const std::string &schema)
  {
    const std::string log = file + ".log";
    const std::string command =
        std::string(ABUT_JSONSCHEMA) + " -i '" + file + "' '" + schema + "' > '" + log + "' 2>&1";
    const int status = std::system(command.c_str());
    const std::string text = read_file(log);
    return status == 0 || !text.empty() ? text : "the validator ended with " + std::to_string(status);
  }

  /// The summaries of several runs in one file, which the validator is started for once, after its own kind
  /// of schema.
  std::string complaints(const std::map<std::string, json> &summaries)
  {
    const json schema = json::parse(read_file(project_file(schema_file)));
    json properties = json::object();
    for (const auto &[name, summary] : summaries)
      properties[name] = schema;
    return complaints(abut::testing::temporary_file("summaries.json", json(summaries).dump()),
                      abut::testing::temporary_file(
                          "schema.json", json({{"type", "object"}, {"properties", properties}}).dump()));
  }

  /// Follows a path of SummaryKey and tells whether something stands there that is not null, in some entry of
  /// lists.
  bool has_content(const json &value, const std::string &path)
  {
    if (path.empty())
      return !value.is_null();
    const auto dot = path.find('.');
    std::string name = path.substr(0, dot);
    const std::string rest = dot == std::string::npos ? "" : path.substr(dot + 1);
    const bool is_list = name.size() > 2 && name.compare(name.size() - 2, 2, "[]") == 0;
    if (is_list)
      name.erase(name.size() - 2);
    if (!value.is_object() || (name[0] != '<' && !value.contains(name)))
      return false;
    const json &inside = name[0] == '<' ? value : value[name];
    if (!is_list && name[0] != '<')
      return has_content(inside, rest);
    for (const json &entry : inside)
      if (has_content(entry, rest))
        return true;
    return false;
  }

  const std::string one_bar = "set Bodies = bar\n"
                              "subsection Body bar\n"
                              "  set Conditions = left: displacement: 0, 0; right: traction: 1, 0\nend\n"
                              "subsection Output\n  set Condition numbers = true\nend\n";

  const std::vector<std::string> coarse_layers = {"Body upper/Cells=8, 2", "Body lower/Cells=8, 2"};
  const std::vector<std::string> adaptive_layers = {"Body upper/Cells=8, 2", "Body lower/Cells=8, 2",
                                                    "Body upper/Adapt=true", "Body lower/Adapt=true",
                                                    "Adaptation/Maximum passes=3"};
} // namespace

// Runs of all kinds: whatever a run can tell is told by one of them, and all of it follows the schema.
TEST(ResultFiles, SummariesFollowTheSchema)
{
  using abut::testing::with;
  const std::map<std::string, Answer> answers = {
      {"exact contact", run_scene("patch-test", {"Output/Points=(0.5, 0.5)"})},
      {"penalty, increment",
       run_scene("two-layers", with(coarse_layers, {"Contact interface/Penalty coefficient=0.05"}))},
      {"estimator, exact solution",
       run_scene("two-layers-rollers", with(adaptive_layers, {"Adaptation/Estimator=fe-be"}))},
      {"goal", run_scene("two-layers-tolerance", {"Tolerance=0.05", "Goal=force"})},
      {"tolerance", run_scene("two-layers-tolerance", {"Tolerance=0.1"})},
      {"bonded", run_scene("two-layers-rollers-bonded", coarse_layers)},
      {"glued", run_scene("coated-block", {"Adaptation/Maximum passes=2"})},
      {"several bodies", run_scene("three-bodies")},
      {"floating", run_scene("v-groove")},
      {"resultant", run_scene("hertz")},
      {"mesh file", run_case("press-fit")},
      {"no contact", run_text(one_bar)},
      {"not converged", run_scene("two-layers", with(coarse_layers, {"Decomposition/Maximum steps=2"}))}};
  std::map<std::string, json> summaries;
  for (const auto &[name, answer] : answers)
  {
    EXPECT_EQ(answer.status, name == "not converged" ? 2 : 0) << name << ": " << answer.err;
    ASSERT_FALSE(answer.summary.is_null()) << name << ": " << answer.err;
    summaries[name] = answer.summary;
  }
  EXPECT_EQ(complaints(summaries), "");
  for (const abut::SummaryKey &key : abut::summary_keys())
    EXPECT_TRUE(std::any_of(summaries.begin(), summaries.end(),
                            [&](const auto &summary) { return has_content(summary.second, key.path); }))
        << key.path << " is null in all of these runs";
}

TEST(ResultFiles, EveryNumberHasAUnitAndEveryKeyAMeaning)
{
  for (const abut::SummaryKey &key : abut::summary_keys())
  {
    const bool is_quantity = key.type.compare(0, 6, "number") == 0 || key.type.compare(0, 6, "vector") == 0;
    EXPECT_NE(key.unit.empty(), is_quantity) << key.path;
    EXPECT_FALSE(key.meaning.empty()) << key.path;
  }
  for (const auto &files : {abut::csv_files_of_runs(), abut::csv_files_of_studies()})
    for (const abut::CsvDescription &file : files)
      for (const abut::CsvColumn &column : file.columns)
        EXPECT_FALSE(column.meaning.empty()) << file.name << ": " << column.name;
}

// The validator sees a key too many, one too few and a word that is none.
TEST(ResultFiles, TheSchemaRefusesWhatItDoesNotDescribe)
{
  const Answer answer = run_scene("patch-test");
  ASSERT_EQ(complaints({{"sound", answer.summary}}), "");
  json added = answer.summary, missing = answer.summary, other = answer.summary, inner = answer.summary;
  added["error"]["friction"] = 0.;
  missing["contacts"][0].erase("force");
  other["status"] = "finished";
  inner["bodies"][0]["reactions"]["left"] = {1., 2., 3.};
  EXPECT_NE(complaints({{"added", added}}).find("friction"), std::string::npos);
  EXPECT_NE(complaints({{"missing", missing}}).find("force"), std::string::npos);
  EXPECT_NE(complaints({{"other", other}}).find("finished"), std::string::npos);
  EXPECT_NE(complaints({{"inner", inner}}), "");
}

namespace
{
  using Columns = std::vector<std::string>;

  /// The columns of every CSV file, by the page, and the fields of `VTU files`.
  std::map<std::string, Columns> described_files()
  {
    std::map<std::string, Columns> files;
    std::istringstream page(read_file(project_file("doc/reference/results.md")));
    const std::regex heading("##.* `?(.*\\.csv|VTU files)`?"), row("\\| `(.*?)` \\|.*");
    std::string file;
    for (std::string line; std::getline(page, line);)
      if (std::smatch found; std::regex_match(line, found, heading))
        file = found[1];
      else if (!file.empty() && std::regex_match(line, found, row))
        files[file].push_back(found[1]);
    return files;
  }

  /// Matches what a name with `<pair>` and the like stands for.
  std::regex pattern_of(const std::string &name)
  {
    if (name == "<Section/Name>")
      return std::regex("[A-Z][^/]*/.+");
    return std::regex(std::regex_replace(name, std::regex("<.*?>"), ".+"));
  }

  std::string first_line(const std::string &path)
  {
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    return line;
  }

  Columns header_of(const std::string &path)
  {
    std::istringstream line(first_line(path));
    Columns columns;
    for (std::string name; std::getline(line, name, ',');)
      columns.push_back(name);
    return columns;
  }

  /// Every column has its description; every description has a column.
  void expect_columns(const Columns &written, const Columns &described, const std::string &file)
  {
    std::vector<bool> is_written(described.size());
    for (const std::string &name : written)
    {
      const auto exact = std::find(described.begin(), described.end(), name);
      const auto found =
          exact != described.end()
              ? exact
              : std::find_if(described.begin(), described.end(), [&](const std::string &other) {
                  return other.find('<') != std::string::npos && std::regex_match(name, pattern_of(other));
                });
      ASSERT_NE(found, described.end()) << file << ": the page does not describe the column " << name;
      is_written[static_cast<std::size_t>(found - described.begin())] = true;
    }
    for (std::size_t i = 0; i < described.size(); ++i)
      EXPECT_TRUE(is_written[i]) << file << ": no column " << described[i];
  }
} // namespace

TEST(ResultFiles, CsvFilesHaveTheColumnsOfThePage)
{
  const std::vector<std::string> on_two_meshes = {"--set", "Body upper/Cells=4, 1", "--set",
                                                  "Body lower/Cells=4, 1"};
  const auto answer_of = [](std::vector<std::string> arguments, const std::vector<std::string> &more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  };
  const std::string rollers = project_file("prm/two-layers-rollers.prm"),
                    paper = project_file("prm/two-layers-paper.prm"),
                    errors = project_file("prm/two-layers-paper-errors.prm");
  const std::vector<Answer> answers = {
      answer_of({rollers, "--set", "Output/Points=(1, 0.5)"}, on_two_meshes),
      answer_of({"schemes", rollers}, on_two_meshes),
      answer_of({"study", rollers, "--set", "Study/Variants=", "--set", "Study/Common=", "--set",
                 "Study/Crossed with=", "--set", "Study/Load cases=one: Constants/Values = 1e-3, 1e-3",
                 "--set", "Study/Sweep=Discretisation/Degree = 1 | 2", "--set", "Output/Points=(1, 0.5)"},
                on_two_meshes),
      run({"reproduce", paper, "--set", "Adaptation/Limit=0.5", "--set",
           "Study/Variants=0.4: Adaptation/Limit=0.4"}),
      run({"reproduce", errors, "--set", "Study/Variants=", "--set", "Adaptation/Maximum passes=1"})};
  std::map<std::string, Columns> described = described_files();
  described.erase("VTU files");
  std::set<std::string> seen;
  for (const Answer &answer : answers)
  {
    ASSERT_EQ(answer.status, 0) << answer.err;
    for (const auto &entry : std::filesystem::directory_iterator(answer.directory))
    {
      const std::string file = entry.path().filename().string();
      if (entry.path().extension() != ".csv")
        continue;
      const auto found = std::find_if(described.begin(), described.end(), [&](const auto &description) {
        return std::regex_match(file, pattern_of(description.first));
      });
      ASSERT_NE(found, described.end()) << "the page does not describe " << file;
      seen.insert(found->first);
      expect_columns(header_of(entry.path().string()), found->second, file);
    }
  }
  for (const auto &[file, columns] : described)
    EXPECT_EQ(seen.count(file), 1u) << file << " is described, but not written";
}

TEST(ResultFiles, VtuFilesHaveTheFieldsOfThePage)
{
  const Answer answer =
      run_scene("two-layers-rollers", abut::testing::with(adaptive_layers, {"Adaptation/Estimator=fe-be"}));
  ASSERT_EQ(answer.status, 0) << answer.err;
  const std::string text = read_file(answer.directory + "/solution_lower.vtu");
  const std::string fields = text.substr(text.find("<PointData"));
  const std::regex name(" Name=\"([^\"]*)\"");
  Columns written;
  for (std::sregex_iterator found(fields.begin(), fields.end(), name), end; found != end; ++found)
    written.push_back((*found)[1]);
  expect_columns(written, described_files()["VTU files"], "solution_lower.vtu");
}

// A scheme that tells no increment, and a first guess that has no bound.
TEST(ResultFiles, WhatASchemeDoesNotTellIsNull)
{
  const Answer conjugate =
      run_scene("two-layers-rollers", abut::testing::with(coarse_layers, {"Decomposition/Scheme=conjugate"}));
  ASSERT_EQ(conjugate.status, 0) << conjugate.err;
  EXPECT_TRUE(conjugate.summary["iteration"]["increment"].is_null());
  EXPECT_TRUE(conjugate.summary["pass_table"][0]["increment"].is_null());
  const Answer neumann = run_scene("two-layers", coarse_layers);
  ASSERT_EQ(neumann.status, 0) << neumann.err;
  EXPECT_GT(neumann.summary["iteration"]["increment"].get<double>(), 0.);
  EXPECT_TRUE(neumann.summary["error"]["iteration"].is_null());
  EXPECT_FALSE(neumann.summary["iteration"]["error_is_bound"].get<bool>());
}
