// SPDX-License-Identifier: LGPL-2.1-or-later
//
// report.html, as runs of the program write it.

#include <gtest/gtest.h>

#include "../html_page.h"
#include "program.h"
#include <algorithm>
#include <filesystem>

namespace
{
  using namespace abut::testing;
  namespace fs = std::filesystem;

  constexpr std::size_t most_bytes = 3000000;

  std::string page_of(const Answer &answer)
  {
    return read_file(answer.directory + "/report.html");
  }

  /// Whether no attribute or style of the page leads out of it, but to the files beside it.
  void expect_self_contained(const std::string &page)
  {
    for (const std::string phrase : {"http", "//", "src=", "@import", "<link", "url(\"", "url('"})
      EXPECT_EQ(page.find(phrase), std::string::npos) << phrase;
    const HtmlNode tree = parsed_page(page);
    for (const HtmlNode *link : elements(tree, "a"))
      EXPECT_EQ(attribute(*link, "href").find_first_of(":/"), std::string::npos) << attribute(*link, "href");
  }

  using Numbers = std::vector<std::pair<std::string, std::string>>;

  /// The columns of a table's row have the very numbers of the summary's keys.
  void expect_numbers(const std::map<std::string, std::string> &row, const nlohmann::json &expected,
                      const Numbers &columns_and_keys)
  {
    for (const auto &[column_name, key] : columns_and_keys)
      EXPECT_EQ(std::stod(row.at(column_name)), expected[key].get<double>()) << column_name;
  }

  /// Of every contact, then of every support, the very numbers of the summary.
  void expect_forces(const std::vector<std::map<std::string, std::string>> &rows,
                     const nlohmann::json &summary)
  {
    auto row = rows.begin();
    const auto expect_next = [&](const std::string &from, const nlohmann::json &force) {
      ASSERT_NE(row, rows.end()) << from;
      EXPECT_EQ(row->at("from"), from);
      EXPECT_EQ(std::stod(row->at("x")), force[0].get<double>()) << from;
      EXPECT_EQ(std::stod(row->at("y")), force[1].get<double>()) << from;
      ++row;
    };
    for (const auto &contact : summary["contacts"])
      expect_next("contact " + contact["name"].get<std::string>(), contact["force"]);
    for (const auto &body : summary["bodies"])
      for (const auto &[boundary, force] : body["reactions"].items())
      {
        expect_next("support " + boundary, force);
        EXPECT_EQ(std::prev(row)->at("body"), body["name"]);
      }
    EXPECT_EQ(row, rows.end());
  }

  const std::vector<std::string> small_adaptive = {
      "Body upper/Cells=8, 2",  "Body lower/Cells=8, 2",      "Body upper/Adapt=true",
      "Body lower/Adapt=true",  "Adaptation/Estimator=kelly", "Adaptation/Maximum passes=4",
      "Adaptation/Fraction=0.5"};

  /// A bar that hangs.
  const std::string one_body =
      "set Bodies = bar\nsubsection Body bar\n  set Size = 2, 3\n  set Cells = 2, 3\n"
      "  set Young modulus = 10\n  set Poisson ratio = 0.25\n"
      "  set Body force = 0, -0.5\n  set Conditions = top: displacement: 0, 0\nend\n";
} // namespace

TEST(ReportPage, TellsTheNumbersOfTheSummary)
{
  const Answer answer = run_scene("two-layers-rollers", small_adaptive);
  ASSERT_EQ(answer.status, 0) << answer.err;
  const std::string text = page_of(answer);
  const HtmlNode page = parsed_page(text);
  expect_self_contained(text);

  const auto contacts = table_rows(page, "Contacts");
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_EQ(contacts[0].at("contact"), "interface");
  expect_numbers(contacts[0], answer.summary["contacts"][0],
                 {{"normal force", "normal_force"},
                  {"peak pressure", "max_pressure"},
                  {"contact length", "contact_length"},
                  {"penetration", "max_penetration"},
                  {"largest sliding", "max_sliding"}});
  const auto forces = table_rows(page, "Forces on the bodies, by unit of thickness");
  expect_forces(forces, answer.summary);
  const auto body_rows = table_rows(page, "Bodies");
  ASSERT_EQ(body_rows.size(), 2u);
  for (std::size_t a = 0; a < 2; ++a)
  {
    EXPECT_EQ(body_rows[a].at("body"), answer.summary["bodies"][a]["name"]);
    expect_numbers(body_rows[a], answer.summary["bodies"][a],
                   {{"cells", "cells"},
                    {"unknowns", "dofs"},
                    {"strain energy", "energy"},
                    {"largest von Mises stress", "max_von_mises"},
                    {"largest strain", "max_strain"},
                    {"largest displacement", "max_displacement"}});
  }
  const auto passes = table_rows(page, "Passes; errors are relative");
  ASSERT_EQ(passes.size(), answer.summary["pass_table"].size());
  for (std::size_t i = 0; i < passes.size(); ++i)
    expect_numbers(passes[i], answer.summary["pass_table"][i],
                   {{"cells", "cells"},
                    {"steps", "steps"},
                    {"eta max", "eta_max"},
                    {"estimated", "error_discretisation"},
                    {"iteration", "error_iteration"},
                    {"total", "error_total"},
                    {"true, energy", "true_error_energy"},
                    {"true, pressure", "true_error_pressure"},
                    {"peak pressure", "max_pressure"},
                    {"seconds", "wall_time_s"}});
  EXPECT_NE(text.find("error of the solution is about"), std::string::npos);
}

TEST(ReportPage, HasAPictureOfEveryPassWithAllItsCells)
{
  const Answer answer = run_scene("two-layers-rollers", small_adaptive);
  const HtmlNode page = parsed_page(page_of(answer));
  const auto pictures = pass_pictures(page);
  ASSERT_EQ(pictures.size(), answer.summary["passes"].get<std::size_t>());
  for (const auto &[pass, picture] : pictures)
  {
    // Every cell is a closed subpath of the path of its colour.
    std::size_t cells = 0;
    for (const HtmlNode *path : elements(*picture, "path"))
    {
      const std::string data = attribute(*path, "d");
      if (!attribute(*path, "fill").empty())
        cells += static_cast<std::size_t>(std::count(data.begin(), data.end(), 'z'));
    }
    EXPECT_EQ(cells, answer.summary["pass_table"][pass]["cells"].get<std::size_t>()) << pass;
  }
  std::size_t open = 0;
  for (const HtmlNode *details : elements(page, "details"))
    open += attribute(*details, "open").empty() ? 0 : 1;
  EXPECT_EQ(open, 1u);
}

TEST(ReportPage, ShowsTheExactPressureWhereTheSceneNamesOne)
{
  const std::vector<std::string> coarse = {"Body upper/Cells=16, 4", "Body lower/Cells=16, 4"};
  const std::string known = page_of(run_scene("two-layers-rollers", coarse));
  const std::string unknown = page_of(run_scene(
      "two-layers-rollers", with(coarse, std::vector<std::string>{"Reference/Exact solution=none"})));
  EXPECT_NE(known.find("<title>exact: "), std::string::npos);
  EXPECT_EQ(unknown.find("<title>exact: "), std::string::npos);
  EXPECT_NE(unknown.find("<title>computed: "), std::string::npos);
}

TEST(ReportPage, StaysSmallHoweverFineTheMesh)
{
  const Answer answer = run_scene(
      "two-layers-rollers",
      with(small_adaptive, {"Body upper/Cells=180, 45", "Body lower/Cells=180, 45", "Adaptation/Limit=0",
                            "Reference/Exact solution=none", "Adaptation/Fraction=0.1",
                            "Adaptation/Maximum passes=10", "Adaptation/Maximum unknowns=1000000"}));
  ASSERT_FALSE(answer.summary.is_null()) << answer.err;
  ASSERT_EQ(answer.summary["passes"], 10u);
  ASSERT_GT(answer.summary["pass_table"][9]["cells"].get<std::size_t>(), 20000u);
  const std::string text = page_of(answer);
  EXPECT_LT(text.size(), most_bytes);
  const HtmlNode page = parsed_page(text);
  const auto pictures = pass_pictures(page);
  EXPECT_GE(pictures.size(), 4u);
  EXPECT_EQ(pictures.rbegin()->first, 9u);
  EXPECT_NE(text.find(std::to_string(10 - pictures.size()) + " of 10 passes are not drawn"),
            std::string::npos);
}

TEST(ReportPage, DrawsSomeOfHundredsOfPassesAndSaysSo)
{
  const Answer answer =
      run_scene("two-layers-paper", {"Body upper/Cells=8, 2", "Body lower/Cells=8, 2", "Adaptation/Limit=100",
                                     "Adaptation/Estimator=kelly", "Reference/Exact solution=none",
                                     "Decomposition/Tolerance=1e-12", "Adaptation/Maximum passes=300"});
  ASSERT_FALSE(answer.summary.is_null()) << answer.err;
  ASSERT_EQ(answer.summary["passes"], 300u);
  const std::string text = page_of(answer);
  EXPECT_LT(text.size(), most_bytes);
  const HtmlNode page = parsed_page(text);
  const auto pictures = pass_pictures(page);
  EXPECT_LE(pictures.size(), 25u);
  EXPECT_GE(pictures.size(), 12u);
  EXPECT_EQ(pictures.begin()->first, 0u);
  EXPECT_EQ(pictures.rbegin()->first, 299u);
  EXPECT_NE(text.find(std::to_string(300 - pictures.size()) + " of 300 passes are not drawn"),
            std::string::npos);
  EXPECT_EQ(table_rows(page, "Passes; errors are relative").size(), 201u);
  EXPECT_NE(text.find("100 rows are left out here"), std::string::npos);
}

TEST(ReportPage, OfARunThatHasNotConvergedSaysSoFirst)
{
  const Answer answer = run_scene("two-layers", {"Decomposition/Maximum steps=3"});
  ASSERT_EQ(answer.status, 2);
  const HtmlNode page = parsed_page(page_of(answer));
  const HtmlNode &verdict = page.get_child("body.main.header.p");
  EXPECT_EQ(verdict.get<std::string>("strong"), "Not converged");
}

TEST(ReportPage, TellsTheErrorOfTheIterationWithoutAnEstimator)
{
  const Answer answer = run_scene("v-groove");
  ASSERT_EQ(answer.status, 0) << answer.err;
  const auto parts = table_rows(parsed_page(page_of(answer)), "Parts of the error (energy norm)");
  const auto part = [&](const std::string &name) {
    const auto row =
        std::find_if(parts.begin(), parts.end(), [&](const auto &cells) { return cells.at("part") == name; });
    return row == parts.end() ? std::string() : row->at("error");
  };
  EXPECT_EQ(std::stod(part("iteration")), answer.summary["error"]["iteration"].get<double>());
  EXPECT_EQ(part("discretisation"), "not estimated");
  EXPECT_TRUE(answer.summary["error"]["estimate"].is_null());
}

TEST(ReportPage, OfABodyAloneHasNoContacts)
{
  const Answer answer = run_text(one_body);
  ASSERT_EQ(answer.status, 0) << answer.err;
  const HtmlNode page = parsed_page(page_of(answer));
  EXPECT_TRUE(table_rows(page, "Contacts").empty());
  for (const auto &row : table_rows(page, "Parts of the error (energy norm)"))
    for (const std::string part : {"contact", "iteration", "penalty"})
      EXPECT_NE(row.at("part"), part);
  for (const std::string column : {"steps", "iteration"})
    EXPECT_EQ(table_rows(page, "Passes; errors are relative").at(0).count(column), 0u) << column;
  EXPECT_NE(page_of(answer).find("After 1 pass. "), std::string::npos);
  EXPECT_EQ(answer.out.find("step "), std::string::npos) << answer.out;
  EXPECT_EQ(table_rows(page, "Bodies").size(), 1u);
  EXPECT_EQ(pass_pictures(page).size(), 1u);
}

TEST(ReportPage, DrawsABodyThatHasSettledNearItsPlace)
{
  const std::string settled = page_of(run_scene("v-groove", {"Body disc/Shift=0, 0.05"})),
                    touching = page_of(run_scene("v-groove"));
  EXPECT_NE(settled.find("Deformed: deformations times 20, rigid motions times "), std::string::npos);
  EXPECT_NE(touching.find("Deformed: displacements times 20, initial gaps times 1"), std::string::npos);
}

TEST(ReportPage, DrawsRigidBodies)
{
  const Answer answer = run_scene("coated-block");
  ASSERT_EQ(answer.status, 0) << answer.err;
  const HtmlNode page = parsed_page(page_of(answer));
  std::size_t rigid = 0;
  for (const HtmlNode *path : elements(*pass_pictures(page).begin()->second, "path"))
    rigid += attribute(*path, "class") == "rigid" ? 1 : 0;
  std::size_t expected = 0;
  for (const auto &body : answer.summary["bodies"])
    expected += body["cells"] == 0 ? 1 : 0;
  EXPECT_GT(rigid, 0u);
  EXPECT_EQ(rigid, expected);
}

TEST(ReportPage, PutsWarningsBeforeFigures)
{
  const Answer answer = run_text(one_body, {"Body bar/Young modulus=1"});
  ASSERT_TRUE(warning_codes(answer).count("large-strain")) << answer.err;
  const std::string text = page_of(answer);
  EXPECT_LT(text.find("<strong>large-strain</strong>"), text.find("Key figures"));
}

TEST(ReportPage, EscapesTheNameOfTheFile)
{
  const Answer answer = run({temporary_file("a <b> & \"c\" <script>.prm", one_body), "--quiet"});
  ASSERT_EQ(answer.status, 0) << answer.err;
  const HtmlNode page = parsed_page(page_of(answer));
  EXPECT_EQ(page.get<std::string>("body.main.header.h1"), "a <b> & \"c\" <script>.prm");
  EXPECT_EQ(elements(page, "script").size(), 1u);
}

TEST(ReportPage, IsLeftOutWhenNotAskedFor)
{
  const Answer answer = run_text(one_body, {"Output/Report=false"});
  ASSERT_EQ(answer.status, 0) << answer.err;
  EXPECT_FALSE(fs::exists(answer.directory + "/report.html"));
  const auto &left_out = answer.summary["left_out"];
  EXPECT_EQ(std::count(left_out.begin(), left_out.end(), "report.html (Output/Report is false)"), 1);
}
