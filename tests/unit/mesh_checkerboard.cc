// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/mesh/checkerboard.h>

#include "mesh_testing.h"
#include <cmath>
#include <functional>

using namespace abut;

namespace
{
  constexpr int n = 8;

  /// Of the centres of the cells.
  Eigen::VectorXd cell_values(const dealii::Triangulation<2> &triangulation,
                              const std::function<double(double x, double y)> &field)
  {
    Eigen::VectorXd values(triangulation.n_active_cells());
    for (const auto &cell : triangulation.active_cell_iterators())
      values[cell->active_cell_index()] = field(cell->center()[0], cell->center()[1]);
    return values;
  }

  double alternating(const double x, const double y)
  {
    return (std::lround(n * x - .5) + std::lround(n * y - .5)) % 2 == 0 ? 1. : -1.;
  }
} // namespace

TEST(MeshCheckerboard, IsAllOfACheckerboardAndNothingOfAPlane)
{
  const auto mesh = make_mesh(make_body("rectangle", {1., 1.}, {{n, n}}));
  const dealii::Triangulation<2> &triangulation = mesh->triangulation;
  const Eigen::VectorXd board = cell_values(triangulation, alternating);
  const Eigen::VectorXd plane =
      cell_values(triangulation, [](const double x, const double y) { return 3. + 2. * x - y; });
  EXPECT_LT((checkerboard(triangulation, board) - board).norm(), 1e-14);
  EXPECT_LT(checkerboard(triangulation, plane).norm(), 1e-13);
}

TEST(MeshCheckerboard, IsOfFourthOrderInside)
{
  const auto mesh = make_mesh(make_body("rectangle", {1., 1.}, {{n, n}}));
  const dealii::Triangulation<2> &triangulation = mesh->triangulation;
  const auto field = [](const double x, const double y) { return std::sin(x) * std::cos(y); };
  const Eigen::VectorXd found = checkerboard(triangulation, cell_values(triangulation, field));
  const double h = 1. / n;
  for (const auto &cell : triangulation.active_cell_iterators())
  {
    const bool inside = !cell->at_boundary();
    EXPECT_LE(std::abs(found[cell->active_cell_index()]), inside ? std::pow(h, 4) / 16. : h * h / 4.);
  }
}

// A split cell: its neighbours see fewer vertices where four cells meet, but no wrong ones.
TEST(MeshCheckerboard, NextToHangingNodesAPlaneHasNone)
{
  const auto mesh = make_mesh(make_body("rectangle", {1., 1.}, {{4, 4}}));
  dealii::Triangulation<2> &triangulation = mesh->triangulation;
  triangulation.begin_active()->set_refine_flag();
  triangulation.execute_coarsening_and_refinement();
  const Eigen::VectorXd found =
      checkerboard(triangulation, Eigen::VectorXd::Ones(triangulation.n_active_cells()));
  EXPECT_LT(found.norm(), 1e-14);
}
