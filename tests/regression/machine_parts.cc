// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Parts as engineers have them, each known by a coarse mesh of straight edges alone: gears, a pin in a bore,
// a dovetail.
#include <gtest/gtest.h>

#include "geo_text.h"
#include "program.h"
#include <cmath>
#include <sstream>

using namespace abut::testing;

namespace
{
  using Overrides = std::vector<std::string>;

  std::string body(const std::string &name, const std::string &mesh, const std::string &entries)
  {
    return "subsection Body " + name + "\n set Mesh file = " + mesh +
           "\n set Young modulus = 2.1e5\n set Adapt = true\n" + entries + "\nend\n";
  }

  Overrides adapting(const int degree, const int passes)
  {
    return {"Discretisation/Degree=" + std::to_string(degree), "Adaptation/Estimator=kelly",
            "Adaptation/Maximum passes=" + std::to_string(passes)};
  }

  constexpr double pressure_angle = M_PI / 9.; // 20 degrees
  constexpr double module = 5.;

  double pitch_radius(const int teeth)
  {
    return .5 * module * teeth;
  }

  /// One tooth of a gear with a piece of its rim; its flank meets the pitch point at (pitch radius, 0).
  std::string gear(const std::string &name, const int teeth)
  {
    const double pitch = pitch_radius(teeth), base = pitch * std::cos(pressure_angle), tip = pitch + module,
                 root = pitch - 1.25 * module, hub = pitch - 3. * module, thickness = M_PI / teeth;
    const auto involute = [](const double angle) { return std::tan(angle) - angle; };
    // By how much the flank lies ahead of the pitch point at a radius.
    const auto lead = [&](const double radius) {
      return involute(pressure_angle) - involute(std::acos(base / radius));
    };
    GeoText geo;
    constexpr double coarse = 3., fine = 1.;
    constexpr int n = 12; // places on a flank
    const int centre = geo.point(0., 0., coarse);
    const int hub_0 = geo.polar(hub, -2. * thickness, coarse),
              root_0 = geo.polar(root, -2. * thickness, coarse),
              root_1 = geo.polar(root, -thickness - lead(base), coarse);
    std::vector<int> lower, upper;
    for (int i = 0; i <= n; ++i)
    {
      const double up = base + (tip - base) * i / n, down = base + (tip - base) * (n - i) / n;
      lower.push_back(geo.polar(up, -thickness - lead(up), coarse));
      upper.push_back(geo.polar(down, lead(down), fine));
    }
    const int root_2 = geo.polar(root, lead(base), coarse), root_3 = geo.polar(root, thickness, coarse),
              hub_1 = geo.polar(hub, thickness, coarse);
    const int first = geo.line(hub_0, root_0);
    geo.arc(root_0, centre, root_1);
    geo.line(root_1, lower.front());
    geo.spline(lower);
    geo.arc(lower.back(), centre, upper.front());
    const int flank = geo.spline(upper);
    geo.line(upper.back(), root_2);
    geo.arc(root_2, centre, root_3);
    const int second = geo.line(root_3, hub_1), inside = geo.arc(hub_1, centre, hub_0);
    geo.side("flank", {flank});
    geo.side("hub", {first, second, inside});
    return geo.mesh(name);
  }
} // namespace

TEST(MachineParts, InvoluteGearsPressAsHertzSaysAtThePitchPoint)
{
  constexpr int teeth_1 = 20, teeth_2 = 30;
  const double r_1 = pitch_radius(teeth_1), r_2 = pitch_radius(teeth_2);
  std::ostringstream place;
  place << "\n set Rotation angle = 180\n set Shift = " << r_1 + r_2 << ", 0";
  const std::string scene =
      "set Bodies = pinion, wheel\nset Contacts = mesh\n"
      "subsection Constants\n set Names = w\n set Values = 2e-4\nend\n" +
      body("pinion", gear("pinion", teeth_1), " set Conditions = hub: displacement: -w*y, w*x") +
      body("wheel", gear("wheel", teeth_2), " set Conditions = hub: displacement: 0, 0" + place.str()) +
      "subsection Contact mesh\n set Slave = pinion:flank\n set Master = wheel:flank\nend\n";
  const Answer answer = run_text(scene, adapting(2, 8));
  ASSERT_EQ(answer.status, 0) << answer.err;
  const double curvature = (1. / r_1 + 1. / r_2) / std::sin(pressure_angle),
               plane = .5 * 2.1e5 / (1. - .3 * .3), force = contact_value(answer, "mesh", "normal_force");
  const double hertz = std::sqrt(force * plane * curvature / M_PI);
  EXPECT_NEAR(contact_value(answer, "mesh", "max_pressure") / hertz, 1., .05);
  // Along the line of action.
  const auto vector = contact(answer, "mesh")["force"];
  EXPECT_NEAR(std::abs(vector[0].get<double>() / vector[1].get<double>()), std::tan(pressure_angle), .01);
}

TEST(MachineParts, APinInABoreOfAnyClearance)
{
  const auto quarter = [](const std::string &name, const double inner, const double outer) {
    GeoText geo;
    const double size = outer > 20. ? 3. : 1.;
    const int centre = geo.point(0., 0., 2.), right = geo.point(outer, 0., size),
              top = geo.point(0., outer, size);
    const int inner_top = inner > 0. ? geo.point(0., inner, 1.) : centre,
              inner_right = inner > 0. ? geo.point(inner, 0., 1.) : centre;
    const int bottom = geo.line(inner_right, right), rim = geo.arc(right, centre, top),
              left = geo.line(top, inner_top);
    if (inner > 0.)
      geo.side("inner", {geo.arc(inner_top, centre, inner_right)});
    geo.side("outer", {rim});
    geo.side("left", {left});
    geo.side("bottom", {bottom});
    return geo.mesh(name);
  };
  for (const double clearance : {1e-2, 1e-3, 1e-4, 1e-5})
  {
    constexpr double radius = 10.;
    const double bore = radius * (1. + clearance);
    const auto run_with = [&](const std::string &pin, const std::string &ring) {
      return run_text("set Bodies = pin, ring\nset Contacts = c\nsubsection Body pin\n" + pin +
                          "\n set Young modulus = 2.1e5\n set Adapt = true\n set Body force = 0, 10\n"
                          " set Conditions = left: normal displacement: 0\nend\nsubsection Body ring\n" +
                          ring +
                          "\n set Young modulus = 7e4\n set Adapt = true\n"
                          " set Conditions = left: normal displacement: 0; outer: displacement: 0, 0\nend\n"
                          "subsection Contact c\n set Slave = pin:outer\n set Master = ring:inner\nend\n",
                      adapting(2, 6));
    };
    std::ostringstream ring;
    ring << " set Shape = quarter ring\n set Size = " << bore << ", 30\n set Cells = 24, 12";
    const Answer built_in =
        run_with(" set Shape = quarter disc\n set Size = 10\n set Cells = 24, 8", ring.str());
    const Answer meshed = run_with(" set Mesh file = " + quarter("pin", 0., radius),
                                   " set Mesh file = " + quarter("ring", bore, 30.));
    ASSERT_EQ(built_in.status, 0) << built_in.err;
    ASSERT_EQ(meshed.status, 0) << meshed.err;
    for (const std::string key : {"normal_force", "max_pressure"})
    {
      EXPECT_NEAR(contact_value(meshed, "c", key) / contact_value(built_in, "c", key), 1., .01)
          << key << ' ' << clearance;
    }
  }
}

namespace
{
  /// A polygon, some of whose sides have names: those that begin at the corners of these numbers.
  std::string polygon(const std::string &name, const std::vector<std::array<double, 2>> &corners,
                      const std::vector<std::pair<std::string, int>> &sides)
  {
    GeoText geo;
    std::vector<int> points, lines;
    for (const auto &[x, y] : corners)
      points.push_back(geo.point(x, y, 1.5));
    for (std::size_t i = 0; i < points.size(); ++i)
      lines.push_back(geo.line(points[i], points[(i + 1) % points.size()]));
    for (const auto &[side, i] : sides)
      geo.side(side, {lines[static_cast<std::size_t>(i)]});
    return geo.mesh(name);
  }

  /// A tongue whose flanks lean by 45 degrees is pulled out of its groove by the force 300.
  std::string dovetail(const std::string &contacts)
  {
    const std::string tongue =
        polygon("tongue", {{{-10., -5.}}, {{10., -5.}}, {{5., 0.}}, {{5., 8.}}, {{-5., 8.}}, {{-5., 0.}}},
                {{"right", 1}, {"top", 3}, {"left", 5}});
    const std::string groove = polygon("groove",
                                       {{{-20., -15.}},
                                        {{20., -15.}},
                                        {{20., 0.}},
                                        {{5., 0.}},
                                        {{11., -6.}},
                                        {{-11., -6.}},
                                        {{-5., 0.}},
                                        {{-20., 0.}}},
                                       {{"base", 0}, {"right", 3}, {"left", 5}});
    return "set Bodies = tongue, groove\n" +
           body("tongue", tongue, " set Conditions = top: traction: 0, 30") +
           body("groove", groove, " set Conditions = base: displacement: 0, 0") + contacts;
  }
} // namespace

TEST(MachineParts, ADovetailAt45DegreesCarriesThePull)
{
  // Two flanks without friction share the pull P: each takes P/sqrt(2) along its normal.
  const std::string scene =
      dovetail("set Contacts = left, right\n"
               "subsection Contact left\n set Slave = tongue:left\n set Master = groove:left\nend\n"
               "subsection Contact right\n set Slave = tongue:right\n set Master = groove:right\nend\n");
  for (const int degree : {1, 2})
  {
    const Answer answer = run_text(scene, adapting(degree, 4));
    ASSERT_EQ(answer.status, 0) << answer.err;
    for (const std::string flank : {"left", "right"})
    {
      EXPECT_NEAR(contact_value(answer, flank, "normal_force"), 300. / std::sqrt(2.), 1e-6 * 300.) << flank;
    }
  }
}

TEST(MachineParts, ContactsAreFoundWhereSidesFaceEachOther)
{
  const Answer answer = run_text(dovetail("set Contacts = automatic\n"), adapting(1, 2));
  ASSERT_EQ(answer.status, 0) << answer.err;
  ASSERT_EQ(answer.summary["contacts"].size(), 2u);
  for (const std::string pair : {"tongue.left-groove.left", "tongue.right-groove.right"})
  {
    EXPECT_NEAR(contact_value(answer, pair, "normal_force"), 300. / std::sqrt(2.), 1e-6 * 300.);
  }
  // Blocks side by side on a base, one a little above it: three pairs that are near, no edge to edge.
  const std::string blocks =
      "set Bodies = base, a, b\nset Contacts = automatic\n"
      "subsection Body base\n set Size = 4, 1\n set Conditions = bottom: displacement: 0, 0\nend\n"
      "subsection Body a\n set Shift = 1, 1\n set Conditions = top: displacement: 0, -0.01\nend\n"
      "subsection Body b\n set Shift = 2.002, 1.005\n set Conditions = top: displacement: 0, -0.01\nend\n";
  const auto pairs = [](const Answer &found) {
    std::set<std::string> names;
    for (const auto &pair : found.summary["contacts"])
      names.insert(pair["name"].get<std::string>());
    return names;
  };
  EXPECT_EQ(pairs(run_text(blocks)),
            (std::set<std::string>{"base.top-a.bottom", "base.top-b.bottom", "a.right-b.left"}));
  EXPECT_EQ(pairs(run_text(blocks, {"Contact distance=0.001"})),
            (std::set<std::string>{"base.top-a.bottom"}));
  // A disc of eight edges stands on a vertex; a block that only meets another corner to corner faces none.
  EXPECT_EQ(pairs(run_text(
                blocks, {"Body a/Shape=disc", "Body a/Size=0.5", "Body a/Cells=2, 2", "Body a/Shift=0.7, 1.5",
                         "Body a/Conditions=(0, 0.5): displacement: 0, -0.001; (0, 0): displacement x: 0",
                         "Body b/Shift=4, 1"})),
            (std::set<std::string>{"base.top-a.outer"}));
  expect_refused(run_text(blocks, {"Body a/Shift=1, 1.2", "Contact distance=0.001"}),
                 {"no sides of two bodies face each other within 0.001", "apart"});
}

TEST(MachineParts, AClipThatClosesOnItself)
{
  // Half of it with its mirror image, held on the line of symmetry, presses lip on lip as the whole does.
  const std::string material = " set Young modulus = 1000\n set Cell type = quadrilaterals\n",
                    contact = "subsection Contact lips\n set Slave = ";
  const std::string whole =
      "set Bodies = clip\nset Contacts = lips\nsubsection Body clip\n set Shape = outline\n set Outline = "
      "(0, -3) -> bottom: (10, -3) -> (10, -0.01) -> low: (3, -0.01) -> (3, 0.01) -> high: (10, 0.01) -> "
      "(10, 3) -> top: (0, 3) -> left: close\n set Mesh size = 0.4; low: 0.2; high: 0.2\n" +
      material + " set Conditions = left: displacement: 0, 0; top + bottom: pressure: 0.5\nend\n" + contact +
      "clip:low\n set Master = clip:high\nend\n";
  const auto half = [&](const std::string &name, const std::string &mirrored) {
    return "subsection Body " + name + "\n set Shape = outline\n set Rotation angle = " + mirrored +
           "\n set Outline = (0, 0) -> middle: (3, 0) -> (3, 0.01) -> lip: (10, 0.01) -> (10, 3) -> "
           "top: (0, 3) -> left: close\n set Mesh size = 0.4; lip: 0.2\n" +
           material +
           " set Conditions = left: displacement: 0, 0; middle: normal displacement: 0; top: pressure: 0.5\n";
  };
  const std::string halves = "set Bodies = a, b\nset Contacts = lips\n" + half("a", "0") + "end\n" +
                             half("b", "180") + " set Mirror = true\nend\n" + contact +
                             "a:lip\n set Master = b:lip\nend\n";
  const Answer one = run_text(whole, {"Discretisation/Degree=2"}),
               two = run_text(halves, {"Discretisation/Degree=2"});
  ASSERT_EQ(one.status, 0) << one.err;
  ASSERT_EQ(two.status, 0) << two.err;
  const double force = contact_value(two, "lips", "normal_force");
  EXPECT_GT(force, .1);
  EXPECT_NEAR(contact_value(one, "lips", "normal_force"), force, .01 * force);
}
