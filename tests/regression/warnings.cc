// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What the program says where its model or its mesh ends: each warning has a scene that triggers it and a
// neighbour that does not; both are told by the code.

#include <abut/base/warning.h>

#include <gtest/gtest.h>

#include "program.h"
#include <algorithm>
#include <filesystem>
#include <map>

using namespace abut::testing;

namespace
{
  using Overrides = std::vector<std::string>;

  /// A run of a file of the project with overrides.
  struct SceneRun
  {
    std::string file;
    Overrides overrides;
  };

  struct Neighbours
  {
    std::string code;
    SceneRun warned, quiet;
  };

  std::ostream &operator<<(std::ostream &out, const Neighbours &neighbours)
  {
    return out << neighbours.code;
  }

  Answer answer_of(const SceneRun &given)
  {
    std::vector<std::string> arguments = {
        std::filesystem::path(given.file).is_absolute() ? given.file : project_file(given.file)};
    for (const std::string &override : given.overrides)
      arguments.insert(arguments.end(), {"--set", override});
    return abut::testing::run(arguments);
  }

  bool warns(const Answer &answer, const std::string &code)
  {
    const auto codes = warning_codes(answer);
    return codes.count(code) > 0;
  }

  const std::string slide = "tests/data/cases/slide.prm", crown = "tests/data/cases/crown.prm",
                    never_touches = "tests/data/cases/never-touches.prm",
                    v_groove_slave = "tests/data/cases/v-groove-slave.prm",
                    stiff_slave = "tests/data/cases/stiff-slave.prm",
                    fine_slave = "tests/data/cases/fine-slave.prm",
                    corner_on_face = "tests/data/cases/corner-on-face-tilted.prm",
                    falling_disc = "tests/data/cases/falling-disc.prm",
                    disc_onto_block = "tests/data/cases/disc-onto-block.prm",
                    press_fit = "tests/data/cases/press-fit.prm", patch = "prm/patch-test.prm";

  /// Two layers, pressed uniformly: without a penalty the strain is half of the approach.
  SceneRun pressed(const std::string &approach)
  {
    return {patch, {"Contact interface/Penalty coefficient=0", "Constants/Values=" + approach}};
  }

  /// A block of side 10 on a base of 30, moved aside.
  SceneRun moved(const std::string &distance, const Overrides &cells = {})
  {
    Overrides overrides = cells;
    overrides.push_back("Body top/Conditions=top: displacement: " + distance + ", -0.01");
    return {slide, overrides};
  }

  /// A block between plates, a little askew: they nearly slide on each other.
  SceneRun weighing_block(const std::string &degrees)
  {
    return {"prm/disc-between-plates.prm",
            {"Body disc/Shape=rectangle", "Body disc/Size=2, 2", "Body disc/Shift=-1, -1",
             "Body disc/Body force=0, -1", "Body disc/Rotation angle=" + degrees,
             "Body upper/Conditions=top: displacement: 0, 0", "Contact below/Master=disc:bottom",
             "Contact above/Master=disc:top"}};
  }

  /// A disc in a hole of radius 10.02 with the same centre: it falls by the difference of the radii.
  SceneRun fallen(const std::string &radius)
  {
    return {falling_disc, {"Body disc/Size=" + radius}};
  }

  const std::string rollers = "left: normal displacement: 0; bottom: normal displacement: 0";
  const Overrides fine_cells = {"Body top/Cells=40, 10", "Body base/Cells=60, 20"}, // cells of 1/4 and 1/2
      finer_cells = {"Body top/Cells=160, 10", "Body base/Cells=240, 20"},          // of 1/16 and 1/8
      coarse_cells = {"Body top/Cells=5, 5", "Body base/Cells=10, 5"};              // of 2 and 3

  const std::vector<Neighbours> all_neighbours = {
      {"large-strain", pressed("0.101"), pressed("0.099")},
      {"large-overlap",
       {patch, {"Contact interface/Gap=-0.0201"}},
       {patch, {"Contact interface/Gap=-0.0199"}}},
      {"sideways-displacement", moved("0.55", fine_cells), moved("0.45", fine_cells)}, // a cell
      {"sideways-displacement", moved("1.1", coarse_cells),
       moved("0.9", coarse_cells)}, // a tenth of the side
      {"sideways-displacement", moved("0.22", finer_cells), moved("0.18", finer_cells)}, // a fiftieth
      {"side-leaves-master", moved("20.5"), moved("19.5")},
      {"side-leaves-master", moved("-0.3"), moved("-0.2")}, // beyond the middle of the last part
      {"facets",
       {press_fit, {"Body ring/Boundary curve=as meshed", "Contact fit/Gap=geometry"}},
       {press_fit, {"Body ring/Boundary curve=as meshed", "Contact fit/Gap=-0.0025"}}},
      {"coarse-curve",
       {press_fit, {"Body ring/Corner angle=3.9"}},
       {press_fit, {"Body ring/Corner angle=4"}}},
      {"coarse-data",
       {patch, {"Body upper/Conditions=left: normal displacement: 0; top: pressure: 1 + sin(8*pi*x)"}},
       {patch, {"Body upper/Conditions=left: normal displacement: 0; top: pressure: 1 + sin(pi*x)"}}},
      {"nothing-touches", {never_touches, {}}, {never_touches, {"Body steel/Shift=0, 20"}}},
      {"narrow-contact",
       {v_groove_slave, {}},
       {v_groove_slave,
        {"Body disc/Young modulus=1e3", "Body left/Young modulus=1e3", "Body right/Young modulus=1e3",
         "Body disc/Body force=3, -3"}}},
      {"rough-pressure", {fine_slave, {"Contact c/Multipliers=slave"}}, {fine_slave, {}}}, // twice as fine
      {"rough-pressure", {stiff_slave, {"Contact interface/Multipliers=slave"}}, {stiff_slave, {}}},
      {"singular-stress",
       {"prm/corner.prm", {"Adaptation/Maximum passes=1"}},
       {patch,
        {"Body lower/Conditions=bottom: displacement: 0, 0", "Body lower/Poisson ratio=0",
         "Body upper/Poisson ratio=0"}}},
      {"missed-contact",
       {corner_on_face, {}},
       {corner_on_face, {"Body punch/Cells=160, 160", "Body block/Cells=240, 80"}}},
      {"dropped-load", weighing_block("0.005"), weighing_block("0")},
      {"load-on-support",
       {patch, {"Body lower/Conditions=" + rollers + "; bottom: pressure: 3"}},
       {patch, {"Body lower/Conditions=" + rollers + "; bottom: traction: 3e-3, 0"}}},
      {"unused-parameter",
       {patch, {"Decomposition/Scheme=newton", "Decomposition/Relaxation=0.5"}},
       {patch, {"Decomposition/Scheme=neumann", "Decomposition/Relaxation=0.05"}}},
      {"estimator-sees-a-part",
       {"prm/corner.prm",
        {"Adaptation/Estimator=fe-be", "Adaptation/Maximum passes=1",
         "Adaptation/Boundary solution=constant traction"}},
       {"prm/corner.prm", {"Adaptation/Estimator=fe-be", "Adaptation/Maximum passes=1"}}},
      {"rough-estimator",
       {patch, {"Adaptation/Estimator=zz", "Discretisation/Degree=2"}},
       {patch, {"Adaptation/Estimator=kelly", "Discretisation/Degree=2"}}},
      {"rough-estimator",
       {patch, {"Adaptation/Estimator=spr", "Discretisation/Degree=3"}},
       {patch, {"Adaptation/Estimator=spr", "Discretisation/Degree=1"}}},
      {"far-motion", fallen("8"), fallen("9.9")},
      {"far-motion", fallen("9.5"), {disc_onto_block, {}}},
      {"far-motion", fallen("9"), {falling_disc, {"Body disc/Size=9", "Body disc/Shift=0, -1.02"}}},
      {"default-material",
       {"tests/data/cases/corner-on-face.prm", {"Body block/Young modulus=2.1e5"}},
       {"tests/data/cases/corner-on-face.prm", {}}},
      {"point-support", {disc_onto_block, {"Body disc/Body force=1, -10"}}, {disc_onto_block, {}}},
      {"singular-pressure",
       {never_touches, {"Body steel/Shift=0, 20"}},
       {never_touches, {"Body steel/Shift=0, 20", "Body nylon/Size=10, 20", "Body nylon/Cells=15, 30"}}},
      // A plane of symmetry of the steel alone is an edge to the nylon, unless its own is a little off.
      {"singular-pressure",
       {never_touches,
        {"Body steel/Shift=0, 20", "Body nylon/Size=20, 20", "Body nylon/Shift=-10, 0",
         "Body nylon/Cells=30, 30"}},
       {never_touches,
        {"Body steel/Shift=0, 20", "Body nylon/Size=10.001, 20", "Body nylon/Shift=-0.001, 0",
         "Body nylon/Cells=15, 30"}}},
      // Contact up to the edges, though the largest pressure stands between them, and contact that ends
      // before.
      {"singular-pressure",
       {crown, {"Body crown/Conditions=bottom: displacement: 0, 0.06"}},
       {crown, {"Body crown/Conditions=bottom: displacement: 0, 0.03"}}},
      // theta = .01 c takes its share of .0182 + theta.
      {"soft-penalty",
       {patch, {"Contact interface/Penalty coefficient=0.203"}},
       {patch, {"Contact interface/Penalty coefficient=0.202"}}},
      {"lost-volume", {disc_onto_block, {"Body disc/Cells=4, 4"}}, {disc_onto_block, {}}},
      {"lost-volume",
       {disc_onto_block, {"Body disc/Cells=4, 4"}},
       {disc_onto_block, {"Body disc/Cells=4, 4", "Body disc/Degree=2"}}}};

  class Warned : public ::testing::TestWithParam<Neighbours>
  {};

  TEST_P(Warned, AndItsNeighbourIsNot)
  {
    const Answer warned = answer_of(GetParam().warned), quiet = answer_of(GetParam().quiet);
    ASSERT_EQ(warned.status, 0) << warned.err;
    ASSERT_EQ(quiet.status, 0) << quiet.err;
    EXPECT_TRUE(warns(warned, GetParam().code)) << warned.err;
    EXPECT_FALSE(warns(quiet, GetParam().code)) << quiet.err;
  }

  INSTANTIATE_TEST_SUITE_P(Codes, Warned, ::testing::ValuesIn(all_neighbours), [](const auto &parameter) {
    std::string name = parameter.param.code;
    std::replace(name.begin(), name.end(), '-', '_');
    return name + "_" + std::to_string(parameter.index);
  });

  TEST(Warnings, APressureInMegapascalsForPascals)
  {
    const auto pressed_by = [](const std::string &pressure) {
      return warning_codes(answer_of(
          SceneRun{patch,
                   {"Body lower/Conditions=" + rollers, "Body upper/Young modulus=2.1e5",
                    "Body lower/Young modulus=2.1e5",
                    "Body upper/Conditions=left: normal displacement: 0; top: pressure: " + pressure}}));
    };
    EXPECT_EQ(pressed_by("100"), std::multiset<std::string>{});
    EXPECT_EQ(pressed_by("1e8"), (std::multiset<std::string>{"large-strain", "large-strain"}));
  }

  TEST(Warnings, AParameterThatIsSetTwice)
  {
    const std::string once = read_file(project_file(patch));
    const std::string size = "  set Shift         = 0, 1\n";
    std::string twice = once;
    twice.insert(twice.find(size), "  set  Size = 2, 1 # too wide\n");
    ASSERT_EQ(warning_codes(answer_of(SceneRun{temporary_file("once.prm", once), {}})).size(), 0u);
    const Answer answer = answer_of(SceneRun{temporary_file("twice.prm", twice), {}});
    // The edge of the lower block presses into the upper one, which has become wider.
    EXPECT_EQ(warning_codes(answer), (std::multiset<std::string>{"repeated-parameter", "singular-pressure"}));
  }

  TEST(Warnings, TheInputIsCheckedBeforeAnythingIsSolved)
  {
    const auto check = [](const std::string &gap) {
      return abut::testing::run({project_file(patch), "--check", "--set", "Contact interface/Gap=" + gap});
    };
    EXPECT_NE(check("-0.03").err.find("large-overlap"), std::string::npos);
    EXPECT_EQ(check("0").err, "");
  }

  /// A peak at a reentrant corner, and one at the edge of a punch: those scenes are about them.
  const std::map<std::string, std::multiset<std::string>> meant = {{"corner", {"singular-stress"}},
                                                                   {"flat-punch", {"singular-stress"}}};

  TEST(Warnings, NoFalseAlarmInTheProjectsScenes)
  {
    std::size_t n_scenes = 0;
    for (const auto &entry : std::filesystem::directory_iterator(project_file("prm")))
    {
      const std::string scene = entry.path().stem().string();
      const Answer answer = run_scene(scene);
      ASSERT_EQ(answer.status, 0) << answer.err;
      const auto allowed = meant.find(scene);
      EXPECT_EQ(warning_codes(answer),
                allowed == meant.end() ? std::multiset<std::string>{} : allowed->second)
          << answer.err;
      ++n_scenes;
    }
    EXPECT_GE(n_scenes, 17u);
  }

  TEST(Warnings, TheDocumentationListsEveryCode)
  {
    const std::string page = read_file(project_file("doc/warnings.md"));
    for (const abut::WarningCode code : abut::all_warning_codes())
      EXPECT_NE(page.find("`" + to_string(code) + "`"), std::string::npos) << to_string(code);
  }

  TEST(Warnings, EveryCodeHasItsNeighbours)
  {
    // hidden-pair: contact_shapes.cc; repeated-parameter: above; of files: mesh_files.cc; then
    // unpaired_bodies.cc, coarse_mesh.cc, resume.cc, gap_within_cells.cc, output_points.cc; tests/mpi.
    std::set<std::string> tested = {"hidden-pair",  "repeated-parameter", "cells-cut",
                                    "one-material", "unpaired-overlap",   "body-without-contact",
                                    "coarse-mesh",  "idle-processes",     "checkpoint-not-saved",
                                    "coarse-gap",   "between-materials"};
    for (const Neighbours &neighbours : all_neighbours)
      tested.insert(neighbours.code);
    for (const abut::WarningCode code : abut::all_warning_codes())
      EXPECT_EQ(tested.count(to_string(code)), 1u) << to_string(code);
    EXPECT_EQ(tested.size(), abut::all_warning_codes().size());
  }
} // namespace
