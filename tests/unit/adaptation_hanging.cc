// SPDX-License-Identifier: LGPL-2.1-or-later
// Two squares of which the right one is split: what indicators make of the hanging vertex between them.
#include <abut/adaptation/patches.h>
#include <abut/bodies/finite_elements/nodes.h>

#include "adaptation_testing.h"

using namespace abut;

namespace
{
  std::unique_ptr<FiniteElementBody> two_squares(const unsigned int degree)
  {
    auto description = make_body("rectangle", {2., 1.}, {{2, 1}});
    description.degree = degree;
    description.young_modulus = 2.6; // lambda = 1.5, mu = 1
    description.poisson_ratio = .3;
    set_conditions(description, "left: displacement: 0, 0; right: displacement: 0, 0; "
                                "top: displacement: 0, 0; bottom: displacement: 0, 0");
    auto body = std::make_unique<FiniteElementBody>(description, std::vector<std::string>());
    CellMarks marks = no_marks(body->space().mesh().triangulation);
    for (const auto &cell : body->space().mesh().triangulation.active_cell_iterators())
      marks.refine[cell->active_cell_index()] = cell->center()[0] > 1.;
    body->adapt(marks, {});
    return body;
  }

  /// |x - 1| in both components: a strain that jumps between the squares.
  Eigen::VectorXd folded(const FiniteElementBody &body)
  {
    Eigen::VectorXd u(body.space().n_dofs());
    const Nodes nodes = all_nodes(body.space());
    for (std::size_t i = 0; i < nodes.dofs.size(); ++i)
      for (unsigned int c = 0; c < 2; ++c)
        u[nodes.dofs[i][c]] = std::abs(nodes.places[i].x() - 1.);
    return u;
  }
} // namespace

TEST(AdaptationHanging, KellySeesAJumpFromBothSides)
{
  // The jumps are t_n = 2 * 3.5 and t_t = 2 * 1 all along x = 1: per length 49/3.5 + 4 of energy, and 49
  // (1 + 2 (1.5/3.5)^2) + 8 of squared stress. The cells reach 1 to the left and 1/2 to the right.
  for (const unsigned int degree : {1u, 3u})
  {
    const auto body = two_squares(degree);
    const Eigen::VectorXd u = folded(*body), none;
    const CellErrors errors = indicator_of("kelly")->estimate({*body, u, none});
    const double c = 1. / (8. * (2. * degree + 1.));
    const double energy = 49. / 3.5 + 4., stress = 49. * (1. + 2. * 2.25 / 12.25) + 8.;
    for (const auto &cell : body->space().mesh().triangulation.active_cell_iterators())
    {
      const auto i = static_cast<Eigen::Index>(cell->active_cell_index());
      const double share = cell->center()[0] < 1. ? c : cell->center()[0] < 1.5 ? c * .5 * .5 : 0.;
      EXPECT_NEAR(errors.energy[i], std::sqrt(share * energy), 1e-7) << degree;
      EXPECT_NEAR(errors.stress[i], std::sqrt(share * stress), 1e-7) << degree;
    }
  }
}

TEST(AdaptationHanging, AveragesAreContinuous)
{
  // sigma_xx is -3.5 on the left and 3.5 on the right; by areas it is -2.1 at (1, 0) and (1, 1), and so it
  // has to be at the hanging vertex between them. The left cell sees a change from 0 to 1.4, linear in x.
  const auto body = two_squares(1);
  const Eigen::VectorXd u = folded(*body), none;
  const CellErrors errors = indicator_of("zz")->estimate({*body, u, none});
  // Changes from -3.5 to -2.1, and from 3.5 to -2.1, in xx; those of yy, zz and xy are 1.5/3.5, 1.5/3.5,
  // 1/3.5 of that. int over a cell of a linear function from 0 to a: area a^2/3.
  const double parts = 1. + 2. * 2.25 / 12.25 + 2. / 12.25;
  const double zz_xx = .3 * (1. + 1.5 / 3.5) - 1.5 / 3.5; // what nu (xx + yy) makes of it
  EXPECT_NEAR(zz_xx, 0., 1e-15);
  for (const auto &cell : body->space().mesh().triangulation.active_cell_iterators())
  {
    const double x = cell->center()[0];
    const double square = x < 1. ? 1.4 * 1.4 / 3. : x < 1.5 ? .25 * 5.6 * 5.6 / 3. : 0.;
    EXPECT_NEAR(errors.stress[static_cast<Eigen::Index>(cell->active_cell_index())],
                std::sqrt(square * parts), 1e-12);
  }
}

TEST(AdaptationHanging, PatchesOfHangingVerticesHoldTheCoarseCell)
{
  const auto body = two_squares(1);
  const auto &vertices = body->space().mesh().triangulation.get_vertices();
  const auto size_at = [&](const double x, const double y, const std::size_t fewest) {
    for (const auto &[centre, patch] : vertex_patches(body->space(), fewest))
      if (vertices[centre.vertex].distance({x, y}) < 1e-12)
        return patch.size();
    return std::size_t(0);
  };
  EXPECT_EQ(size_at(1., .5, 1), 3u);
  EXPECT_EQ(size_at(1.5, .5, 1), 4u);
  EXPECT_EQ(size_at(0., 0., 1), 1u);
  EXPECT_EQ(size_at(1., 0., 1), 2u);
  // Grown: the corner of the coarse cell by the cells at (1, 0) and (1, 1), that at (1, 0) by all the others.
  EXPECT_EQ(size_at(0., 0., 4), 3u);
  EXPECT_EQ(size_at(1., 0., 4), 5u);
}
