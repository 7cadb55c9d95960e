// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bodies/finite_elements/nodes.h>
#include <abut/report/colour_map.h>
#include <abut/report/deformed.h>
#include <abut/report/exaggeration.h>
#include <abut/report/picture.h>
#include <abut/report/svg.h>
#include <abut/report/vtu.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include "report_testing.h"

namespace
{
  using namespace abut;
  using boost::property_tree::ptree;

  /// Throws when the text is not well-formed XML.
  ptree parse_xml(const std::string &text)
  {
    std::istringstream in(text);
    ptree tree;
    boost::property_tree::read_xml(in, tree);
    return tree;
  }

  TEST(ReportColours, RunFromDarkBlueToYellow)
  {
    EXPECT_EQ(viridis(0.), "#440154");
    EXPECT_EQ(viridis(-1.), "#440154");
    EXPECT_EQ(viridis(1.), "#fde725");
    EXPECT_EQ(viridis(2.), "#fde725");
    EXPECT_EQ(viridis(.5 / 19.), "#460b5e"); // half way between #440154 and #481567
  }

  TEST_F(ReportedScene, PictureIsWellFormedAndHasEveryCell)
  {
    scene.file = "folder/a & <b>.prm";
    const std::string text = picture(results, deformed_scene(results, Executor()));
    const ptree svg = parse_xml(text).get_child("svg");
    EXPECT_EQ(svg.get<std::string>("g.text"), "a & <b>.prm");
    std::size_t cells = 0;
    for (const auto &[tag, group] : svg)
      if (group.count("path") > 0)
        cells += group.count("path");
    EXPECT_EQ(cells, 2u);
    EXPECT_EQ(occurrences(text, "nan"), 0u);
  }

  TEST_F(ReportedScene, RigidBodiesAreNotExaggeratedButDrawnApart)
  {
    const DrawnScene drawn = deformed_scene(results, Executor());
    EXPECT_EQ(drawn.exaggeration.deformation, 1.);
    EXPECT_EQ(drawn.exaggeration.rigid, 1.);
    ASSERT_TRUE(drawn.moved_apart);
    // The upper square went down by 1/8 and is drawn 2/100 of the diagonal above the lower one.
    double lowest = 10., highest = -10.;
    for (const Vector2 &point : drawn.bodies[0].cells[0])
      lowest = std::min(lowest, point.y());
    for (const Vector2 &point : drawn.bodies[1].cells[0])
      highest = std::max(highest, point.y());
    EXPECT_NEAR(highest - lowest + .02 * std::sqrt(5.), 0., 1e-14);
  }

  TEST_F(ReportedScene, BodiesThatStandApartStayWhereTheyAre)
  {
    for (const auto &dofs : all_nodes(space_of(*bodies[0])).dofs)
      results.bodies[0].displacement[dofs[1]] = .125;
    EXPECT_FALSE(deformed_scene(results, Executor()).moved_apart);
  }

  TEST_F(ReportedScene, ExaggerationMakesTheDeformationVisible)
  {
    results.bodies[0].displacement.setZero();
    results.pairs[0].max_pressure = 0.;
    for (const double amplitude : {1e-6, 3e-4, .7})
    {
      const Nodes nodes = all_nodes(space_of(*bodies[1]));
      for (std::size_t i = 0; i < nodes.dofs.size(); ++i) // stretched to both sides
        results.bodies[1].deformation[nodes.dofs[i][0]] = amplitude * (nodes.places[i].x() - .5);
      results.bodies[1].displacement = results.bodies[1].deformation;
      const double shown =
          deformed_scene(results, Executor()).exaggeration.deformation * .5 * amplitude / std::sqrt(5.);
      EXPECT_LE(shown, .05 * (1. + 1e-12)) << amplitude;
      EXPECT_GE(shown, .02 * (1. - 1e-12)) << amplitude;
    }
  }

  constexpr double settled_depth = 2e-4;

  /// For deformations of 1e-4 in a scene of size 1, where the bodies' rigid motions have closed the initial
  /// gap and gone on by the depth, and moved the sides along each other.
  Exaggeration factors_of(std::vector<PairResult> &pairs, const double sliding = 0.)
  {
    pairs[0].rigid_gaps = Eigen::Vector2d::Constant(-settled_depth);
    pairs[0].rigid_sliding = Eigen::Vector2d::Constant(sliding);
    return exaggeration_of(pairs, 1e-4, 1.);
  }

  class SettledScene : public ReportedScene
  {
  protected:
    static constexpr double gap = .25;

    SettledScene() { overrides.push_back("Contact interface/Gap=0.25"); }
  };

  TEST_F(SettledScene, IsDrawnTouchingWhereItTouches)
  {
    const Exaggeration factors = factors_of(results.pairs);
    EXPECT_EQ(factors.deformation, 500.);
    // Up to the two digits that the factor is told with.
    const double motion = gap + settled_depth,
                 drawn = gap - factors.rigid * motion + factors.deformation * settled_depth;
    EXPECT_LT(std::abs(drawn), .05 * factors.rigid * motion);
    EXPECT_GE(factors.rigid, 1.);
    EXPECT_LT(factors.rigid, 2.);
    EXPECT_EQ(exaggeration_text(factors, true),
              "deformations times 500, rigid motions times 1.4, initial gaps times 1");
  }

  TEST_F(ReportedScene, WithoutAnInitialGapAllMotionsHaveOneFactor)
  {
    const Exaggeration factors = factors_of(results.pairs);
    EXPECT_EQ(factors.rigid, factors.deformation);
    EXPECT_EQ(exaggeration_text(factors, true), "displacements times 500, initial gaps times 1");
    EXPECT_EQ(exaggeration_text(factors, false), "displacements times 500");
  }

  TEST_F(ReportedScene, BodiesThatMoveAlongEachOtherStayInSight)
  {
    EXPECT_EQ(factors_of(results.pairs, .01).rigid, 50.);
    EXPECT_EQ(factors_of(results.pairs, -.01).rigid, 50.);
    EXPECT_EQ(factors_of(results.pairs, 3.).rigid, 1.);
    EXPECT_EQ(factors_of(results.pairs, 1e-4).rigid, 500.);
  }

  TEST(Exaggeration, NeedsNoContact)
  {
    EXPECT_EQ(exaggeration_of({}, 1e-4, 1.).rigid, 500.);
    EXPECT_EQ(exaggeration_of({}, 0., 1.).rigid, 1.);
  }

  TEST_F(ReportedScene, MeanStressOfACellIsThatOfUniformStrain)
  {
    const Nodes nodes = all_nodes(space_of(*bodies[1]));
    for (std::size_t i = 0; i < nodes.dofs.size(); ++i)
      results.bodies[1].deformation[nodes.dofs[i][0]] = 1e-3 * nodes.places[i].x();
    Eigen::Matrix2d gradient;
    gradient << 1e-3, 0., 0., 0.;
    const double expected = bodies[1]->material().stress(gradient).von_mises();
    EXPECT_NEAR(deformed_scene(results, Executor()).bodies[1].von_mises.at(0), expected, 1e-13 * expected);
  }

  TEST_F(ReportedScene, VtuIsXmlWithAllArrays)
  {
    const ptree piece = parse_xml(vtu(results.bodies[0])).get_child("VTKFile.UnstructuredGrid.Piece");
    EXPECT_EQ(piece.get<int>("<xmlattr>.NumberOfCells"), 1);
    std::map<std::string, std::string> arrays;
    for (const char *data : {"PointData", "CellData"})
      if (const auto part = piece.get_child_optional(data))
        for (const auto &[tag, array] : *part)
          if (tag == "DataArray")
            arrays[array.get<std::string>("<xmlattr>.Name")] =
                array.get<std::string>("<xmlattr>.NumberOfComponents", "1");
    EXPECT_EQ(arrays, (std::map<std::string, std::string>{{"displacement", "3"},
                                                          {"level", "1"},
                                                          {"mean_von_mises", "1"},
                                                          {"stress_xx", "1"},
                                                          {"stress_xy", "1"},
                                                          {"stress_yy", "1"},
                                                          {"stress_zz", "1"},
                                                          {"von_mises", "1"}}));
  }

  TEST(ReportPvd, NamesEveryFile)
  {
    const ptree collection =
        parse_xml(pvd({{"solution_a.vtu", {}}, {"solution_b.vtu", {}}})).get_child("VTKFile.Collection");
    std::vector<std::string> files;
    for (const auto &[tag, set] : collection)
      files.push_back(set.get<std::string>("<xmlattr>.part") + ":" + set.get<std::string>("<xmlattr>.file"));
    EXPECT_EQ(files, (std::vector<std::string>{"0:solution_a.vtu", "1:solution_b.vtu"}));
  }

  TEST_F(ReportedScene, PvtuHasTheArraysOfAllBodies)
  {
    const std::vector<FieldArray> arrays = arrays_of(output_patches(results.bodies[0]));
    const ptree grid = parse_xml(pvtu({{"solution_a.vtu", arrays},
                                       {"solution_b.vtu", {{"level", false}, {"displacement", true}}}}))
                           .get_child("VTKFile.PUnstructuredGrid");
    std::vector<std::string> files;
    std::map<std::string, std::string> common;
    for (const auto &[tag, piece] : grid)
      if (tag == "Piece")
        files.push_back(piece.get<std::string>("<xmlattr>.Source"));
    for (const auto &[tag, array] : grid.get_child("PPointData"))
      if (tag == "PDataArray")
        common[array.get<std::string>("<xmlattr>.Name")] =
            array.get<std::string>("<xmlattr>.NumberOfComponents", "1");
    EXPECT_EQ(files, (std::vector<std::string>{"solution_a.vtu", "solution_b.vtu"}));
    EXPECT_EQ(common, (std::map<std::string, std::string>{{"displacement", "3"}, {"level", "1"}}));
  }
} // namespace
