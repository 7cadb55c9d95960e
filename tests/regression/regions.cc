// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Bodies of several materials.
#include <gtest/gtest.h>

#include "gmsh_files.h"
#include "program.h"
#include <cmath>

using namespace abut::testing;

TEST(Regions, RegionsOfOtherMaterials)
{
  // Two layers on each other under uniform strain (rollers at the sides): sigma_yy is the same in both, the
  // thickness H_a/M_a with M = E (1 - nu)/((1 + nu)(1 - 2 nu)) gives. A third body presses on top.
  const std::string layers =
      "SetFactory(\"OpenCASCADE\");\nRectangle(1) = {0, 0, 0, 2, 1};\n"
      "Rectangle(2) = {0, 1, 0, 2, 0.5};\nBooleanFragments{ Surface{1}; Delete; }{ Surface{2}; Delete; }\n"
      "Physical Surface(\"base\", 7) = {1}; Physical Surface(\"lining\", 8) = {2};\n"
      "left() = Curve In BoundingBox {-.1, -.1, -.1, .1, 2, .1};\n"
      "right() = Curve In BoundingBox {1.9, -.1, -.1, 2.1, 2, .1};\n"
      "low() = Curve In BoundingBox {-.1, -.1, -.1, 2.1, .1, .1};\n"
      "top() = Curve In BoundingBox {-.1, 1.4, -.1, 2.1, 1.6, .1};\n"
      "Physical Curve(\"sides\") = {left(), right()}; Physical Curve(\"low\") = {low()};\n"
      "Physical Curve(\"top\") = {top()}; MeshSize{ PointsOf{ Surface{:}; } } = .4;\n";
  const auto scene = [&](const std::string &regions) {
    return "set Bodies = stack, punch\nset Contacts = c\nset Materials = steel, rubber\n"
           "subsection Material steel\n set Young modulus = 200\nend\n"
           "subsection Material rubber\n set Young modulus = 3\n set Poisson ratio = 0.25\nend\n"
           "subsection Body stack\n set Mesh file = " +
           temporary_file("layers.geo", layers) + "\n set Regions = " + regions +
           "\n set Conditions = sides: normal displacement: 0; low: displacement y: 0\nend\n"
           "subsection Body punch\n set Size = 2, 1\n set Shift = 0, 1.5\n set Cells = 3, 2\n"
           " set Young modulus = 50\n set Conditions = left: normal displacement: 0; right: normal "
           "displacement: 0;"
           " top: displacement y: -0.01\nend\n"
           "subsection Contact c\n set Slave = punch:bottom\n set Master = stack:top\nend\n";
  };
  const auto modulus = [](const double e, const double nu) {
    return e * (1. - nu) / ((1. + nu) * (1. - 2. * nu));
  };
  const double pressure = .01 / (1. / modulus(200., .3) + .5 / modulus(3., .25) + 1. / modulus(50., .3));
  for (const std::string type : {"quadrilaterals", "triangles"})
    for (const int p : {1, 2})
    {
      const Answer answer =
          run_text(scene("base: steel; 8: rubber"),
                   {"Discretisation/Degree=" + std::to_string(p), "Body stack/Cell type=" + type,
                    "Body stack/Adapt=true", "Adaptation/Estimator=kelly", "Adaptation/Maximum passes=2"});
      ASSERT_EQ(answer.status, 0) << answer.err;
      EXPECT_EQ(answer.err, "");
      EXPECT_NEAR(contact(answer, "c")["max_pressure"].get<double>(), pressure, 1e-9 * pressure);
      EXPECT_NEAR(contact(answer, "c")["normal_force"].get<double>(), 2. * pressure, 1e-9 * pressure);
      // Nothing to estimate: the stress is piecewise uniform.
      EXPECT_LT(answer.summary["error"]["total"].get<double>(), 1e-7);
    }
  expect_refused(run_text(scene("base: steel"), {"Body stack/Adapt=true", "Adaptation/Estimator=fe-be"}),
                 {"Body stack: it has Regions of other materials", "fe-be", "allowed are kelly, zz, spr"});
  // The others see no error in a stress that is uniform in each material.
  for (const std::string estimator : {"kelly", "zz", "spr"})
  {
    const Answer answer =
        run_text(scene("base: steel"), {"Body stack/Adapt=true", "Adaptation/Estimator=" + estimator});
    EXPECT_LT(answer.summary["error"]["discretisation"].get<double>(), 1e-9) << estimator;
  }
  expect_refused(run_text(scene("core: steel")), {"no region `core`", "7 (base), 8 (lining)"});
  expect_refused(run_text(scene("base: gold")), {"Body stack/Regions", "base: gold", "list Materials"});
  expect_refused(run_text(scene("base: steel; base: rubber")), {"`base` is given twice"});
}

TEST(Regions, ARoundInterfaceBetweenMaterialsIsFollowed)
{
  // A stiff core of radius 1 in a soft lining of radius 2 under u = -1e-3 (x, y) at the rim: Lame with
  // displacement and radial stress continuous at radius 1 gives the energy.
  const std::string core =
      "SetFactory(\"OpenCASCADE\");\nDisk(1) = {0, 0, 0, 1, 1};\nDisk(2) = {0, 0, 0, 2, 2};\n"
      "BooleanFragments{ Surface{2}; Delete; }{ Surface{1}; Delete; }\n"
      "Physical Surface(\"core\") = {1}; Physical Surface(\"lining\") = {2};\n"
      "rim() = Abs(CombinedBoundary{ Surface{:}; }); Physical Curve(\"rim\") = rim();\n"
      "MeshSize{:} = 0.5;\n";
  const std::string scene =
      "set Bodies = a\nset Materials = soft\nsubsection Material soft\n set Young modulus = 1\nend\n"
      "subsection Body a\n set Mesh file = " +
      temporary_file("core.geo", core) +
      "\n set Young modulus = 100\n set Regions = lining: soft\n set Conditions = rim: displacement: "
      "-0.001*x, "
      "-0.001*y\nend\n";
  for (const std::string type : {"quadrilaterals", "triangles"})
  {
    const Answer answer = run_text(scene, {"Discretisation/Degree=2", "Body a/Cell type=" + type});
    ASSERT_EQ(answer.status, 0) << answer.err;
    EXPECT_NEAR(answer.summary["bodies"][0]["energy"].get<double>(), 3.5235e-5, 5e-4 * 3.5235e-5) << type;
  }
  // Of a mesh it stays a polygon, and the user hears of it.
  const std::string mesh = written_by_gmsh(temporary_file("mesh.geo", core), "core.msh");
  const Answer meshed = run_text(scene, {"Body a/Mesh file=" + mesh});
  ASSERT_EQ(meshed.status, 0) << meshed.err;
  EXPECT_EQ(warning_codes(meshed), std::multiset<std::string>{"facets"}) << meshed.err;
  expect_refused(run_text(scene, {"Body a/Regions=lining: soft; 2: soft"}),
                 {"`2` (Regions)", "names already"});
}

namespace
{
  /// A core of radius 1 in a lining of radius 2 under u = -1e-3 (x, y) at the rim; nu = .3.
  struct CoreInLining
  {
    std::string core, lining; // moduli
    double energy;            // Lame
  };
  const std::vector<CoreInLining> cores = {{"100", "1", 3.52349046e-5}, {"0.001", "100", 1.11538637e-3}};

  std::string core_scene(const CoreInLining &of)
  {
    const std::string geometry =
        "SetFactory(\"OpenCASCADE\");\nDisk(1) = {0, 0, 0, 1, 1};\nDisk(2) = {0, 0, 0, 2, 2};\n"
        "BooleanFragments{ Surface{2}; Delete; }{ Surface{1}; Delete; }\n"
        "Physical Surface(\"core\") = {1}; Physical Surface(\"lining\") = {2};\n"
        "rim() = Abs(CombinedBoundary{ Surface{:}; }); Physical Curve(\"rim\") = rim();\n"
        "MeshSize{:} = 0.5;\n";
    return "set Bodies = a\nset Materials = outside\nsubsection Material outside\n set Young modulus = " +
           of.lining + "\nend\nsubsection Body a\n set Mesh file = " + temporary_file("core.geo", geometry) +
           "\n set Young modulus = " + of.core +
           "\n set Regions = lining: outside\n set Adapt = true\n"
           " set Conditions = rim: displacement: -0.001*x, -0.001*y\nend\n";
  }

  std::string glued_core_scene(const CoreInLining &of)
  {
    return "set Bodies = a\nsubsection Part core\n set Shape = disc\n set Size = 1\n set Cells = 4, 3\n"
           " set Young modulus = " +
           of.core +
           "\nend\nsubsection Part lining\n set Shape = ring\n set Size = 1, 2\n set Cells = 6, 4\n"
           " set Young modulus = " +
           of.lining +
           "\nend\nsubsection Body a\n set Shape = glued parts\n set Parts = core, lining\n"
           " set Conditions = lining.outer: displacement: -0.001*x, -0.001*y\nend\n";
  }

  double energy_of(const Answer &answer)
  {
    return answer.summary["bodies"][0]["energy"].get<double>();
  }
} // namespace

TEST(Regions, ARoundBorderStaysRoundWhereMeshesFollowTheError)
{
  // Chords beside finer cells had taken .1 % of the energy of degree 3, .2 % the other way round.
  for (const CoreInLining &of : cores)
    for (const std::string degree : {"2", "3"})
    {
      const Answer answer =
          run_text(core_scene(of), {"Adaptation/Estimator=kelly", "Adaptation/Marking=fixed fraction",
                                    "Adaptation/Fraction=0.1", "Adaptation/Maximum passes=4",
                                    "Discretisation/Degree=" + degree});
      ASSERT_EQ(answer.status, 0) << answer.err;
      EXPECT_EQ(answer.summary["bodies"][0]["min_level"], 0);
      EXPECT_NEAR(energy_of(answer) / of.energy, 1., degree == "2" ? 1e-5 : 1e-7) << of.core << degree;
    }
}

TEST(Regions, JumpsBetweenMaterialsAreThoseOfTheStifferOne)
{
  // By halves they were estimated to be 45 to 100 times the error.
  const CoreInLining &soft = cores[1];
  const auto ratio = [&](const std::string &scene, const std::vector<std::string> &overrides) {
    const std::vector<std::string> kelly = {"Adaptation/Estimator=kelly", "Adaptation/Maximum passes=1"};
    const Answer answer = run_text(scene, with(kelly, overrides));
    EXPECT_EQ(answer.status, 0) << answer.err;
    return answer.summary["error"]["discretisation"].get<double>() /
           std::sqrt(energy_of(answer) / soft.energy - 1.);
  };
  for (const std::string type : {"quadrilaterals", "triangles"})
    for (const std::string degree : {"1", "2"})
    {
      const double found =
          ratio(core_scene(soft), {"Body a/Cell type=" + type, "Discretisation/Degree=" + degree});
      EXPECT_GT(found, .7) << type << degree;
      EXPECT_LT(found, 1.2) << type << degree;
    }
  for (const std::string degree : {"2", "3"}) // the energy of degree 1 is that of a polygon
  {
    const double found = ratio(glued_core_scene(soft), {"Discretisation/Degree=" + degree});
    EXPECT_GT(found, .9) << degree;
    EXPECT_LT(found, 1.9) << degree;
  }
}
