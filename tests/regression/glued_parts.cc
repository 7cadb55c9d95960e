// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Bodies glued of parts, as a whole program sees them.
#include <gtest/gtest.h>

#include "../unit/vtu_file.h"
#include "bonded_layers.h"
#include "program.h"
#include <algorithm>
#include <cmath>
#include <regex>
#include <sstream>

using namespace abut::testing;

namespace
{
  /// The lower of two layers, whole or glued at x = 2 of meshes that do not match.
  std::string pressed_layers(const bool is_glued)
  {
    const std::string
        whole = "subsection Body lower\n set Size = 4, 1\n set Cells = 8, 2\n set Young modulus = 2.1e5\n"
                " set Adapt = true\n set Conditions = left: normal displacement: 0; "
                "right: normal displacement: 0; bottom: normal displacement: 0\nend\n",
        parts =
            "subsection Part west\n set Size = 2, 1\n set Cells = 4, 2\n set Young modulus = 2.1e5\nend\n"
            "subsection Part east\n set Size = 2, 1\n set Cells = 4, 3\n set Shift = 2, 0\n"
            " set Young modulus = 2.1e5\nend\nsubsection Body lower\n set Shape = glued parts\n"
            " set Parts = west, east\n set Adapt = true\n set Conditions = west.left: normal displacement: "
            "0; "
            "east.right: normal displacement: 0; west.bottom + east.bottom: normal displacement: 0\nend\n";
    return "set Bodies = upper, lower\nset Contacts = c\nsubsection Body upper\n set Size = 4, 1\n set Shift "
           "= 0, 1\n"
           " set Cells = 8, 2\n set Young modulus = 2.1e5\n set Adapt = true\n"
           " set Conditions = left: normal displacement: 0; right: normal displacement: 0; top: displacement "
           "y: -1.366e-3\n"
           "end\n" +
           (is_glued ? parts : whole) +
           "subsection Contact c\n set Slave = lower:" + (is_glued ? "west.top + east.top" : "top") +
           "\n set Master = upper:bottom\n set Gap = 1e-3*x^2\nend\n";
  }
} // namespace

TEST(GluedParts, AreAsGoodAsOneMeshAndEstimatedLikeIt)
{
  constexpr double exact_force = 133.8365; // prm/two-layers-rollers.prm
  for (const std::string estimator : {"fe-be", "kelly"})
    for (const int degree : {1, 2, 3})
    {
      const std::vector<std::string> adapting = {
          "Adaptation/Estimator=" + estimator, "Adaptation/Marking=doerfler",
          "Adaptation/Maximum passes=" + std::to_string(9 - 2 * degree),
          "Discretisation/Degree=" + std::to_string(degree)};
      const Answer one = run_text(pressed_layers(false), adapting),
                   two = run_text(pressed_layers(true), adapting);
      ASSERT_EQ(one.status, 0) << one.err;
      ASSERT_EQ(two.status, 0) << two.err;
      expect_balance(two);
      const auto estimated = [](const Answer &answer) {
        return answer.summary["error"]["discretisation"].get<double>();
      };
      EXPECT_NEAR(estimated(two) / estimated(one), 1., .15) << estimator << degree;
      EXPECT_NEAR(contact_value(two, "c", "normal_force") / exact_force, 1., 5e-3) << estimator << degree;
      EXPECT_EQ(one.summary["counters"]["bodies"]["lower"]["mortars"], 0);
      EXPECT_GT(two.summary["counters"]["bodies"]["lower"]["mortars"], 0);
      EXPECT_EQ(one.summary["bodies"][1]["cells_at_glue"], 0);
      EXPECT_GT(two.summary["bodies"][1]["cells_at_glue"], 0);
    }
}

TEST(GluedParts, EdgesToFinerCellsByMortarInAllItsKinds)
{
  const auto run_with = [](const std::string &slave, const std::string &vertices,
                           const std::string &estimator) {
    std::vector<std::string> overrides = {"Adaptation/Estimator=" + estimator, "Adaptation/Marking=doerfler",
                                          "Adaptation/Maximum passes=5", "Discretisation/Degree=2"};
    if (!slave.empty())
      overrides =
          with(overrides, {"Body lower/Nonconforming edges=mortar", "Body upper/Nonconforming edges=mortar",
                           "Mortar/Slave=" + slave, "Mortar/Vertices=" + vertices});
    return run_text(pressed_layers(false), overrides);
  };
  const Answer hanging = run_with("", "", "fe-be"), tied = run_with("finer", "tied", "fe-be"),
               free = run_with("finer", "free", "fe-be"), coarser = run_with("coarser", "tied", "fe-be");
  for (const Answer *answer : {&hanging, &tied, &free, &coarser})
  {
    ASSERT_EQ(answer->status, 0) << answer->err;
    expect_balance(*answer);
  }
  const auto force = [](const Answer &answer) { return contact_value(answer, "c", "normal_force"); };
  const auto estimated = [](const Answer &answer) {
    return answer.summary["error"]["discretisation"].get<double>();
  };
  EXPECT_NEAR(force(tied) / force(hanging), 1., 1e-9);
  EXPECT_NEAR(estimated(tied) / estimated(hanging), 1., 1e-6);
  EXPECT_NEAR(estimated(free) / estimated(hanging), 1., .1);
  EXPECT_GT(estimated(coarser), 2. * estimated(hanging)); // boundary elements see what it lacks
  // Other estimators do not, and the run says so.
  EXPECT_EQ(warning_codes(run_with("coarser", "tied", "kelly")).count("rough-estimator"), 1u);
  EXPECT_EQ(warning_codes(run_with("finer", "tied", "kelly")).count("rough-estimator"), 0u);
}

TEST(GluedParts, RegionsOfAMeshFileThatDoNotShareNodes)
{
  // Two squares, one above the other, each with nodes of its own at y = 1.
  std::ostringstream nodes, elements;
  int n_nodes = 0, n_elements = 0;
  const auto square = [&](const int n, const double bottom, const int lower_side, const int upper_side) {
    const int first = n_nodes + 1;
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i)
        nodes << ++n_nodes << ' ' << double(i) / n << ' ' << bottom + double(j) / n << " 0\n";
    const auto at = [&](const int i, const int j) { return first + i + j * (n + 1); };
    for (int i = 0; i < n; ++i)
    {
      elements << ++n_elements << " 1 2 " << lower_side << ' ' << lower_side << ' ' << at(i, 0) << ' '
               << at(i + 1, 0) << '\n';
      elements << ++n_elements << " 1 2 " << upper_side << ' ' << upper_side << ' ' << at(i, n) << ' '
               << at(i + 1, n) << '\n';
      for (int j = 0; j < n; ++j)
        elements << ++n_elements << " 3 2 9 9 " << at(i, j) << ' ' << at(i + 1, j) << ' ' << at(i + 1, j + 1)
                 << ' ' << at(i, j + 1) << '\n';
    }
  };
  square(4, 0., 1, 2);
  square(7, 1., 3, 4);
  const auto mesh_file = [&](const std::string &edges_and_cells) {
    return temporary_file("squares.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n4\n1 1 "
                                         "\"base\"\n1 2 \"below\"\n1 3 \"above\"\n"
                                         "1 4 \"top\"\n$EndPhysicalNames\n$Nodes\n" +
                                             std::to_string(n_nodes) + "\n" + nodes.str() +
                                             "$EndNodes\n$Elements\n" + std::to_string(n_elements) + "\n" +
                                             edges_and_cells + "$EndElements\n");
  };
  const std::string mesh = mesh_file(elements.str());
  const auto scene = [&](const std::string &glue) {
    return "set Bodies = squares\nsubsection Body squares\n set Mesh file = " + mesh +
           "\n set Young modulus = 100\n set Poisson ratio = 0\n set Glue = " + glue +
           "\n set Conditions = base: displacement: 0, 0; top: pressure: 1\nend\n";
  };
  for (const std::string glue : {"automatic", "above - below", "below - above"})
  {
    const Answer answer = run_text(scene(glue));
    ASSERT_EQ(answer.status, 0) << answer.err;
    EXPECT_NEAR(answer.summary["bodies"][0]["max_displacement"].get<double>(), .02,
                1e-12); // uniform pressure
    EXPECT_NEAR(answer.summary["bodies"][0]["energy"].get<double>(), .01, 1e-12);
  }
  expect_refused(run_text(scene("none")), {"several parts"});
  // One side around both squares: no piece has a side of its own that could be glued.
  const std::string common =
      mesh_file(std::regex_replace(elements.str(), std::regex(" 1 2 [234] [234] "), " 1 2 1 1 "));
  expect_refused(
      run_text("set Bodies = squares\nsubsection Body squares\n set Glue = automatic\n set Mesh file = " +
               common + "\n set Conditions = (0, 0): displacement: 0, 0; (1, 0): displacement y: 0\nend\n"),
      {"nothing glues the piece"});
  expect_refused(run_text(scene("above; below")), {"slave - master"});
}

TEST(GluedParts, ACoatingHasTheStressJumpOfBondedLayers)
{
  const Answer answer = run_scene("coated-block");
  ASSERT_EQ(answer.status, 0) << answer.err;
  expect_balance(answer);
  const std::string csv = answer.directory + "/contact_tip.csv";
  BondedLayers exact({2., 100.}, {.25, 1000.}, 8.);
  exact.press(column(csv, "x"), column(csv, "length"), column(csv, "pressure"));
  const abut::testing::VtuFile file(read_file(answer.directory + "/solution_block.vtu"));
  const VtuField &stress = file.fields.at("stress_xx");
  double largest = 0., worst = 0.;
  std::size_t n_compared = 0;
  for (std::size_t cell = 0; cell < file.cells.size(); ++cell)
    for (const std::size_t point : file.cells[cell])
      if (const abut::Vector2 place = file.points[point]; std::abs(place.y() - 2.) < 1e-9)
      {
        const bool is_above = file.middle(cell).y() > 2.;
        const double right = is_above ? exact.above(place.x()) : exact.below(place.x());
        largest = std::max(largest, std::abs(exact.above(place.x()) - exact.below(place.x())));
        worst = std::max(worst, std::abs(stress(point) - right));
        ++n_compared;
      }
  std::cout << "largest jump " << largest << ", largest difference " << worst << " at " << n_compared
            << " places\n";
  EXPECT_GT(n_compared, 80u);
  EXPECT_LT(worst, .02 * largest);
}

TEST(GluedParts, ABushIsAsStiffAsRubberBetweenRigidCylinders)
{
  const Answer answer = run_scene("steel-rubber-bush");
  ASSERT_EQ(answer.status, 0) << answer.err;
  expect_balance(answer);
  constexpr double shear = 2. / (2. * 1.49999), a = 10., b = 20., squares = a * a + b * b;
  const double force = .01 * 4. * M_PI * shear * squares / (squares * std::log(b / a) - (b * b - a * a));
  const auto reactions = answer.summary["bodies"][0]["reactions"];
  EXPECT_NEAR(-reactions["inner.inner"][1].get<double>() / force, 1., 1e-3);
  EXPECT_NEAR(reactions["outer.outer"][1].get<double>() / force, 1., 1e-3);
}

TEST(GluedParts, WhatTheirSectionsSayTwiceIsRefused)
{
  const auto scene = [](const std::string &parts, const std::string &entries) {
    return "set Bodies = b\nsubsection Part low\n set Size = 2, 1\n set Cells = 4, 2\nend\nsubsection Part "
           "up\n"
           " set Size = 2, 1\n set Cells = 6, 2\n set Shift = 0, 1\nend\nsubsection Body b\n set Shape = "
           "glued parts\n"
           " set Parts = " +
           parts + "\n set Conditions = low.bottom: displacement: 0, 0\n" + entries + "end\n";
  };
  EXPECT_EQ(run_text(scene("low, up", "")).status, 0);
  expect_refused(run_text(scene("low", "")), {"Body b/Parts", "two at least"});
  expect_refused(run_text(scene("low, up, low", "")), {"Body b/Parts", "given twice"});
  expect_refused(run_text(scene("low, middle", "")), {"needs a section `Part middle`"});
  for (const std::string entry : {"Size = 3, 3", "Cells = 2, 2", "Mesh size = 1", "Young modulus = 2"})
    expect_refused(run_text(scene("low, up", " set " + entry + "\n")),
                   {"each of the glued parts has its own"});
  expect_refused(run_text("set Bodies = b\nsubsection Body b\nend\nsubsection Part low\nend\n"),
                 {"Part low", "no body"});
  expect_refused(run_text("set Bodies = b\nsubsection Body b\n set Parts = c, d\nend\n"),
                 {"Body b/Parts", "no other"});
}

TEST(GluedParts, FoundContactsAreNotThoseOfGluedSides)
{
  const Answer answer =
      run_text("set Bodies = b, punch\nset Contacts = automatic\nset Contact distance = 0.02\n"
               "subsection Part low\n set Size = 2, 1\n set Cells = 8, 4\nend\n"
               "subsection Part coat\n set Size = 2, 0.01\n set Cells = 12, 1\n set Shift = 0, 1\nend\n"
               "subsection Body b\n set Shape = glued parts\n set Parts = low, coat\n set Conditions = "
               "low.bottom: displacement: 0, 0\n"
               "end\nsubsection Body punch\n set Shape = rigid outline\n set Outline = (0.5, 1.01) -> foot: "
               "(1.5, 1.01) -> (1.5, 2) -> "
               "(0.5, 2) -> close\n set Conditions = foot: displacement: 0, -0.001\nend\n");
  ASSERT_EQ(answer.status, 0) << answer.err;
  ASSERT_EQ(answer.summary["contacts"].size(), 1u);
  EXPECT_EQ(answer.summary["contacts"][0]["name"], "b.coat.top-punch.foot");
}

TEST(GluedParts, FloatOnWhatCarriesThem)
{
  // Two layers on a rigid floor, pressed by 1 over a width of 2 and pulled down by 0.5 a volume of 4.
  const Answer answer =
      run_text("set Bodies = b, floor\nset Contacts = c\n"
               "subsection Part low\n set Size = 2, 1\n set Cells = 6, 3\n set Young modulus = 100\nend\n"
               "subsection Part up\n set Size = 2, 1\n set Cells = 8, 4\n set Shift = 0, 1\n set Young "
               "modulus = 1e6\nend\n"
               "subsection Body b\n set Shape = glued parts\n set Parts = low, up\n set Body force = 0, "
               "-0.5\n set Adapt = true\n"
               " set Conditions = (0, 0): displacement x: 0; up.top: pressure: 1\nend\n"
               "subsection Body floor\n set Shape = rigid outline\n set Outline = (-1, -1) -> (3, -1) -> (3, "
               "0) -> ground: (-1, 0) -> close\n"
               " set Conditions = ground: displacement: 0, 0\nend\n"
               "subsection Contact c\n set Slave = b:low.bottom\n set Master = floor:ground\nend\n",
               {"Adaptation/Estimator=fe-be", "Adaptation/Marking=doerfler", "Adaptation/Maximum passes=3"});
  ASSERT_EQ(answer.status, 0) << answer.err;
  expect_balance(answer);
  EXPECT_NEAR(contact_value(answer, "c", "normal_force"), 4., 1e-9);
}

TEST(GluedParts, CornersGluedOnEitherSideAreNotLoadedTwice)
{
  // Three parts around (1, 1) under one linear displacement: nothing is wrong, and fe-be has to say so. It
  // estimated 12 %, or refused where only the glue holds a part.
  const std::string low = "l.bottom + r.bottom: displacement: 0.2*x, 0.5*x; l.left: displacement: -0.3*y, "
                          "-0.4*y; r.right: displacement: 0.2*x - 0.3*y, 0.5*x - 0.4*y; ",
                    held = "t.left: displacement: -0.3*y, -0.4*y; t.top + t.right: displacement: "
                           "0.2*x - 0.3*y, 0.5*x - 0.4*y",
                    pulled = "t.left: traction: -1/26, -2/26; t.right: traction: 1/26, 2/26; "
                             "t.top: traction: 2/26, -11/26";
  for (const std::string &conditions : {low + held, low + pulled})
    for (const std::string degree : {"1", "2"})
    {
      const Answer answer =
          run_text("set Bodies = b\nsubsection Part l\n set Size = 1, 1\n set Cells = 4, 4\nend\n"
                   "subsection Part r\n set Size = 2, 1\n set Cells = 6, 3\n set Shift = 1, 0\nend\n"
                   "subsection Part t\n set Size = 3, 1\n set Cells = 10, 3\n set Shift = 0, 1\nend\n"
                   "subsection Body b\n set Shape = glued parts\n set Parts = l, r, t\n set Conditions = " +
                       conditions + "\nend\n",
                   {"Adaptation/Estimator=fe-be", "Discretisation/Degree=" + degree});
      ASSERT_EQ(answer.status, 0) << answer.err;
      EXPECT_LT(answer.summary["error"]["discretisation"].get<double>(), 1e-4) << degree;
    }
}
