// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Wrong parameter files, command lines and meshes: one clear sentence, status 1, nothing written.

#include <gtest/gtest.h>

#include "program.h"

namespace
{
  using abut::testing::Answer;
  using abut::testing::expect_refused;
  using abut::testing::project_file;
  using abut::testing::run;
  using abut::testing::run_scene;
  using abut::testing::temporary_file;

  const std::string good_file = R"(
set Bodies = upper, lower
set Contacts = interface
subsection Body upper
  set Shape = rectangle
  set Size = 4, 1
  set Shift = 0, 1
  set Cells = 8, 2
  set Conditions = left: normal displacement: 0; top: displacement y: -1e-3
end
subsection Body lower
  set Shape = rectangle
  set Size = 4, 1
  set Cells = 8, 2
  set Conditions = left: normal displacement: 0; bottom: normal displacement: 0
end
subsection Contact interface
  set Slave = lower:top
  set Master = upper:bottom
end
)";

  /// A mistake: a text of the good file and what stands there instead, or options of the command line.
  struct Mistake
  {
    std::string name;
    std::string text, instead;
    std::vector<std::string> options;
    std::vector<std::string> expected; ///< what the message must contain
  };

  std::ostream &operator<<(std::ostream &out, const Mistake &mistake)
  {
    return out << mistake.name;
  }

  const std::string lower_supports = "left: normal displacement: 0; bottom: normal displacement: 0";

  const std::vector<Mistake> mistakes = {
      {"unknown_parameter", "set Shape = rectangle", "set Form = rectangle", {}, {"Form", "scene.prm"}},
      {"unknown_section",
       "subsection Contact interface",
       "subsection Contakt interface",
       {},
       {"Contakt interface"}},
      {"word_for_number", "set Size = 4, 1", "set Size = 4, tall", {}, {"Size", "tall"}},
      {"negative_size", "set Size = 4, 1", "set Size = 4, -1", {}, {"Size", "-1"}},
      {"missing_size", "set Size = 4, 1", "set Size = 4", {}, {"Size", "needs"}},
      {"unknown_shape",
       "set Shape = rectangle",
       "set Shape = square",
       {},
       {"Shape", "square", "quarter ring"}},
      {"no_cells", "set Cells = 8, 2", "set Cells = 0, 2", {}, {"Cells", "0"}},
      {"incompressible", "set Shape = rectangle", "set Poisson ratio = 0.5", {}, {"Poisson ratio", "0.5"}},
      {"no_stiffness", "set Shape = rectangle", "set Young modulus = 0", {}, {"Young modulus", "0"}},
      {"unknown_side",
       "left: normal displacement: 0; top",
       "front: normal displacement: 0; top",
       {},
       {"front", "left", "right", "bottom", "top"}},
      {"unknown_kind",
       lower_supports,
       "left: glue: 0; bottom: normal displacement: 0",
       {},
       {"glue", "normal displacement"}},
      {"too_few_expressions",
       lower_supports,
       "left: displacement: 0; bottom: normal displacement: 0",
       {},
       {"`displacement` needs two expressions"}},
      {"bad_formula", "-1e-3", "-1e-3*(x", {}, {"Body upper", "-1e-3*(x"}},
      {"unknown_constant", "-1e-3", "-approach", {}, {"Body upper", "approach"}},
      {"formula_without_value", "-1e-3", "log(x - 5)", {}, {"Body upper", "log(x - 5)"}},
      {"contradiction_at_a_corner",
       "top: displacement y: -1e-3",
       "left: displacement y: 1e-3; top: displacement y: -1e-3",
       {},
       {"Body upper", "contradict", "(0, 2)"}},
      {"held_by_nothing", "set Contacts = interface", "set Contacts =", {}, {"interface"}},
      {"held_by_contact_alone",
       "; top: displacement y: -1e-3",
       "",
       {"--set", "Decomposition/Scheme=neumann", "--set", "Contact interface/Penalty coefficient=0.05"},
       {"Body upper", "contact alone", "translation along (0, 1)"}},
      {"free_to_slide",
       lower_supports,
       "bottom: normal displacement: 0",
       {"--set", "Decomposition/Scheme=neumann", "--set", "Contact interface/Penalty coefficient=0.05"},
       {"Body lower", "translation along (1, 0)"}},
      {"contact_with_unknown_side",
       "set Slave = lower:top",
       "set Slave = lower:roof",
       {},
       {"lower", "roof", "top"}},
      {"contact_with_unknown_body", "set Slave = lower:top", "set Slave = cellar:top", {}, {"cellar"}},
      {"slave_is_master", "set Slave = lower:top", "set Slave = upper:bottom", {}, {"interface"}},
      {"sides_that_do_not_face",
       "set Slave = lower:top",
       "set Slave = lower:bottom",
       {},
       {"interface", "faces"}},
      {"exact_contact",
       "set Slave = lower:top",
       "set Penalty coefficient = 0\n  set Slave = lower:top",
       {"--set", "Decomposition/Scheme=neumann"},
       {"Penalty coefficient", "0"}},
      {"unknown_body_in_list",
       "set Bodies = upper, lower",
       "set Bodies = upper, lower, middle",
       {},
       {"middle"}},
      {"no_bodies", "set Bodies = upper, lower", "set Bodies =", {}, {"Bodies"}},
      {"triangles_of_degree_three",
       "set Cells = 8, 2",
       "set Cells = 8, 2\n  set Cell type = triangles\n  set Degree = 3",
       {},
       {"riangles", "3"}},
      {"degree_four",
       "set Bodies = upper, lower",
       "set Bodies = upper, lower\nsubsection Discretisation\n set Degree = 4\nend",
       {},
       {"Degree", "4"}},
      {"tolerance_of_all",
       "set Bodies = upper, lower",
       "set Bodies = upper, lower\nset Tolerance = 1",
       {},
       {"Tolerance", "`1`", "below 1"}},
      {"point_off_the_mesh",
       lower_supports,
       "(0.1, 0.3): displacement: 0, 0; bottom: normal displacement: 0",
       {},
       {"(0.1, 0.3)", "nearest"}},
      {"missing_mesh_file", "set Shape = rectangle", "set Mesh file = nowhere.msh", {}, {"nowhere.msh"}},
      {"two_resultants",
       lower_supports,
       "left: normal displacement: 0; bottom: resultant: 1; top: resultant: 1",
       {},
       {"resultant"}},
      {"wrong_reference",
       "set Contacts = interface",
       "set Contacts = interface\nsubsection Reference\n set Exact solution = layers sliding\n set Approach "
       "= 1e-3\n set Gap curvature = 1e-3\nend",
       {},
       {"layers sliding", "roller"}},
      {"tolerance_of_everything",
       "set Bodies = upper, lower",
       "set Bodies = upper, lower\nsubsection Decomposition\n set Tolerance = 2\nend",
       {},
       {"Decomposition/Tolerance", "`2`"}},
      {"same_pair_twice",
       "set Contacts = interface",
       "set Contacts = interface, again\nsubsection Contact again\n set Slave = upper:bottom\n set Master = "
       "lower:top\nend",
       {},
       {"again", "interface", "one contact only"}},
      {"load_beside_a_resultant",
       "top: displacement y: -1e-3",
       "top: resultant: -1; top: traction: 0, -5",
       {},
       {"Body upper", "top", "traction", "resultant"}},
      {"gap_far_from_the_geometry",
       "set Master = upper:bottom",
       "set Master = upper:bottom\n  set Gap = 20",
       {},
       {"Contact interface/Gap", "20", "check the bodies' places"}},
      {"load_without_value",
       "top: displacement y: -1e-3",
       "top: displacement y: -1e-3; right: pressure: sqrt(x - 5)",
       {},
       {"Body upper", "sqrt(x - 5)"}},
      {"override_of_nothing", "", "", {"--set", "Body upper/Colour=red"}, {"Colour"}},
      {"override_without_value", "", "", {"--set", "Body upper/Size"}, {"Body upper/Size", "="}},
      {"override_with_wrong_value", "", "", {"--set", "Decomposition/Relaxation=-1"}, {"Relaxation", "-1"}},
      {"unknown_option", "", "", {"--fast"}, {"--fast", "--help"}},
      {"two_files", "", "", {"second.prm"}, {"second.prm"}}};

  Answer run_with(const Mistake &mistake)
  {
    std::string content = good_file;
    if (!mistake.text.empty())
    {
      const auto position = content.find(mistake.text);
      EXPECT_NE(position, std::string::npos) << mistake.name;
      content.replace(position, mistake.text.size(), mistake.instead);
    }
    std::vector<std::string> arguments = {temporary_file("scene.prm", content)};
    arguments.insert(arguments.end(), mistake.options.begin(), mistake.options.end());
    return run(arguments);
  }

  class WrongInput : public ::testing::TestWithParam<Mistake>
  {};

  TEST_P(WrongInput, IsRefusedInOneSentence)
  {
    const Answer answer = run_with(GetParam());
    expect_refused(answer, GetParam().expected);
    std::cout << answer.err;
  }

  INSTANTIATE_TEST_SUITE_P(Mistakes, WrongInput, ::testing::ValuesIn(mistakes),
                           [](const auto &parameter) { return parameter.param.name; });

  TEST(WrongInput, TheGoodFileIsAccepted)
  {
    const Answer answer = run_with({"good", "", "", {}, {}});
    EXPECT_EQ(answer.status, 0) << answer.err;
    EXPECT_EQ(answer.summary["status"], "converged");
  }

  TEST(WrongInput, NoFile)
  {
    expect_refused(run({}), {"FILE.prm"});
  }

  TEST(WrongInput, MissingFile)
  {
    expect_refused(run({"nowhere.prm"}), {"nowhere.prm"});
  }

  TEST(WrongInput, ChordsForTheGapOfCurves)
  {
    expect_refused(run_scene("shrink-fit", {"Body disc/Cell type=triangles"}),
                   {"geometry", "disc", "chords"});
  }

  TEST(WrongInput, TrianglesOfDegreeThreeFromAFile)
  {
    expect_refused(run({temporary_file("scene.prm", good_file), "--set", "Body lower/Degree=3", "--set",
                        "Body lower/Mesh file=" + project_file("tests/data/triangles_4_1.msh")}),
                   {"Body lower", "degree 3", "triangles"});
  }

  TEST(WrongInput, MeshFileOfAnotherKind)
  {
    const std::string mesh = project_file("CMakeLists.txt");
    expect_refused(
        run({temporary_file("scene.prm", good_file), "--set", "Body lower/Mesh file=" + mesh}),
        {"Body lower/Mesh file", "received a file with the ending `.txt`", "allowed are .msh, .geo"});
  }

  TEST(WrongInput, BodyWithNeitherSupportNorContact)
  {
    expect_refused(
        run({temporary_file("scene.prm", "set Bodies = stone\nsubsection Body stone\n  set Shape = disc\n"
                                         "  set Size = 1\n  set Cells = 4, 2\nend\n")}),
        {"Body stone", "held by nothing"});
  }

  TEST(WrongInput, OutputFolderIsAFile)
  {
    const std::string file = temporary_file("results", "precious");
    const Answer answer = run({temporary_file("scene.prm", good_file), "--set", "Output/Directory=" + file});
    // `--output` of the test's own comes later and wins: the folder in the file is not touched.
    EXPECT_EQ(answer.status, 0) << answer.err;
    EXPECT_EQ(abut::testing::read_file(file), "precious");
  }

  TEST(WrongInput, CheckRefusesTheSame)
  {
    const Answer answer = run({temporary_file("scene.prm", good_file), "--check", "--set",
                               "Body upper/Conditions=left: normal displacement: 0; top: traction: 0, 1"});
    EXPECT_EQ(answer.status, 1);
    EXPECT_NE(answer.out.find("rigid motions left free: translation along (0, 1)"), std::string::npos)
        << answer.out;
  }
} // namespace
