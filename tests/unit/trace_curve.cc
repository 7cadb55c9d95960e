// SPDX-License-Identifier: LGPL-2.1-or-later
// Sides of meshes as curves: order, places, normals, lengths, unknowns.
#include <abut/bodies/finite_elements/nodes.h>

#include "mesh_testing.h"
#include "trace_testing.h"

using namespace abut;

namespace
{
  struct SideOfMesh
  {
    SideOfMesh(const BodyDescription &body, const std::string &side)
        : space(make_mesh(body), body.degree), trace(space.trace(boundary_id(space.mesh(), side)))
    {}
    Space space;
    Trace trace;
  };

  /// The unknowns of every node must be those of the space at the same place.
  void expect_unknowns_at_their_places(const SideOfMesh &side)
  {
    const Nodes nodes = all_nodes(side.space);
    std::map<unsigned int, std::size_t> node_of;
    for (std::size_t i = 0; i < nodes.dofs.size(); ++i)
      node_of[nodes.dofs[i][0]] = i;
    for (std::size_t i = 0; i < side.trace.n_nodes(); ++i)
    {
      const auto found = node_of.find(side.trace.node_dofs()[i][0]);
      ASSERT_NE(found, node_of.end());
      EXPECT_EQ(nodes.dofs[found->second][1], side.trace.node_dofs()[i][1]);
      EXPECT_LT((nodes.places[found->second] - side.trace.node_points()[i]).norm(), 1e-13) << i;
    }
  }

  /// Every segment must begin where the one before ends, in place and in node.
  void expect_connected(const Trace &trace)
  {
    for (std::size_t i = 0; i + 1 < trace.segments().size(); ++i)
    {
      const Segment &here = trace.segments()[i], &next = trace.segments()[i + 1];
      EXPECT_EQ(here.nodes.back(), next.nodes.front());
      EXPECT_LT((here.points.back() - next.points.front()).norm(), 1e-14);
      EXPECT_NEAR(here.arc_start + here.length, next.arc_start, 1e-13);
    }
  }
} // namespace

TEST(TraceCurve, SidesOfRectanglesRunWithTheBodyOnTheLeft)
{
  struct Expected
  {
    std::string side;
    Vector2 start, end, normal;
  };
  const std::vector<Expected> sides = {{"bottom", {0., 0.}, {4., 0.}, {0., -1.}},
                                       {"right", {4., 0.}, {4., 1.}, {1., 0.}},
                                       {"top", {4., 1.}, {0., 1.}, {0., 1.}},
                                       {"left", {0., 1.}, {0., 0.}, {-1., 0.}}};
  for (const CellType type : {CellType::quadrilaterals, CellType::triangles})
    for (unsigned int degree = 1; degree <= (type == CellType::triangles ? 2 : 3); ++degree)
      for (const bool mirrored : {false, true})
        for (const Expected &expected : sides)
        {
          auto body = make_body("rectangle", {4., 1.}, {{5, 3}});
          body.cell_type = type;
          body.degree = degree;
          body.placement = Placement(2., mirrored, 30., Vector2(5., -3.));
          const SideOfMesh side(body, expected.side);
          const Trace &trace = side.trace;
          expect_connected(trace);
          expect_unknowns_at_their_places(side);
          const Vector2 start = body.placement.point_to_world(mirrored ? expected.end : expected.start);
          const Vector2 end = body.placement.point_to_world(mirrored ? expected.start : expected.end);
          const Vector2 normal = body.placement.direction_to_world(expected.normal);
          ASSERT_EQ(trace.segments().size(), expected.normal.x() == 0. ? 5u : 3u);
          ASSERT_EQ(trace.n_nodes(), degree * trace.segments().size() + 1);
          EXPECT_LT((trace.segments().front().points.front() - start).norm(), 1e-14);
          EXPECT_LT((trace.segments().back().points.back() - end).norm(), 1e-14);
          EXPECT_NEAR(trace.length(), (end - start).norm(), 1e-13);
          for (std::size_t i = 0; i < trace.n_nodes(); ++i)
          {
            EXPECT_LT((trace.node_normals()[i] - normal).norm(), 1e-14);
            EXPECT_NEAR(trace.node_arc_lengths()[i], (trace.node_points()[i] - start).norm(), 1e-13);
          }
        }
}

TEST(TraceCurve, ADiscIsClosed)
{
  constexpr double radius = 1.5;
  for (unsigned int degree = 1; degree <= 3; ++degree)
  {
    auto body = make_body("disc", {radius}, {{16, 2}});
    body.degree = degree;
    body.placement = Placement(1., false, 0., Vector2(10., 20.));
    const SideOfMesh side(body, "outer");
    const Trace &trace = side.trace;
    expect_connected(trace);
    ASSERT_EQ(trace.segments().size(), 64u);
    ASSERT_EQ(trace.n_nodes(), 64u * degree);
    EXPECT_EQ(trace.segments().back().nodes.back(), trace.segments().front().nodes.front());
    EXPECT_NEAR(trace.length(), 2. * M_PI * radius, 1e-8);
    EXPECT_EQ(trace.node_arc_lengths()[trace.segments().front().nodes.front()], 0.);
    for (std::size_t i = 0; i < trace.n_nodes(); ++i)
    {
      const Vector2 arm = trace.node_points()[i] - Vector2(10., 20.);
      EXPECT_NEAR(arm.norm(), radius, 1e-8);
      EXPECT_LT((trace.node_normals()[i] - arm / radius).norm(), 1e-5) << degree << " " << i;
    }
  }
}

TEST(TraceCurve, TheHoleOfARingHasItsNormalsInward)
{
  auto body = make_body("ring", {1., 2.}, {{8, 2}});
  const SideOfMesh side(body, "inner");
  for (std::size_t i = 0; i < side.trace.n_nodes(); ++i)
    EXPECT_LT((side.trace.node_normals()[i] + side.trace.node_points()[i]).norm(), 1e-12);
}

TEST(TraceCurve, PointsAndTangentsFollowACircle)
{
  const Trace arc = make_arc(2., .3, 1.1, 16, 2);
  for (const Segment &segment : arc.segments())
    for (const double s : {0., .2, .5, .77, 1.})
    {
      const Vector2 x = arc.point(segment, s), t = arc.tangent(segment, s);
      EXPECT_NEAR(x.norm(), 2., 1e-10);
      EXPECT_NEAR(t.dot(x), 0., 1e-7);
      EXPECT_NEAR(t.norm(), .8 / 16. * 2., 1e-8);
      EXPECT_GT(x.x() * t.y() - x.y() * t.x(), 0.);
    }
}

TEST(TraceCurve, NormalsAreAveragedAtGentleCornersOnly)
{
  const auto corner = [](const double degrees) {
    const Vector2 after(std::cos(degrees * M_PI / 180.), std::sin(degrees * M_PI / 180.));
    return make_curve([after](const double t) { return t < 0. ? Vector2(t, 0.) : Vector2(t * after); },
                      {-1., 0., 1.}, 1, 1);
  };
  const Trace gentle = corner(40.), sharp = corner(50.);
  const Vector2 bisector(std::sin(20. * M_PI / 180.), -std::cos(20. * M_PI / 180.));
  EXPECT_LT((gentle.segments()[0].end_normals[1] - bisector).norm(), 1e-15);
  EXPECT_LT((gentle.segments()[1].end_normals[0] - bisector).norm(), 1e-15);
  EXPECT_LT((sharp.segments()[0].end_normals[1] - Vector2(0., -1.)).norm(), 1e-15);
  EXPECT_LT((sharp.segments()[1].end_normals[1] - sharp.segments()[1].end_normals[0]).norm(), 1e-15);
  ASSERT_EQ(gentle.normals_at(1).size(), 1u);
  ASSERT_EQ(sharp.normals_at(1).size(), 2u); // a roller around a corner holds the node in both directions
  EXPECT_LT((sharp.normals_at(1)[0] - Vector2(0., -1.)).norm(), 1e-15);
  EXPECT_LT((sharp.normals_at(1)[1] - sharp.segments()[1].end_normals[0]).norm(), 1e-15);
}
