// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The solution at points that a scene names, against exact solutions: uniform compression, whole and turned,
// on quadrilaterals and triangles, at corners and on sides; Lame's ring, on its arcs, which no straight cell
// reaches.

#include <gtest/gtest.h>

#include "program.h"
#include <cmath>
#include <sstream>

namespace
{
  using namespace abut::testing;
  using nlohmann::json;

  struct PlaneVector
  {
    double x, y;
  };

  PlaneVector rotated(const PlaneVector &v, const double angle)
  {
    return {std::cos(angle) * v.x - std::sin(angle) * v.y, std::sin(angle) * v.x + std::cos(angle) * v.y};
  }

  PlaneVector displacement_of(const json &point)
  {
    return {point["displacement"][0], point["displacement"][1]};
  }

  std::string text_of(const PlaneVector &place)
  {
    return "(" + std::to_string(place.x) + ", " + std::to_string(place.y) + ")";
  }
} // namespace

TEST(OutputPoints, UniformCompression)
{
  const double nu = .3, modulus = 100., angle = std::acos(-1.) / 6.;
  const double p = 1e-3 / (2. * (1. - nu * nu) / modulus + .05 / modulus);
  const std::vector<PlaneVector> places = {{0., 0.}, {1., 0.}, {1., 1.}, {.3, .7}, {.5, 1.}, {1., .1}};
  for (const bool turn : {false, true})
    for (const std::string cells : {"quadrilaterals", "triangles"})
    {
      std::string points;
      for (const PlaneVector &place : places)
        points += (points.empty() ? "" : "; ") + std::string("lower: ") +
                  text_of(turn ? rotated(place, angle) : place);
      std::vector<std::string> overrides = {"Body lower/Cell type=" + cells, "Output/Points=" + points};
      if (turn)
        overrides = with(overrides, {"Body upper/Rotation angle=30", "Body lower/Rotation angle=30",
                                     "Body upper/Shift=-0.5, 0.86602540378443864676"});
      // six digits of turned places
      const double accuracy = turn ? 2e-6 : 1e-9;
      const Answer answer = run_scene("patch-test", overrides);
      ASSERT_EQ(answer.status, 0) << answer.err;
      ASSERT_EQ(answer.summary["points"].size(), places.size());
      for (std::size_t i = 0; i < places.size(); ++i)
      {
        const json &point = answer.summary["points"][i];
        EXPECT_EQ(point["body"], "lower");
        const double own = p / modulus * (1. + nu);
        const PlaneVector exact = {own * nu * places[i].x, -own * (1. - nu) * places[i].y},
                          found = displacement_of(point), expected = turn ? rotated(exact, angle) : exact;
        EXPECT_NEAR(found.x, expected.x, accuracy * p / modulus) << cells << turn << i;
        EXPECT_NEAR(found.y, expected.y, accuracy * p / modulus) << cells << turn << i;
        EXPECT_NEAR(point["von_mises"].get<double>(), p * std::sqrt(1. - nu + nu * nu), 1e-8 * p);
        EXPECT_NEAR(point["stress_zz"].get<double>(), -nu * p, 1e-8 * p);
        const double s = turn ? std::sin(angle) : 0., c = turn ? std::cos(angle) : 1.;
        EXPECT_NEAR(point["stress_xx"].get<double>(), -p * s * s, 1e-8 * p);
        EXPECT_NEAR(point["stress_yy"].get<double>(), -p * c * c, 1e-8 * p);
        EXPECT_NEAR(point["stress_xy"].get<double>(), p * s * c, 1e-8 * p);
      }
      EXPECT_EQ(column(answer.directory + "/points.csv", "von_mises")[3],
                answer.summary["points"][3]["von_mises"]);
    }
}

TEST(OutputPoints, EveryBodyThatHasThePointTells)
{
  const Answer answer = run_scene("patch-test", {"Output/Points=(0.5, 1); upper: (0.5, 1); (0.25, 1.5)"});
  ASSERT_EQ(answer.status, 0) << answer.err;
  std::vector<std::string> bodies;
  for (const json &point : answer.summary["points"])
    bodies.push_back(point["body"]);
  EXPECT_EQ(bodies, (std::vector<std::string>{"upper", "lower", "upper", "upper"}));
  EXPECT_GT(displacement_of(answer.summary["points"][1]).y, displacement_of(answer.summary["points"][0]).y)
      << "the penalty lets the bodies overlap";
}

TEST(OutputPoints, LameOnCurvedSides)
{
  // (0.8, 0.6) lies on the circle between the cells' corners.
  const Answer answer = run_scene(
      "shrink-fit", {"Discretisation/Degree=2", "Output/Points=ring: (1.6, 1.2); ring: (0.8, 0.6)"});
  ASSERT_EQ(answer.status, 0) << answer.err;
  const double p = 77.0564, nu = .3, modulus = 2.1e5;
  const json &outer = answer.summary["points"][0], &inner = answer.summary["points"][1];
  // sigma_theta = 2 p / 3, no other stress in the plane
  EXPECT_NEAR(outer["stress_xx"].get<double>(), 2. / 3. * p * .36, 2e-3 * p);
  EXPECT_NEAR(outer["stress_yy"].get<double>(), 2. / 3. * p * .64, 2e-3 * p);
  EXPECT_NEAR(outer["stress_xy"].get<double>(), -2. / 3. * p * .48, 2e-3 * p);
  const double radial = 2. * (1. - nu * nu) * p * 2. / (modulus * 3.);
  EXPECT_NEAR(displacement_of(outer).x, .8 * radial, 1e-4 * radial);
  EXPECT_NEAR(displacement_of(outer).y, .6 * radial, 1e-4 * radial);
  // sigma_r = -p, sigma_theta = 5 p / 3
  EXPECT_NEAR(inner["stress_xx"].get<double>(), p * (-.64 + 5. / 3. * .36), 1e-2 * p);
  EXPECT_NEAR(inner["stress_yy"].get<double>(), p * (-.36 + 5. / 3. * .64), 1e-2 * p);
}

TEST(OutputPoints, SingularOnesAreWarnedOf)
{
  // The notch of an L and its other corners.
  const Answer corner = run_scene("corner", {"Output/Points=(0, 0)"});
  ASSERT_EQ(corner.status, 0) << corner.err;
  EXPECT_EQ(warning_codes(corner).count("singular-stress"), 2u) << "the largest stress, and the point";
  const Answer beside = run_scene("corner", {"Output/Points=(0.1, 0.1)"});
  ASSERT_EQ(beside.status, 0) << beside.err;
  EXPECT_EQ(warning_codes(beside).count("singular-stress"), 1u);
  const Answer regular = run_scene("patch-test", {"Output/Points=lower: (0, 0); lower: (1, 1)"});
  EXPECT_EQ(warning_codes(regular).count("singular-stress"), 0u);
}

TEST(OutputPoints, WrongOnesAreRefused)
{
  expect_refused(run_scene("patch-test", {"Output/Points=(0.5, 3)"}),
                 {"Output/Points", "(0.5, 3)", "no elastic body"});
  expect_refused(run_scene("patch-test", {"Output/Points=upper: (0.5, 0.5)"}),
                 {"Output/Points", "upper: (0.5, 0.5)", "body upper"});
  expect_refused(run_scene("patch-test", {"Output/Points=middle: (0.5, 0.5)"}), {"Output/Points", "middle"});
  expect_refused(run_scene("patch-test", {"Output/Points=0.5, 0.5"}),
                 {"Output/Points", "0.5, 0.5", "(x, y)"});
}

TEST(OutputPoints, AreTheSameWhereverABodyStands)
{
  // Where coordinates have fewer digits for a cell, neither is a point lost nor does a neighbour of a node.
  const std::string body = "set Bodies = b\nsubsection Body b\n  set Size = 2, 1\n  set Cells = 20, 10\n  "
                           "set Young modulus = 1000\n"
                           "  set Conditions = bottom: displacement: 0, 0; top: traction: 1, x*x\nend\n";
  const std::vector<PlaneVector> own = {{.1, .9}, {.7, .3}, {.73, .31}, {1.9, .5}, {2., 1.}};
  json before;
  for (const auto &[shift, accuracy] :
       {std::pair(PlaneVector{0., 0.}, 0.), {{300., 100.}, 1e-9}, {{-3e6, 7e6}, 1e-6}})
  {
    std::string points;
    for (const PlaneVector &place : own)
      points += (points.empty() ? "" : "; ") + text_of({place.x + shift.x, place.y + shift.y});
    const Answer answer =
        run_text(body, {"Body b/Shift=" + std::to_string(shift.x) + ", " + std::to_string(shift.y),
                        "Output/Points=" + points});
    ASSERT_EQ(answer.status, 0) << answer.err;
    const json found = answer.summary["points"];
    ASSERT_EQ(found.size(), own.size());
    for (std::size_t i = 0; i < own.size() && !before.is_null(); ++i)
      for (const char *const key : {"von_mises", "stress_xx", "stress_xy"})
        EXPECT_NEAR(found[i][key].get<double>(), before[i][key].get<double>(), accuracy) << i << ' ' << key;
    if (before.is_null())
      before = found;
  }
}

/// Layers that are stretched along their interface: the stress is uniform in each, E/(1 - nu^2) of the
/// strain.
TEST(OutputPoints, BetweenMaterialsTheStressesOfBothAreTold)
{
  const std::string layers =
      "set Bodies = b\nsubsection Part p\n set Size = 2, 1\n set Cells = 4, 2\n set Young modulus = 100\n"
      " set Poisson ratio = 0.2\nend\nsubsection Part q\n set Size = 2, 1\n set Shift = 0, 1\n"
      " set Cells = 6, 3\n set Young modulus = 1000\n set Poisson ratio = 0.4\nend\n"
      "subsection Body b\n set Shape = glued parts\n set Parts = p, q\n set Conditions = "
      "p.left + q.left: displacement x: 0; p.right + q.right: displacement x: 0.02; "
      "p.bottom: normal displacement: 0\nend\n";
  const auto stretched = [](const double modulus, const double nu) {
    return .01 * modulus / (1. - nu * nu) * std::sqrt(1. - nu + nu * nu);
  };
  const double soft = stretched(100., .2), stiff = stretched(1000., .4);
  const Answer answer = run_text(layers, {"Output/Points=(1, 1); (1, 0.9); (1, 1.1)"});
  ASSERT_EQ(answer.status, 0) << answer.err;
  EXPECT_EQ(warning_codes(answer), std::multiset<std::string>{"between-materials"}) << answer.err;
  EXPECT_NEAR(answer.summary["points"][1]["von_mises"].get<double>(), soft, 1e-8);
  EXPECT_NEAR(answer.summary["points"][2]["von_mises"].get<double>(), stiff, 1e-8);
  std::ostringstream values;
  values.precision(4);
  values << soft << " where E = 100, nu = 0.2, " << stiff << " where E = 1000, nu = 0.4";
  EXPECT_NE(answer.summary["warnings"][0]["message"].get<std::string>().find(values.str()), std::string::npos)
      << answer.err;
  const Answer alike =
      run_text(layers, {"Output/Points=(1, 1)", "Part q/Young modulus=100", "Part q/Poisson ratio=0.2"});
  EXPECT_EQ(warning_codes(alike), std::multiset<std::string>{}) << alike.err;
  EXPECT_EQ(
      warning_codes(run_text(layers, {"Goal=stress at (1, 1)", "Tolerance=0.1"})).count("between-materials"),
      1u);
}
