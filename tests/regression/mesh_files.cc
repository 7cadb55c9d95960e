// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Bodies from mesh and geometry files, whose straight edges stand for curves. Inputs: tests/data/cases.
#include <gtest/gtest.h>

#include "gmsh_files.h"
#include "program.h"
#include <algorithm>
#include <cmath>
#include <filesystem>

using namespace abut::testing;

namespace
{
  using Overrides = std::vector<std::string>;

  struct Values
  {
    double force, peak, mean; ///< of pressures
  };

  Values values_of(const Answer &answer, const std::string &name)
  {
    const auto pair = contact(answer, name);
    const double force = pair["normal_force"].get<double>();
    return {force, pair["max_pressure"].get<double>(), force / pair["contact_length"].get<double>()};
  }

  /// What makes both bodies of a case adapt.
  Overrides adapting(const std::string &a, const std::string &b, const int passes)
  {
    return {"Body " + a + "/Adapt=true", "Body " + b + "/Adapt=true", "Adaptation/Estimator=kelly",
            "Adaptation/Maximum passes=" + std::to_string(passes)};
  }

  Overrides degree(const int p)
  {
    return {"Discretisation/Degree=" + std::to_string(p)};
  }

  /// Half a pin of radius 10 in half a lug whose bore is .05 wider, pulled apart.
  std::string pin_in_lug(const std::string &lug, const std::string &side_of_bore,
                         const std::string &more_conditions = "")
  {
    return "set Bodies = lug, pin\nset Contacts = bore\n"
           "subsection Body lug\n set Mesh file = " +
           lug +
           "\n set Cell type = triangles\n set Young modulus = 70000\n"
           " set Conditions = foot: displacement: 0, 0; sym: normal displacement: 0" +
           more_conditions +
           "\nend\n"
           "subsection Body pin\n set Shape = half disc\n set Size = 10\n set Cells = 32, 8\n"
           " set Rotation angle = -90\n set Young modulus = 210000\n"
           " set Conditions = bottom: normal displacement: 0\n set Body force = 10, 0\nend\n"
           "subsection Contact bore\n set Slave = pin:outer\n set Master = lug:" +
           side_of_bore + "\nend\n";
  }
} // namespace

TEST(MeshFiles, APressFitOfFewEdgesHasThePressureOfItsCircles)
{
  // Lame; an edge is .012 off its circle, the overlap .0025.
  constexpr double pressure = 6.761, force = 212.4;
  const Values coarse = values_of(run_case("press-fit"), "fit");
  EXPECT_NEAR(coarse.force, force, .01 * force);
  EXPECT_NEAR(coarse.peak, pressure, .03 * pressure);
  for (const Overrides &overrides :
       {degree(2), degree(3), adapting("sleeve", "ring", 3), with(degree(2), adapting("sleeve", "ring", 3)),
        Overrides{"Contact fit/Slave=sleeve:2", "Contact fit/Master=ring:1", "Discretisation/Degree=2"}})
  {
    const Answer answer = run_case("press-fit", overrides);
    ASSERT_EQ(answer.status, 0) << answer.err;
    EXPECT_NEAR(values_of(answer, "fit").peak, pressure, .01 * pressure);
    EXPECT_NEAR(values_of(answer, "fit").force, force, .002 * force);
  }
}

TEST(MeshFiles, AGrowingDiscOfFewEdgesPressesAsItsCircle)
{
  for (const Overrides &overrides : {degree(1), degree(2), degree(3), adapting("particle", "matrix", 3),
                                     with(degree(2), adapting("particle", "matrix", 3))})
  {
    const Answer answer = run_case("growing-disc", overrides);
    ASSERT_EQ(answer.status, 0) << answer.err;
    EXPECT_NEAR(values_of(answer, "c").mean, 1.1695, .01 * 1.1695);
  }
}

TEST(MeshFiles, APinInAWiderRingHasItsClearance)
{
  for (const Overrides &overrides : {degree(1), degree(2), degree(3), adapting("ring", "pin", 3),
                                     with(degree(2), adapting("ring", "pin", 4))})
  {
    const Answer answer = run_case("clearance", overrides);
    ASSERT_EQ(answer.status, 0) << answer.err;
    EXPECT_NEAR(values_of(answer, "fit").peak, 205., .03 * 205.);
  }
}

TEST(MeshFiles, AFoldedCellIsRefusedWithItsPlace)
{
  expect_refused(run_case("folded"),
                 {"Body a/Mesh file folded.msh", "lie on each other at (6.75309, 3.03287)"});
}

TEST(MeshFiles, EveryFormatOfTheSamePartGivesTheSame)
{
  const std::string geometry = project_file("tests/data/cases/lug.geo");
  const auto force_and_peak = [](const std::string &file) {
    const Answer answer = run_text(pin_in_lug(file, "bore"), degree(2));
    EXPECT_EQ(answer.status, 0) << answer.err;
    return values_of(answer, "bore");
  };
  const Values exact = force_and_peak(geometry);
  for (const auto &[name, options] : std::vector<std::pair<std::string, GmshOptions>>{
           {"lug-22.msh", {{"Mesh.MshFileVersion", 2.2}}},
           {"lug-41.msh", {{"Mesh.MshFileVersion", 4.1}}},
           {"lug-binary.msh", {{"Mesh.Binary", 1}}},
           {"lug-second.msh", {{"Mesh.ElementOrder", 2}}},
           {"lug-second-22.msh",
            {{"Mesh.ElementOrder", 2}, {"Mesh.MshFileVersion", 2.2}, {"Mesh.Binary", 1}}},
           {"lug-incomplete.msh", {{"Mesh.ElementOrder", 2}, {"Mesh.SecondOrderIncomplete", 1}}}})
  {
    const Values found = force_and_peak(written_by_gmsh(geometry, name, options));
    // The same cells; the arcs are smooth curves through points, 1e-7 of the radius off.
    EXPECT_NEAR(found.force, exact.force, 1e-6 * exact.force) << name;
    EXPECT_NEAR(found.peak, exact.peak, 1e-3 * exact.peak) << name;
  }
  for (const Overrides &overrides :
       {Overrides{"Body lug/Cell type=quadrilaterals"}, {"Body lug/Mesh size=1"}})
  {
    const Answer answer = run_text(pin_in_lug(geometry, "1"), with(degree(2), overrides));
    ASSERT_EQ(answer.status, 0) << answer.err;
    EXPECT_NEAR(values_of(answer, "bore").force, exact.force, 1e-3 * exact.force);
    EXPECT_NEAR(values_of(answer, "bore").peak, exact.peak, .02 * exact.peak);
  }
}

TEST(MeshFiles, AnEllipseOnAFlatHasThePeakOfHertz)
{
  // p0 = sqrt(F E* / (pi R)), R = 4 where the half axes are 2 and 1; half width of the contact R/40: Hertz
  // holds to .2 %.
  const double plane = .5 * 1000. / (1. - .3 * .3);
  for (const std::string &file : {project_file("tests/data/cases/cam.geo"),
                                  written_by_gmsh(project_file("tests/data/cases/cam.geo"), "cam.msh")})
    for (const std::string type : {"quadrilaterals", "triangles"})
    {
      const std::string scene =
          "set Bodies = cam, base\nset Contacts = c\n"
          "subsection Body cam\n set Mesh file = " +
          file + "\n set Cell type = " + type +
          "\n set Young modulus = 1000\n set Adapt = true\n"
          " set Conditions = face: displacement: 0, -0.005\nend\n"
          "subsection Body base\n set Size = 8, 4\n set Shift = -4, -5\n set Cells = 16, 8\n"
          " set Young modulus = 1000\n set Adapt = true\n set Conditions = bottom: displacement: 0, 0\nend\n"
          "subsection Contact c\n set Slave = cam:round\n set Master = base:top\nend\n";
      const Answer answer =
          run_text(scene, with(degree(2), {"Adaptation/Estimator=kelly", "Adaptation/Maximum passes=8"}));
      ASSERT_EQ(answer.status, 0) << answer.err;
      const Values found = values_of(answer, "c");
      EXPECT_NEAR(found.peak / std::sqrt(found.force * plane / (4. * M_PI)), 1., .005) << file << ' ' << type;
    }
}

TEST(MeshFiles, FacetsAreNamedWhereTheyMatter)
{
  const Answer followed = run_case("press-fit");
  EXPECT_EQ(warning_codes(followed).count("facets"), 0u);
  const Answer as_meshed = run_case("press-fit", {"Body ring/Boundary curve=as meshed"});
  EXPECT_EQ(warning_codes(as_meshed).count("facets"), 1u);
  EXPECT_NE(as_meshed.err.find("up to 0.0117 off the smooth curve"), std::string::npos) << as_meshed.err;
  const Answer cornered = run_case("press-fit", {"Body ring/Corner angle=3"});
  EXPECT_EQ(warning_codes(cornered).count("coarse-curve"), 1u);
  const Answer check = run({project_file("tests/data/cases/press-fit.prm"), "--check"});
  EXPECT_NE(check.out.find("ring:1: 23 edges, turning by up to 3.91304 degrees, up to 0.0116596 off their "
                           "curve, which is followed"),
            std::string::npos)
      << check.out;
}

TEST(MeshFiles, CutCellsAndSeveralSurfacesAreSaid)
{
  const std::string square = "Point(1) = {0,0,0,.4}; Point(2) = {1,0,0,.4}; Point(3) = {1,1,0,.4};\n"
                             "Point(4) = {0,1,0,.4}; Point(5) = {2,0,0,.4}; Point(6) = {2,1,0,.4};\n"
                             "Line(1) = {1,2}; Line(2) = {2,3}; Line(3) = {3,4}; Line(4) = {4,1};\n"
                             "Line(5) = {2,5}; Line(6) = {5,6}; Line(7) = {6,3};\n"
                             "Curve Loop(1) = {1,2,3,4}; Plane Surface(1) = {1};\n"
                             "Curve Loop(2) = {5,6,7,-2}; Plane Surface(2) = {2};\n"
                             "Physical Curve(\"left\") = {4}; Physical Curve(\"right\") = {6};\n";
  const auto codes = [](const std::string &geometry) {
    const std::string mesh = written_by_gmsh(temporary_file("square.geo", geometry), "square.msh");
    const Answer answer =
        run_text("set Bodies = bar\nsubsection Body bar\n set Mesh file = " + mesh +
                 "\n set Conditions = left: displacement: 0, 0; right: traction: 1e-3, 0\nend\n");
    EXPECT_EQ(answer.status, 0) << answer.err;
    return warning_codes(answer);
  };
  const std::string one = "Physical Surface(\"a\") = {1, 2};\n",
                    two = "Physical Surface(\"a\") = {1}; Physical Surface(\"b\") = {2};\n",
                    mixed = "Transfinite Surface{1}; Recombine Surface{1};\n";
  EXPECT_EQ(codes(square + one), std::multiset<std::string>{});
  EXPECT_EQ(codes(square + two), std::multiset<std::string>{"one-material"});
  EXPECT_EQ(codes(square + one + mixed), std::multiset<std::string>{"cells-cut"});
}

TEST(MeshFiles, ARoundBodyThatContactAloneHoldsAdapts)
{
  // Between two plates: nothing but contact holds it, hanging nodes or not.
  const auto plate = [](const std::string &name, const std::string &shift, const std::string &condition) {
    return "subsection Body " + name + "\n set Size = 2, 1\n set Cells = 32, 16\n set Shift = -1, " + shift +
           "\n set Young modulus = 100\n set Conditions = " + condition + "\nend\n";
  };
  const std::string scene =
      "set Bodies = d, p, q\nset Contacts = c, e\nsubsection Body d\n set Shape = outline\n"
      " set Outline = outer: circle (0, 0) 1\n set Mesh size = 0.2\n set Young modulus = 100\n set Adapt = "
      "true\nend\n" +
      plate("p", "1", "top: displacement: 0, -0.01") + plate("q", "-2", "bottom: displacement: 0, 0") +
      "subsection Contact c\n set Slave = p:bottom\n set Master = d:outer\nend\n"
      "subsection Contact e\n set Slave = q:top\n set Master = d:outer\nend\n";
  for (const std::string type : {"quadrilaterals", "triangles"})
  {
    const Answer answer = run_text(scene, {"Body d/Cell type=" + type, "Adaptation/Estimator=kelly",
                                           "Adaptation/Maximum passes=4", "Discretisation/Degree=2"});
    ASSERT_EQ(answer.status, 0) << answer.err;
    const double force = values_of(answer, "c").force;
    EXPECT_GT(force, 0.);
    EXPECT_NEAR(values_of(answer, "e").force, force,
                2e-3 * force); // resultants balance; these are sums of |p|
    expect_balance(answer);
  }
}

TEST(MeshFiles, ASideHasOneNameInAScene)
{
  const std::string lug = project_file("tests/data/cases/lug.geo");
  expect_refused(run_text(pin_in_lug(lug, "bored")),
                 {"Body lug has no side 'bored'; its sides are", "1 (bore)", "2 (sym)", "3 (foot)"});
  expect_refused(run_text(pin_in_lug(lug, "bore", "; 1: pressure: 0")),
                 {"Body lug: the scene calls one of its sides both"});
}
