// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene_file.h"
#include "scene_testing.h"
#include <regex>
#include <sstream>

using namespace abut;

TEST(Scene, reads_the_scenes_that_come_with_the_program)
{
  const std::string folder = ABUT_SOURCE_DIR "/prm/";
  for (const std::string name : {"two-layers", "two-layers-rollers", "two-layers-bonded"})
  {
    const Scene scene = Scene::read(folder + name + ".prm");
    ASSERT_EQ(scene.bodies.size(), 2u);
    EXPECT_EQ(scene.bodies[0].name, "upper");
    EXPECT_EQ(scene.contacts.at(0).slave.body, "lower");
    EXPECT_EQ(scene.output_directory, "results/" + name);
  }
}

TEST(Scene, says_what_the_paper_says)
{
  const Scene scene = Scene::read(ABUT_SOURCE_DIR "/prm/two-layers.prm");
  const auto &upper = scene.bodies[scene.body_index("upper")];
  EXPECT_EQ(upper.size, (std::vector<double>{4., 1.}));
  EXPECT_EQ(upper.placement.point_to_world({0., 0.}), Vector2(0., 1.));
  EXPECT_EQ(upper.young_modulus, 2.1e5);
  EXPECT_EQ(upper.poisson_ratio, 0.3);
  EXPECT_EQ(upper.cells, (std::array<unsigned int, 2>{{64, 16}}));
  EXPECT_EQ(upper.cell_type, CellType::quadrilaterals);
  EXPECT_EQ(upper.degree, 1u);
  ASSERT_EQ(upper.conditions.size(), 2u);
  EXPECT_EQ(upper.conditions[1].expressions[0]({1., 1.}), -1.366e-3);
  EXPECT_FALSE(upper.contact_depth);
  const auto &contact = scene.contacts.at(0);
  EXPECT_EQ((*contact.gap)({2., 0.}), 4e-3);
  EXPECT_EQ(contact.penalty_coefficient, 0.05);
  EXPECT_FALSE(contact.penalty);
  EXPECT_EQ(scene.decomposition.initial_guess, InitialGuess::elastic_layer);
  EXPECT_EQ(scene.decomposition.relaxation, 0.02);
  EXPECT_EQ(scene.decomposition.stopping_rule, StoppingRule::increment);
  EXPECT_EQ(scene.decomposition.tolerance, 0.0015);
}

TEST(Scene, reads_constants_in_the_reference)
{
  const Scene scene =
      Scene::read(ABUT_SOURCE_DIR "/prm/two-layers-rollers.prm", {"Constants/Values = 2e-3, 1e-3"});
  EXPECT_EQ(scene.reference.solution, "layers sliding");
  EXPECT_EQ(scene.reference.datum("Gap curvature"), 2e-3);
  EXPECT_EQ(scene.reference.datum("Approach"), 1e-3);
  EXPECT_EQ(scene.reference.contact, ReferenceParameters::Contact::exact);
  EXPECT_FALSE(scene.decomposition.relaxation);
}

TEST(Scene, reads_the_contact_law_of_the_reference)
{
  for (const std::string solution : {"layers sliding", "layers bonded"})
  {
    const Scene scene = Scene::read(ABUT_SOURCE_DIR "/prm/two-layers-rollers.prm",
                                    {"Reference/Exact solution=" + solution, "Reference/Contact=penalised"});
    EXPECT_EQ(scene.reference.contact, ReferenceParameters::Contact::penalised);
  }
}

TEST(Scene, overrides_follow_the_file_in_their_order)
{
  const SceneFile file(two_squares);
  const Scene scene = file.read({"Body upper/Cells=4, 2", "Decomposition/Relaxation=0.1",
                                 "Contact interface/Gap=if(x==1,d,r0)", "Body upper/Cells = 6, 3",
                                 "Constants/Values=1, 5", "Output/Directory=elsewhere", "Tolerance=0"});
  EXPECT_EQ(scene.bodies[0].cells, (std::array<unsigned int, 2>{{6, 3}}));
  EXPECT_EQ(scene.decomposition.relaxation, 0.1);
  EXPECT_EQ((*scene.contacts[0].gap)({1., 0.}), 5.);
  EXPECT_EQ(scene.output_directory, "elsewhere");
}

TEST(Scene, overrides_may_change_the_lists)
{
  const Scene scene = SceneFile(two_squares).read({"Bodies=upper, lower, third", "Body third/Size=3, 4"});
  ASSERT_EQ(scene.bodies.size(), 3u);
  EXPECT_EQ(scene.bodies[2].size[1], 4.);
}

TEST(Scene, one_body_without_contact_is_a_scene)
{
  const Scene scene = SceneFile("set Bodies = a\nsubsection Body a\nend").read();
  EXPECT_EQ(scene.bodies.size(), 1u);
  EXPECT_TRUE(scene.contacts.empty());
}

TEST(Scene, reads_files_of_other_systems)
{
  std::string text = "set Bodies = a\nsubsection Body a\n"
                     "set Conditions = left: pressure: 1; \\\n right: pressure: 2 # last\nend";
  const auto n_conditions = [&] { return SceneFile(text).read().bodies[0].conditions.size(); };
  EXPECT_EQ(n_conditions(), 2u);
  text = std::regex_replace(text, std::regex("\n"), "\r\n");
  EXPECT_EQ(n_conditions(), 2u);
}

TEST(Scene, degrees_come_from_the_body_or_from_all)
{
  const Scene scene = SceneFile(two_squares).read({"Discretisation/Degree=2", "Body lower/Degree=3"});
  EXPECT_EQ(scene.bodies[0].degree, 2u);
  EXPECT_EQ(scene.bodies[1].degree, 3u);
}

TEST(Scene, mesh_files_lie_beside_the_parameter_file)
{
  const SceneFile file(two_squares);
  const auto body = file.read({"Body upper/Mesh file=meshes/gear.msh"}).bodies[0];
  EXPECT_EQ(body.shape, "mesh file");
  EXPECT_EQ(body.mesh_file, "meshes/gear.msh");
  EXPECT_EQ(body.mesh_path, file.directory() + "/meshes/gear.msh");
}

TEST(Scene, optional_entries_have_a_value_once_they_are_set)
{
  const Scene scene =
      SceneFile(two_squares)
          .read({"Body upper/Contact depth=0.5", "Body upper/Body force=0, -9.81*y",
                 "Body upper/Shape=rectangle with curved top", "Body upper/Top=1+x^2",
                 "Contact interface/Penalty=1e-7", "Contact interface/Penalty coefficient=0"});
  const auto &body = scene.bodies[0];
  EXPECT_EQ(body.contact_depth, 0.5);
  EXPECT_EQ(body.body_force.at(1)({0., 2.}), -19.62);
  EXPECT_EQ((*body.top)({2., 0.}), 5.);
  EXPECT_EQ(scene.contacts[0].penalty, 1e-7);
  EXPECT_FALSE(scene.contacts[0].gap);
}

TEST(Scene, its_parameters_read_again_are_the_same)
{
  const Scene first = SceneFile(two_squares)
                          .read({"Body upper/Mesh file=gear.msh", "Body lower/Rotation angle=30",
                                 "Contact interface/Gap=if(x<1, r0, d)", "Decomposition/Tolerance=1e-3"});
  const Scene second = SceneFile(first.parameters).read();
  EXPECT_EQ(second.parameters, first.parameters);
  EXPECT_EQ(second.output_directory, first.output_directory);
  EXPECT_EQ(second.bodies[0].mesh_path, first.bodies[0].mesh_path);
  EXPECT_EQ(second.bodies[1].placement.direction_to_world({1., 0.}),
            first.bodies[1].placement.direction_to_world({1., 0.}));
  EXPECT_EQ((*second.contacts[0].gap)({2., 0.}), 2.);
  EXPECT_EQ(second.decomposition.tolerance, 1e-3);
}

TEST(Scene, its_input_read_again_is_the_same_from_any_folder)
{
  const SceneFile file(two_squares);
  const std::filesystem::path before = std::filesystem::current_path();
  const auto in_folder = [&](const std::string &folder, const auto &read) {
    std::filesystem::current_path(folder);
    const Scene scene = read();
    std::filesystem::current_path(before);
    return scene;
  };
  // By a name that means another file elsewhere.
  const Scene first = in_folder(file.directory(), [] {
    return Scene::read("scene.prm", {"Body upper/Mesh file=gear.msh", "Body upper/Adapt=true",
                                     "Adaptation/Estimator=zz", "Output/Checkpoint=every pass"});
  });
  Bytes bytes = packed(first.input);
  SceneInput input;
  unpack(bytes, input);
  const auto again = [&] { return Scene::read(input); };
  const Scene here = in_folder(file.directory(), again), elsewhere = in_folder("/", again);
  EXPECT_EQ(here.parameters, first.parameters);
  EXPECT_EQ(here.mesh_files(), std::vector<std::string>{"gear.msh"});
  EXPECT_EQ(elsewhere.parameters, first.parameters);
  EXPECT_EQ(elsewhere.mesh_files(), std::vector<std::string>{file.directory() + "/gear.msh"});
  EXPECT_EQ(elsewhere.file, "scene.prm");
  EXPECT_EQ(elsewhere.checkpoints, CheckpointTimes::every_pass);
}

TEST(Scene, prints_every_parameter_with_its_documentation)
{
  std::ostringstream text;
  Scene::print_parameters(text);
  for (const std::string phrase :
       {"set Bodies", "set Tolerance", "subsection Body <name>", "set Young modulus",
        "subsection Contact <name>", "set Penalty coefficient", "subsection Decomposition",
        "set Exact solution", "# E, above 0. Stress."})
    expect_phrase(text.str(), phrase);
}
