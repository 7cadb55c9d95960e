// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A body whose mesh processes share beside the same body with a mesh of its own, in each of them.

#include <abut/base/gathered.h>
#include <abut/base/launch.h>
#include <abut/base/user_error.h>
#include <abut/bodies/finite_elements/finite_element_body.h>
#include <abut/scene/condition.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

using namespace abut;

namespace
{
  /// All that mpirun has started: MPI begins and ends once.
  std::shared_ptr<Processes> all_processes()
  {
    static const auto processes = std::make_shared<Processes>(Launch::from_environment());
    return processes;
  }

  BodyDescription plate(const std::array<unsigned int, 2> &cells)
  {
    BodyDescription body;
    body.name = "plate";
    body.shape = "rectangle";
    body.size = {2., 1.};
    body.cells = cells;
    body.young_modulus = 7.;
    body.poisson_ratio = .3;
    body.shares_mesh = true;
    body.body_force = {Expression("x*y", {}, "force"), Expression("y", {}, "force")};
    body.conditions = parse_conditions("left: displacement: 0, 0; right: traction: 0.1, 0.2", {}, "plate");
    return body;
  }

  const Vector2 inside(.37, .61); // no vertex

  void adapt(FiniteElementBody &body, std::vector<Eigen::VectorXd> &fields)
  {
    CellMarks marks = no_marks(body.counts().cells);
    const std::vector<CellInfo> cells = body.cells();
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      marks.refine[i] = (cells[i].centre - Vector2(.5, .5)).norm() < .3;
      marks.coarsen[i] = cells[i].centre.x() > 1.2;
    }
    fields = body.adapt(marks, fields);
  }

  void expect_same_answers(FiniteElementBody &alone, FiniteElementBody &shared)
  {
    constexpr double accuracy = 1e-9; // iterations end at 1e-12 of the right side
    shared.share(all_processes());
    alone.prepare();
    shared.prepare();
    ASSERT_EQ(shared.counts().cells, alone.counts().cells);
    ASSERT_EQ(shared.counts().dofs, alone.counts().dofs);
    EXPECT_EQ(shared.counts().boundary_dofs, alone.counts().boundary_dofs);
    const Eigen::VectorXd forces = Eigen::VectorXd::LinSpaced(alone.trace_size(), -1., 2.);
    const Eigen::VectorXd expected = alone.respond(forces), found = shared.respond(forces);
    EXPECT_LT((found - expected).norm(), accuracy * expected.norm());
    const Eigen::VectorXd u = alone.deformation(forces, 0.), v = shared.deformation(forces, 0.);
    const double energy = alone.strain_energy(u);
    EXPECT_NEAR(shared.strain_energy(v), energy, accuracy * energy);
    const Vector2 there = alone.displacement_at(u, inside);
    EXPECT_LT((shared.displacement_at(v, inside) - there).norm(), accuracy * there.norm());
    EXPECT_NEAR(shared.stress_at(v, inside)->von_mises(), alone.stress_at(u, inside)->von_mises(),
                accuracy * alone.stress_at(u, inside)->von_mises());
    EXPECT_NEAR(shared.data_oscillation().norm(), alone.data_oscillation().norm(),
                accuracy * alone.data_oscillation().norm());
    const Vector2 reaction = alone.reactions(u, forces).by_boundary.at("left");
    EXPECT_LT((shared.reactions(v, forces).by_boundary.at("left") - reaction).norm(),
              accuracy * reaction.norm());
    EXPECT_NEAR(shared.mesh_quality().h_max, alone.mesh_quality().h_max, accuracy);
  }

  TEST(DistributedMesh, AnswersAsTheWholeOne)
  {
    for (const auto &cells : {std::array<unsigned int, 2>{{12, 8}}, {{5, 7}}})
      for (const unsigned int degree : {1u, 2u})
      {
        BodyDescription description = plate(cells);
        description.degree = degree;
        FiniteElementBody alone(description, {"top"}), shared(description, {"top"}, all_processes());
        expect_same_answers(alone, shared);
        std::vector<Eigen::VectorXd> carried = {alone.deformation(Eigen::VectorXd::Zero(alone.trace_size()),
                                                                  0.)},
                                     of_shared = {
                                         shared.deformation(Eigen::VectorXd::Zero(shared.trace_size()), 0.)};
        for (unsigned int pass = 0; pass < 3; ++pass)
        {
          adapt(alone, carried);
          adapt(shared, of_shared);
          EXPECT_TRUE(alone.space().has_hanging_nodes());
          const Vector2 there = alone.displacement_at(carried[0], inside);
          EXPECT_LT((shared.displacement_at(of_shared[0], inside) - there).norm(), 1e-9 * there.norm());
          expect_same_answers(alone, shared);
        }
      }
  }

  TEST(DistributedMesh, IsNotTheSameInAllProcesses)
  {
    const FiniteElementBody body(plate({{64, 32}}), {"top"}, all_processes());
    const auto own = body.space().own_cells();
    const auto n_own = static_cast<std::size_t>(std::distance(own.begin(), own.end()));
    const std::vector<std::size_t> of_all = gathered<std::size_t>(all_processes(), {n_own});
    const std::size_t n = body.counts().cells, share = n / all_processes()->size();
    EXPECT_EQ(std::accumulate(of_all.begin(), of_all.end(), std::size_t(0)), n);
    EXPECT_NEAR(static_cast<double>(n_own), static_cast<double>(share), 4.); // brothers stay together
    EXPECT_LT(body.space().mesh().triangulation.n_active_cells(), 2 * share);
  }

  TEST(DistributedMesh, HasTheSameSamplesInAllProcesses)
  {
    const FiniteElementBody body(plate({{12, 8}}), {"top"}, all_processes());
    std::vector<double> areas(body.counts().cells);
    body.visit_stress(
        Eigen::VectorXd::Zero(body.space().n_dofs()), SamplePoints::energy,
        [&](const SamplePoint &point, const Stress &) { areas.at(point.cell) += point.weight; });
    for (const double area : areas)
      EXPECT_NEAR(area, 2. / 96., 1e-14);
    EXPECT_EQ(body.cells_at(Vector2(1., .5)).size(), 4u);
    EXPECT_THROW(body.displacement_at(Eigen::VectorXd::Zero(body.space().n_dofs()), Vector2(3., 0.)),
                 UserError);
  }
} // namespace
