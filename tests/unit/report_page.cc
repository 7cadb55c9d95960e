// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/report/page/cell_paths.h>
#include <abut/report/page/diagram.h>
#include <abut/report/page/path_data.h>
#include <abut/report/page/report_page.h>
#include <abut/report/page/stress_bar.h>
#include <abut/report/plot_range.h>

#include "../html_page.h"
#include "report_testing.h"
#include <algorithm>
#include <sstream>

namespace
{
  using namespace abut;
  using abut::testing::attribute;
  using abut::testing::elements;
  using abut::testing::HtmlNode;
  using abut::testing::parsed_page;

  std::string page_with_picture(const Results &results)
  {
    PassDrawings drawings;
    drawings.add_last(results, Executor());
    return report_page(results, {drawings.drawings(), {}, .25, 1.});
  }

  /// Squares of side 1 in a row, with a stress each.
  DrawnScene row_of_squares(const std::vector<double> &stresses)
  {
    DrawnScene scene;
    scene.bodies.resize(1);
    scene.bodies[0].von_mises = stresses;
    for (std::size_t i = 0; i < stresses.size(); ++i)
    {
      const auto x = static_cast<double>(i);
      scene.bodies[0].cells.push_back({{x, 0.}, {x + 1., 0.}, {x + 1., 1.}, {x, 1.}});
    }
    return scene;
  }

  /// Fills and data of the paths.
  std::vector<std::string> path_data_of(const DrawnScene &scene, const int square)
  {
    ColourRange range;
    range.include({0., 1.});
    PageFrame frame;
    frame.scale = 10.;
    frame.origin = Vector2(0., 10.);
    std::ostringstream out;
    write_cell_paths(out, scene, range, frame, square);
    std::istringstream in("<svg>" + out.str() + "</svg>");
    HtmlNode tree;
    boost::property_tree::read_xml(in, tree);
    std::vector<std::string> data;
    for (const HtmlNode *path : elements(tree, "path"))
      data.push_back(attribute(*path, "d"));
    return data;
  }

  TEST_F(ReportedScene, PageEscapesWhateverTextsItShows)
  {
    const std::string hostile = "</p><script>alert(\"1 & 2\")</script>";
    scene.file = "x/" + std::string("a & <b>.prm");
    results.iteration.message = hostile;
    results.warnings = {{WarningCode::large_strain, hostile}};
    results.left_out = {hostile};
    results.adaptation_end = AdaptationEnd{hostile, ""};
    results.passes[0].discretisation = .5;
    results.passes[0].budget.discretisation = .5;
    results.passes[0].estimate_reason = hostile;
    const HtmlNode page = parsed_page(page_with_picture(results));
    EXPECT_EQ(page.get<std::string>("head.title"), "a & <b>.prm - abut");
    EXPECT_EQ(elements(page, "script").size(), 1u);
    std::size_t shown = 0;
    for (const char *tag : {"p", "li"})
      for (const HtmlNode *element : elements(page, tag))
        shown += element->data().find(hostile) != std::string::npos ? 1 : 0;
    EXPECT_EQ(shown, 5u);
  }

  TEST_F(ReportedScene, PageSaysWhichPartsOfTheErrorAreMissing)
  {
    results.passes[0].budget.discretisation = .03;
    results.passes[0].budget.iteration = .04;
    results.passes[0].budget.penalty = 0.;
    const std::string text = page_with_picture(results);
    EXPECT_NE(
        text.find("about <data value=\"0.050000000000000003\">5 %</data> in the energy norm without what "
                  "was not estimated (linear algebra, geometry)."),
        std::string::npos);
  }

  TEST_F(ReportedScene, PageShowsBothPartsOfTheInterface)
  {
    const HtmlNode page = parsed_page(page_with_picture(results));
    std::vector<std::string> titles;
    for (const HtmlNode *title : elements(page.get_child("body"), "title"))
      titles.push_back(title->data());
    EXPECT_EQ(titles, (std::vector<std::string>{"computed: 6 at 0", "computed: 1 at 1",
                                                "gap, negative: penetration: -0.125 at 0",
                                                "gap, negative: penetration: 0.25 at 1"}));
  }

  TEST(ReportPath, IsShort)
  {
    PathData path;
    path.add_closed({{0, 0}, {8, 0}, {8, 8}, {0, 8}});
    path.add_closed({{10, 3}, {12, 4}, {9, 9}});
    EXPECT_EQ(path.text(), "m0 0h8v8h-8zm10 3 2 1-3 5z");
  }

  TEST(ReportPath, CellsOfAColourShareAPath)
  {
    EXPECT_EQ(path_data_of(row_of_squares({0., 1., 0.}), 1),
              (std::vector<std::string>{"m0 10h10v-10h-10zm20 0h10v-10h-10z", "m10 10h10v-10h-10z"}));
  }

  TEST(ReportPath, PointsOnStraightEdgesAreLeftOut)
  {
    DrawnScene scene = row_of_squares({1.});
    scene.bodies[0].cells[0] = {{0., 0.}, {.5, .004}, {1., 0.}, {1., .5}, {1., 1.}, {0., 1.}};
    EXPECT_EQ(path_data_of(scene, 1), std::vector<std::string>{"m0 10h10v-10h-10z"});
  }

  // Each point lies within a unit of the line between its neighbours, the top three units above the ends.
  TEST(ReportPath, FinelySampledCurvesStayCurved)
  {
    DrawnScene scene = row_of_squares({1.});
    scene.bodies[0].cells[0] = {{0., 0.}, {1., 0.}, {1., 1.}};
    for (const double x : {.9, .8, .7, .6, .5, .4, .3, .2, .1})
      scene.bodies[0].cells[0].push_back({x, 1. + 1.2 * x * (1. - x)});
    scene.bodies[0].cells[0].push_back({0., 1.});
    const std::string path = path_data_of(scene, 1).at(0);
    EXPECT_NE(path.find("m0 10h10v-10"), std::string::npos) << path;
    EXPECT_GT(std::count(path.begin(), path.end(), '-'), 3) << path; // more than the square's lines
  }

  TEST(ReportPath, BodiesLieOverOneAnotherWhole)
  {
    DrawnScene scene = row_of_squares({0., 1.});
    scene.bodies.push_back(row_of_squares({0., 1.}).bodies[0]);
    const std::vector<std::string> one = path_data_of(row_of_squares({0., 1.}), 1);
    EXPECT_EQ(path_data_of(scene, 1), (std::vector<std::string>{one[0], one[1], one[0], one[1]}));
  }

  TEST(ReportPath, SmallCellsBecomeSquaresWithTheirMeanStress)
  {
    // Cells of 10 units in squares of 20: means 0 and 0 make one rectangle, 1/2 makes another.
    EXPECT_EQ(path_data_of(row_of_squares({0., 0., 0., 0., 0., 1.}), 20),
              (std::vector<std::string>{"m0 0h40v20h-40z", "m40 0h20v20h-20z"}));
  }

  TEST(ReportStress, SingularPeaksDoNotTakeAllColours)
  {
    std::vector<double> stresses(1000, 1.);
    stresses.back() = 100.;
    EXPECT_EQ(stress_range_of({{0, row_of_squares(stresses)}}).colours.high, 2.);
    EXPECT_EQ(stress_range_of({{0, row_of_squares(stresses)}}).largest, 100.);
    stresses.back() = 3.;
    EXPECT_EQ(stress_range_of({{0, row_of_squares(stresses)}}).colours.high, 3.);
  }

  TEST(ReportDiagram, AnAxisOfValuesThatDifferByRoundOffHasTicks)
  {
    for (const double value : {1e16, 1., 1e-12, 0., -.75})
    {
      AxisRange range;
      range.include(value);
      range.include(value * (1. + 4e-16));
      range.widen();
      const std::vector<double> ticks = range.ticks();
      EXPECT_GE(ticks.size(), 1u) << value;
      EXPECT_LE(ticks.size(), 12u) << value;
      EXPECT_LT(range.low, value);
      EXPECT_GT(range.high, value);
    }
  }

  TEST(ReportDiagram, ThinnedCurvesKeepTheirPeaks)
  {
    Polyline points;
    for (int i = 0; i < 1000; ++i)
      points.emplace_back(i, i == 500 || i == 702 ? 7. : i == 501 || i == 701 ? -7. : 0.);
    const Polyline shown = thinned(points, 50);
    EXPECT_LE(shown.size(), 100u);
    for (const Vector2 &peak : {Vector2(500., 7.), Vector2(501., -7.), Vector2(701., -7.), Vector2(702., 7.)})
      EXPECT_EQ(std::count(shown.begin(), shown.end(), peak), 1) << peak.x();
    EXPECT_TRUE(std::is_sorted(shown.begin(), shown.end(),
                               [](const Vector2 &a, const Vector2 &b) { return a.x() < b.x(); }));
    EXPECT_EQ(thinned(points, 500).size(), 1000u);
  }

  TEST_F(ReportedScene, DrawingsAreThinnedOut)
  {
    PassDrawings drawings;
    for (unsigned int pass = 0; pass < 100; ++pass)
    {
      results.passes.back().pass = pass;
      drawings.add(results, Executor());
    }
    drawings.add_last(results, Executor());
    std::vector<unsigned int> passes;
    for (const PassDrawing &drawing : drawings.drawings())
      passes.push_back(drawing.pass);
    std::vector<unsigned int> expected;
    for (unsigned int pass = 0; pass < 100; pass += 8)
      expected.push_back(pass);
    expected.push_back(99);
    EXPECT_EQ(passes, expected);
  }
} // namespace
