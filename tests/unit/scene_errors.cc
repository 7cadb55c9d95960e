// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene_file.h"
#include "scene_testing.h"

using namespace abut;

namespace
{
  /// A wrong override and what the message must say.
  struct WrongOverride
  {
    std::string given;
    std::string phrase;
  };

  void expect_refused(const std::vector<WrongOverride> &cases)
  {
    const SceneFile file(two_squares);
    for (const auto &[given, phrase] : cases)
    {
      SCOPED_TRACE(given);
      const std::string message = message_of([&] { file.read({given}); });
      expect_phrase(message, phrase);
      EXPECT_EQ(message.find('\n'), std::string::npos);
    }
  }

  std::string error_of_file(const std::string &text)
  {
    const SceneFile file(text);
    const std::string message = message_of([&] { file.read(); });
    EXPECT_EQ(message.rfind(file.name() + ": ", 0), 0u) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    return message;
  }
} // namespace

TEST(SceneErrors, bodies)
{
  expect_refused({
      {"Body upper/Shape=cube",
       "Body upper/Shape: received `cube`, allowed are L-shape, disc, glued parts, half disc"},
      {"Body upper/Shape=ractangle", "did you mean rectangle?"},
      {"Body upper/Shape=mesh file", "Body upper/Mesh file: received ``, the shape mesh file needs its name"},
      {"Body upper/Size=4", "Body upper/Size: received `4`, the shape rectangle needs width, height"},
      {"Body upper/Size=4, 0",
       "Body upper/Size: received `4, 0`, the shape rectangle needs width, height, above 0"},
      {"Body upper/Shape=disc", "Body upper/Size: received `1, 1`, the shape disc needs radius, above 0"},
      {"Body upper/Shape=ring", "the shape ring needs inner radius, outer radius, above 0, the inner below"},
      {"Body upper/Shape=rectangle with curved top", "Body upper/Top: `` is not a formula: it is empty"},
      {"Body upper/Top=1+x", "only the shape rectangle with curved top has one"},
      {"Body upper/Cells=0, 4",
       "Cells: received `0, 4`, allowed: 2 of these, separated by commas: a whole number from 1 to 100000"},
      {"Body upper/Grading=0, 1", "Body upper/Grading: received `0, 1`, allowed are numbers above 0"},
      {"Body upper/Scale=0", "Body upper/Scale: received `0`, allowed are numbers above 0"},
      {"Body upper/Young modulus=0", "Body upper/Young modulus: received `0`, allowed are numbers above 0"},
      {"Body upper/Young modulus=nan", "Young modulus: received `nan`, allowed: a number"},
      {"Body upper/Young modulus=1e-400", "1e-400"},
      {"Body upper/Poisson ratio=0.5",
       "received `0.5`, allowed are numbers between -1 and 0.5, both excluded"},
      {"Body upper/Poisson ratio=-1", "Body upper/Poisson ratio: received `-1`"},
      {"Body upper/Method=boundary elements",
       "Method: received `boundary elements`, allowed: finite elements"},
      {"Body upper/Degree=4", "Degree: received `4`, allowed: a whole number from 0 to 3"},
      {"Body upper/Adapt=true",
       "Body upper/Adapt: received `true`, but Adaptation/Estimator is none; allowed with it is false"},
      {"Body upper/Body force=1", "Body upper/Body force: received `1`, allowed are nothing or two formulas"},
      {"Body upper/Conditions=top: glue: 0", "Body upper/Conditions: top: received `glue`, allowed are"},
  });
}

TEST(SceneErrors, meshes_that_processes_cannot_share)
{
  const SceneFile file(two_squares);
  const std::string shared = "Body upper/Distributed mesh=true";
  file.read({shared});
  for (const std::string estimator : {"kelly", "zz", "fe-be"})
    file.read({shared, "Adaptation/Estimator=" + estimator, "Body upper/Adapt=true"});
  for (const auto &[entry, objection] : std::vector<std::pair<std::string, std::string>>{
           {"Body upper/Cell type=triangles", "Cell type = triangles"},
           {"Body upper/Nonconforming edges=mortar", "Nonconforming edges = mortar"},
           {"Body upper/Poisson ratio=0.4", "a Poisson ratio from 0.4 on"},
           {"Adaptation/Estimator=spr", "Adaptation/Estimator = spr"}})
    expect_phrase(message_of([&, with = entry] {
                    file.read({shared, with});
                  }),
                  "Body upper/Distributed mesh: received `true` with " + objection);
}

TEST(SceneErrors, shapes_that_do_not_go_together)
{
  const SceneFile file(two_squares);
  expect_phrase(message_of([&] {
                  file.read({"Body lower/Cell type=triangles", "Discretisation/Degree=3"});
                }),
                "Body lower/Degree: degree 3 refused for triangles, allowed are 1 and 2");
  expect_phrase(message_of([&] {
                  file.read({"Body lower/Shape=disc", "Body lower/Size=1", "Body lower/Grading=2, 1"});
                }),
                "Body lower/Grading: received `2, 1`, allowed are 1, 1 where the shape is not a rectangle");
  expect_phrase(message_of([&] {
                  file.read({"Body lower/Shape=ring", "Body lower/Size=2, 1"});
                }),
                "received `2, 1`, the shape ring needs");
}

TEST(SceneErrors, contacts)
{
  expect_refused({
      {"Contact interface/Slave=lower",
       "Contact interface/Slave: received `lower`, a side is written body:id"},
      {"Contact interface/Master=third:top",
       "Contact interface/Master: received the body `third`, allowed are"},
      {"Contact interface/Master=lower:top", "slave and master are the same side `lower:top`"},
      {"Contact interface/Gap=r1*x", "Contact interface/Gap: `r1*x` is not a formula"},
      {"Contact interface/Penalty=-1", "Penalty: received `-1`, allowed: a number, at least 0"},
  });
}

TEST(SceneErrors, exact_contact_with_the_scheme_neumann)
{
  const SceneFile file(two_squares);
  const std::string neumann = "Decomposition/Scheme=neumann";
  expect_phrase(
      message_of([&] { file.read({neumann}); }),
      "Contact interface/Penalty coefficient: received `0`, allowed are numbers above 0: exact contact");
  EXPECT_NO_THROW(file.read({neumann, "Contact interface/Penalty coefficient=0.05"}));
}

TEST(SceneErrors, the_other_sections)
{
  expect_refused({
      {"Tolerance=1", "Tolerance: received `1`, allowed are 0 and numbers from 1e-10 to below 1"},
      {"Discretisation/Degree=0", "Degree: received `0`, allowed: a whole number from 1 to 3"},
      {"Decomposition/Scheme=jacobi",
       "Decomposition/Scheme: received `jacobi`, allowed are conjugate, neumann, newton"},
      {"Decomposition/Relaxation=fast", "received `fast`, allowed are automatic and numbers above 0"},
      {"Decomposition/Relaxation=0", "received `0`, allowed are automatic and numbers above 0"},
      {"Decomposition/Tolerance=0",
       "Decomposition/Tolerance: received `0`, allowed are numbers between 0 and 1"},
      {"Decomposition/Maximum steps=0", "Maximum steps: received `0`, allowed: a whole number, at least 1"},
      {"Reference/Exact solution=layers sliding",
       "Reference/Approach: received `0`, the solution layers sliding"},
      {"Reference/Contact=penalised", "Reference/Contact: received `penalised` with the solution none, "
                                      "allowed with layers bonded and layers sliding only"},
      {"Reference/Contact=elastic", "Contact: received `elastic`, allowed: exact, penalised"},
      {"Constants/Values=1", "Constants: received 2 names and 1 values"},
      {"Constants/Names=r0, x", "Constants/Names: received `x`"},
      {"Constants/Names=r0, 2d", "Constants/Names: received `2d`"},
      {"Constants/Names=d, d", "Constants/Names: the name `d` is given twice"},
  });
}

TEST(SceneErrors, lists_and_sections)
{
  expect_refused({
      {"Bodies=", "Bodies: received an empty list"},
      {"Bodies=upper, lower, upper", "Bodies: the name `upper` is given twice"},
      {"Bodies=upper, lower, third", "Bodies: `third` needs a section `Body third`, there is none"},
      {"Bodies=upper, lo wer", "Bodies: received the name `lo wer`, allowed are letters"},
      {"Bodies=upper",
       "no such subsection to be entered: Body lower (sections of bodies and contacts need their"},
      {"Contacts=interface, interface", "Contacts: the name `interface` is given twice"},
      {"Contacts=interface, other", "Contact other/Slave: received ``, a side is written body:id"},
  });
}

TEST(SceneErrors, overrides)
{
  const std::string form = "allowed is Section/Sub/Name=value";
  expect_refused({
      {"Tolerance", form},
      {"=1", form},
      {"Body upper/=1", form},
      {"/Tolerance=1", form},
      {"Body upper/Cells=1, 1\nset x = 2", form},
      {"Body upper/Top=1 # no", form},
      {"Body upper/Colour=red", "override `Body upper/Colour=red`: No entry with name <Colour> was declared"},
      {"Body third/Cells=1, 1",
       "override `Body third/Cells=1, 1`: There is no such subsection to be entered"},
      {"Body upper/Cells=many",
       "override `Body upper/Cells=many`: Cells: received `many`, allowed: 2 of these"},
  });
}

TEST(SceneErrors, files)
{
  expect_phrase(message_of([] { Scene::read("does/not/exist.prm"); }),
                "Parameter file `does/not/exist.prm`: cannot be read");
  expect_phrase(message_of([] { Scene::read("/"); }), "Parameter file `/`: cannot be read");
  expect_phrase(error_of_file(""), "Bodies: received an empty list");
  expect_phrase(error_of_file(two_squares + "set Colour = red\n"), "line 18: No entry with name <Colour>");
  expect_phrase(error_of_file(two_squares + "subsection Body x\nend\n"),
                "line 18: There is no such subsection");
  expect_phrase(error_of_file(two_squares + "subsection Body upper\n"),
                "unequal numbers of 'subsection' and 'end'");
  expect_phrase(error_of_file(two_squares + "end\n"), "line 18: There is no subsection to leave here");
  expect_phrase(error_of_file("hello\n"), "line 1: The line <hello> could not be parsed");
}

TEST(SceneErrors, more_than_one_resultant)
{
  const SceneFile file(two_squares);
  EXPECT_NO_THROW(file.read({"Body upper/Conditions=top: resultant: 0, -1"}));
  expect_phrase(
      message_of([&] {
        file.read({"Body upper/Conditions=top: resultant: 0, -1",
                   "Body lower/Conditions=bottom: resultant: 1", "Decomposition/Scheme=neumann",
                   "Contact interface/Penalty coefficient=0.05"});
      }),
      "received 2 resultants, one in a scene is allowed for Decomposition/Scheme = neumann; several for "
      "conjugate and newton");
  EXPECT_NO_THROW(file.read(
      {"Body upper/Conditions=top: resultant: 0, -1", "Body lower/Conditions=bottom: resultant: 1"}));
  expect_phrase(message_of([&] {
                  file.read({"Body upper/Conditions=top: resultant: 0, -1; left: resultant: 1",
                             "Decomposition/Scheme=newton"});
                }),
                "Body upper/Conditions: received 2 resultants, one on a body is allowed");
}

TEST(SceneErrors, what_the_scheme_cannot_do)
{
  const SceneFile file(two_squares);
  for (const std::string &scheme : {std::string("newton"), std::string("conjugate")})
  {
    const std::string choice = "Decomposition/Scheme=" + scheme;
    EXPECT_NO_THROW(file.read({choice, "Contact interface/Penalty coefficient=0"}));
    expect_phrase(
        message_of([&] {
          file.read({choice, "Decomposition/Stopping rule=increment"});
        }),
        "Decomposition/Stopping rule: received `increment`, a rule for Decomposition/Scheme = neumann");
  }
}
