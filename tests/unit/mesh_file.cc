// SPDX-License-Identifier: LGPL-2.1-or-later
// Gmsh files: those that can be used and those that are refused.
#include "mesh_testing.h"
#include <cstdio>
#include <fstream>

using namespace abut;

namespace
{
  BodyDescription body_from(const std::string &path)
  {
    BodyDescription body = make_body("mesh file", {}, {{1, 1}});
    body.mesh_path = path;
    body.mesh_file = path.substr(path.rfind('/') + 1);
    return body;
  }

  BodyDescription body_from_data(const std::string &file)
  {
    return body_from(std::string(ABUT_SOURCE_DIR) + "/tests/data/" + file);
  }

  /// Writes a file of format 2.2 and returns its path.
  std::string file_of(const std::string &nodes, const std::string &elements)
  {
    const auto *test = testing::UnitTest::GetInstance()->current_test_info();
    const std::string path = testing::TempDir() + "/abut_" + test->name() + ".msh";
    std::ofstream(path) << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n"
                        << nodes << "$EndNodes\n$Elements\n"
                        << elements << "$EndElements\n";
    return path;
  }

  /// Writes a file of format 2.2, reads it, expects a refusal that names the file and says `part`.
  void expect_file_refused(const std::string &nodes, const std::string &elements, const std::string &part)
  {
    const std::string path = file_of(nodes, elements);
    expect_refused([&] { make_mesh(body_from(path)); }, "Body block/Mesh file abut_");
    expect_refused([&] { make_mesh(body_from(path)); }, part);
    std::remove(path.c_str());
  }

  const std::string square = "4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n";
} // namespace

TEST(MeshFile, QuadrilateralsOfVersion22)
{
  // Two trapezoids, one of them written clockwise; line 7 on the left, line 3 on the top, no line elsewhere.
  const auto mesh = make_mesh(body_from_data("quadrilaterals_2_2.msh"));
  EXPECT_EQ(mesh->cell_type, CellType::quadrilaterals);
  EXPECT_FALSE(mesh->curved);
  EXPECT_EQ(mesh->triangulation.n_active_cells(), 2u);
  EXPECT_NEAR(area(*mesh, 1), 2., 1e-14);
  EXPECT_GT(smallest_jacobian(*mesh, 1), 0.5);
  EXPECT_EQ(mesh->boundaries.size(), 3u);
  EXPECT_EQ(boundary_id(*mesh, "7"), 7u);
  EXPECT_NEAR(side_length(*mesh, "7", 1), 1., 1e-14);
  EXPECT_NEAR(side_length(*mesh, "3", 1), 2., 1e-14);
  EXPECT_NEAR(side_length(*mesh, "0", 1), 3., 1e-14);
  expect_all_sides_named(*mesh);
}

TEST(MeshFile, TrianglesOfVersion41Mirrored)
{
  auto body = body_from_data("triangles_4_1.msh");
  body.placement = Placement(2., true, 90., {5., 0.});
  const auto mesh = make_mesh(body);
  EXPECT_EQ(mesh->cell_type, CellType::triangles);
  EXPECT_EQ(mesh->triangulation.n_active_cells(), 4u);
  EXPECT_NEAR(area(*mesh, 1), 24., 1e-13);
  EXPECT_EQ(mesh->boundaries.size(), 4u);
  EXPECT_NEAR(side_length(*mesh, "1", 1), 6., 1e-13);
  EXPECT_NEAR(side_length(*mesh, "2", 1), 4., 1e-13);
  for_each_edge(body, *mesh, "4", [](const Vector2 &a, const Vector2 &b) {
    EXPECT_NEAR(a.x(), 0., 1e-14);
    EXPECT_NEAR(b.x(), 0., 1e-14);
  });
}

TEST(MeshFile, DepthIsTheExtentAlongTheNormal)
{
  const auto body = body_from_data("quadrilaterals_2_2.msh");
  const auto mesh = make_mesh(body);
  EXPECT_NEAR(contact_depth(body, *mesh, 3), 1., 1e-14);
  EXPECT_NEAR(contact_depth(body, *mesh, 7), 2., 1e-14);
}

TEST(MeshFile, QuadrilateralsAmongTrianglesAreCutAndTheUserHearsOfIt)
{
  const auto mesh = make_mesh(body_from_data("mixed_2_2.msh")); // a quadrilateral and a triangle
  EXPECT_EQ(mesh->cell_type, CellType::triangles);
  EXPECT_EQ(mesh->triangulation.n_active_cells(), 3u);
  ASSERT_EQ(mesh->warnings.size(), 1u);
  EXPECT_EQ(mesh->warnings[0].code, WarningCode::cells_cut);
  EXPECT_NE(mesh->warnings[0].text.find("its 1 quadrilaterals"), std::string::npos) << mesh->warnings[0].text;
  EXPECT_GT(smallest_jacobian(*mesh, 1), 0.);
}

TEST(MeshFile, MissingIsRefused)
{
  expect_refused([] { make_mesh(body_from_data("missing.msh")); }, "missing.msh: cannot be opened");
}

TEST(MeshFile, FolderIsRefused)
{
  expect_refused([] { make_mesh(body_from_data("")); }, "Mesh file");
}

TEST(MeshFile, OtherFormatIsRefused)
{
  expect_refused([] { make_mesh(body_from(std::string(ABUT_SOURCE_DIR) + "/CMakeLists.txt")); },
                 "Mesh file CMakeLists.txt: received a file with the ending `.txt`, allowed are .msh");
}

TEST(MeshFile, EmptyIsRefused)
{
  expect_refused([] { make_mesh(body_from("/dev/null")); }, "Mesh file null: ");
}

TEST(MeshFile, NodesThatEndEarlyAreRefused)
{
  expect_file_refused("9\n1 0 0 0\n2 1 0 0\n", "1\n1 3 2 1 1 1 2 3 4\n", "it is damaged, ends early");
}

TEST(MeshFile, ElementsThatEndEarlyAreRefused)
{
  expect_file_refused(square, "5\n1 3 2 1 1 1 2 3 4\n", "it is damaged, ends early");
}

TEST(MeshFile, UnknownNodesAreRefused)
{
  expect_file_refused(square, "1\n1 3 2 1 1 1 2 3 9\n", "it is damaged");
}

TEST(MeshFile, CellsOfThirdOrderAreRefused)
{
  expect_file_refused("10\n1 0 0 0\n2 3 0 0\n3 0 3 0\n4 1 0 0\n5 2 0 0\n6 2 1 0\n7 1 2 0\n8 0 2 0\n9 0 1 0\n"
                      "10 1 1 0\n",
                      "1\n1 21 2 1 1 1 2 3 4 5 6 7 8 9 10\n", "of order 3, allowed are 1 and 2");
}

TEST(MeshFile, SolidsAreRefused)
{
  expect_file_refused("4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 1\n", "1\n1 4 2 1 1 1 2 3 4\n",
                      "it holds a solid");
}

TEST(MeshFile, LeavingThePlaneIsRefused)
{
  expect_file_refused("4\n1 0 0 0\n2 1 0 0\n3 1 1 .5\n4 0 1 .5\n", "2\n1 1 2 1 1 1 2\n2 3 2 1 1 1 2 3 4\n",
                      "leaves the plane z = 0");
}

TEST(MeshFile, NoPhysicalLinesAreRefused)
{
  expect_file_refused(square, "1\n1 3 2 1 1 1 2 3 4\n", "no edge of its boundary belongs to a physical line");
}

TEST(MeshFile, ALineInsideIsNoSide)
{
  const std::string path =
      file_of(square, "4\n1 1 2 5 1 1 3\n2 1 2 6 2 1 2\n3 2 2 1 1 1 2 3\n4 2 2 1 1 1 3 4\n");
  const auto mesh = make_mesh(body_from(path));
  expect_refused([&] { boundary_id(*mesh, "5"); },
                 "has no side '5'; its sides are 0 from (0, 0) to (1, 0), 6 from (0, 0) to (1, 0)");
}

TEST(MeshFile, FoldedCellsAreRefusedWithTheirPlace)
{
  // The third vertex of the second triangle lies on the first one's side of their common edge.
  expect_file_refused("4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 .1 .2 0\n",
                      "3\n1 1 2 1 1 1 2\n2 2 2 1 1 1 2 3\n3 2 2 1 1 2 4 3\n",
                      "lie on each other at (0.5, 0.5)");
}

TEST(MeshFile, ALineOfTwoSidesIsRefused)
{
  expect_file_refused(square, "3\n1 1 2 5 1 1 2\n2 1 2 6 1 2 3\n3 3 2 1 1 1 2 3 4\n",
                      "belongs to the physical lines 5 and 6");
}

TEST(MeshFile, SeveralPartsAreRefused)
{
  expect_file_refused("8\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 3 0 0\n6 4 0 0\n7 4 1 0\n8 3 1 0\n",
                      "3\n1 1 2 1 1 1 2\n2 3 2 1 1 1 2 3 4\n3 3 2 1 1 5 6 7 8\n", "several parts");
}

TEST(MeshFile, CrossedCellIsRefused)
{
  expect_file_refused(square, "2\n1 1 2 1 1 1 2\n2 3 2 1 1 1 2 4 3\n", "too distorted");
}

TEST(MeshFile, FlatCellIsRefused)
{
  expect_file_refused("3\n1 0 0 0\n2 1 0 0\n3 2 0 0\n", "2\n1 1 2 1 1 1 2\n2 2 2 1 1 1 2 3\n",
                      "too distorted");
}

TEST(MeshFile, ThreeCellsAtAnEdgeAreRefused)
{
  expect_file_refused("5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 1 2 0\n5 1 -1 0\n",
                      "4\n1 1 2 1 1 1 3\n2 2 2 1 1 1 2 3\n3 2 2 1 1 1 2 4\n4 2 2 1 1 1 2 5\n", "Mesh file");
}
