// SPDX-License-Identifier: LGPL-2.1-or-later
// Marked cells: the 2:1 rule, the deepest level, what is never merged.
#include <abut/mesh/cell_marks.h>

#include "mesh_testing.h"
#include <random>

using namespace abut;

namespace
{
  using Triangulation = dealii::Triangulation<2>;

  std::unique_ptr<BodyMesh> unit_square(const CellType type, const unsigned int n)
  {
    auto body = make_body("rectangle", {1., 1.}, {{n, n}});
    body.cell_type = type;
    return make_mesh(body);
  }

  void change_mesh(Triangulation &triangulation, const CellMarks &marks)
  {
    set_flags(triangulation, marks);
    triangulation.execute_coarsening_and_refinement();
  }

  /// The largest difference of levels across an edge; the cells have to fill the square.
  int largest_step(const Triangulation &triangulation)
  {
    int step = 0;
    double sum = 0.;
    for (const auto &cell : triangulation.active_cell_iterators())
    {
      sum += cell->measure();
      for (const unsigned int f : cell->face_indices())
        if (!cell->at_boundary(f))
        {
          step = std::max(step, cell->level() - cell->neighbor(f)->level());
          const auto face = cell->face(f); // from the coarse side
          for (unsigned int half = 0; half < face->n_children(); ++half)
            step = std::max(step, face->child(half)->has_children() ? 2 : 1);
        }
    }
    EXPECT_NEAR(sum, 1., 1e-12);
    return step;
  }

  /// Splits, of the cells of the highest level, the one for which `badness` is largest.
  template <typename Badness> void split_worst(Triangulation &triangulation, const Badness &badness)
  {
    const auto deepest = static_cast<int>(triangulation.n_levels()) - 1;
    unsigned int worst = 0;
    double largest = -1.;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->level() == deepest && badness(cell) > largest)
      {
        largest = badness(cell);
        worst = cell->active_cell_index();
      }
    CellMarks marks = no_marks(triangulation);
    marks.refine[worst] = true;
    change_mesh(triangulation, marks);
  }

  const CellType both_types[] = {CellType::quadrilaterals, CellType::triangles};
} // namespace

TEST(MeshMarks, NeighboursDifferByOneLevelWhenAChildNextToACoarseCellIsSplit)
{
  for (const CellType type : both_types)
  {
    const auto mesh = unit_square(type, 2);
    for (int pass = 0; pass < 8; ++pass)
    {
      split_worst(mesh->triangulation, [](const auto &cell) {
        double coarser = 0.;
        for (const unsigned int f : cell->face_indices())
          coarser += !cell->at_boundary(f) && cell->neighbor(f)->level() < cell->level();
        return coarser;
      });
      EXPECT_LE(largest_step(mesh->triangulation), 1) << pass;
    }
    EXPECT_EQ(mesh->triangulation.n_levels(), 9u);
  }
}

TEST(MeshMarks, NeighboursDifferByOneLevelTowardsAPlaceInsideACell)
{
  // Next to the middle of the square, so that each split reaches into all the coarse cells around it.
  for (const CellType type : both_types)
  {
    const auto mesh = unit_square(type, 2);
    for (int pass = 0; pass < 10; ++pass)
    {
      split_worst(mesh->triangulation, [](const auto &cell) {
        return 2. - cell->center().distance({.5 + 1e-4, .5 - 2e-4});
      });
      EXPECT_LE(largest_step(mesh->triangulation), 1) << pass;
    }
  }
}

TEST(MeshMarks, NeighboursDifferByOneLevelWhateverIsMarked)
{
  std::mt19937 random(1);
  for (const CellType type : both_types)
    for (int mesh = 0; mesh < 10; ++mesh)
    {
      const auto square_mesh = unit_square(type, 3);
      Triangulation &triangulation = square_mesh->triangulation;
      for (int pass = 0; pass < 12; ++pass)
      {
        CellMarks marks = no_marks(triangulation);
        for (int i = 0; i < 4; ++i)
          marks.refine[random() % marks.refine.size()] = true;
        for (std::size_t i = 0; i < marks.coarsen.size(); ++i)
          marks.coarsen[i] = !marks.refine[i] && random() % 2 == 0;
        change_mesh(triangulation, marks);
        EXPECT_LE(largest_step(triangulation), 1) << mesh << " " << pass;
      }
      EXPECT_GT(triangulation.n_levels(), 2u);
    }
}

TEST(MeshMarks, TheDeepestLevelIsNotSplit)
{
  for (const CellType type : both_types)
  {
    const auto mesh = unit_square(type, 1);
    Triangulation &triangulation = mesh->triangulation;
    for (int pass = 0; pass < 33; ++pass)
      split_worst(triangulation, [](const auto &cell) { return 2. - cell->center().norm(); });
    EXPECT_EQ(triangulation.n_levels(), 31u);
    EXPECT_LE(largest_step(triangulation), 1);
    for (const auto &cell : triangulation.active_cell_iterators())
      EXPECT_GT(cell->measure(), 0.);
  }
}

TEST(MeshMarks, OnlyQuadrilateralsAreMerged)
{
  for (const CellType type : both_types)
  {
    const auto mesh = unit_square(type, 2);
    Triangulation &triangulation = mesh->triangulation;
    const unsigned int n = triangulation.n_active_cells();
    change_mesh(triangulation, {std::vector<bool>(n, true), std::vector<bool>(n, false), {}});
    EXPECT_EQ(triangulation.n_active_cells(), 4 * n);
    change_mesh(triangulation, {std::vector<bool>(4 * n, false), std::vector<bool>(4 * n, true), {}});
    EXPECT_EQ(triangulation.n_active_cells(), type == CellType::triangles ? 4 * n : n);
    if (type == CellType::quadrilaterals)
      // The initial cells cannot be merged: marks on them are no mistake.
      change_mesh(triangulation, {std::vector<bool>(n, false), std::vector<bool>(n, true), {}});
    EXPECT_EQ(triangulation.n_active_cells(), type == CellType::triangles ? 4 * n : n);
  }
}

TEST(MeshMarks, TellWhetherThereIsAnythingToDo)
{
  const auto mesh = unit_square(CellType::quadrilaterals, 2);
  CellMarks marks = no_marks(mesh->triangulation);
  EXPECT_EQ(marks.refine.size(), 4u);
  EXPECT_FALSE(marks.any());
  marks.coarsen[3] = true;
  EXPECT_TRUE(marks.any());
  marks = no_marks(mesh->triangulation);
  marks.refine[0] = true;
  EXPECT_TRUE(marks.any());
}

TEST(MeshGrading, SplitsCellsThatTouchAPlaceOnASideOrAtAVertex)
{
  struct Case
  {
    Vector2 place;
    std::size_t there; // cells of the deepest level that touch it
  };
  for (const Case &at : {Case{{.3, 1.}, 1}, Case{{.5, 1.}, 2}, Case{{0., 0.}, 1}, Case{{.5, .5}, 4}})
  {
    const auto mesh = unit_square(CellType::quadrilaterals, 2);
    grade(mesh->triangulation, {{at.place, 4}, {{0., .123}, 0}});
    EXPECT_EQ(mesh->triangulation.n_levels(), 5u);
    EXPECT_LE(largest_step(mesh->triangulation), 1);
    std::size_t there = 0;
    for (const auto &cell : mesh->triangulation.active_cell_iterators())
      if (cell->point_inside({at.place.x(), at.place.y()}))
      {
        EXPECT_EQ(cell->level(), 4);
        ++there;
      }
    EXPECT_EQ(there, at.there);
  }
}

TEST(MeshGrading, StopsAtTheDeepestLevel)
{
  const auto mesh = unit_square(CellType::quadrilaterals, 1);
  grade(mesh->triangulation, {{{1., 1.}, 40}});
  EXPECT_EQ(mesh->triangulation.n_levels(), 31u);
}

TEST(MeshMarks, CellsAtCurvedBordersBetweenMaterialsAreSplitOnBothSides)
{
  for (const CellType type : {CellType::quadrilaterals, CellType::triangles})
    for (const bool curved : {true, false})
    {
      const auto mesh = unit_square(type, 4);
      Triangulation &triangulation = mesh->triangulation;
      for (const auto &cell : triangulation.active_cell_iterators())
        cell->set_material_id(cell->center()[0] < .5 ? 1 : 2);
      for (int pass = 0; pass < 3; ++pass) // the cells left of (.5, .3)
      {
        CellMarks marks = no_marks(triangulation);
        for (const auto &cell : triangulation.active_cell_iterators())
          marks.refine[cell->active_cell_index()] =
              cell->material_id() == 1 && cell->center().distance({.5, .3}) < cell->diameter();
        set_flags(triangulation, marks);
        complete_flags(triangulation, curved);
        triangulation.execute_coarsening_and_refinement();
      }
      EXPECT_EQ(largest_step(triangulation), 1);
      unsigned int n_uneven = 0;
      for (const auto &cell : triangulation.active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
          if (!cell->at_boundary(f) && cell->neighbor(f)->material_id() != cell->material_id())
            n_uneven += cell->face(f)->has_children() || cell->neighbor_is_coarser(f);
      EXPECT_EQ(n_uneven == 0, curved);
    }
}
