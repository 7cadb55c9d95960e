// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What is carried over to new meshes, and what it is good for.
#include <abut/adaptation/marking.h>
#include <abut/decomposition/interface_solver.h>
#include <abut/run/estimate.h>
#include <abut/run/model.h>

#include <gtest/gtest.h>

#include "../space_of.h"
#include <iostream>

using namespace abut;

namespace
{
  Scene layers(const std::vector<std::string> &more = {})
  {
    std::vector<std::string> overrides = {"Body upper/Cells=12, 3", "Body lower/Cells=16, 4"};
    overrides.insert(overrides.end(), more.begin(), more.end());
    return Scene::read(ABUT_SOURCE_DIR "/prm/two-layers-rollers.prm", overrides);
  }

  std::vector<CellMarks> marks(const Model &model, const bool refine)
  {
    std::vector<CellMarks> result;
    for (const auto &body : model.bodies())
    {
      result.push_back(no_marks(body->counts().cells));
      (refine ? result.back().refine : result.back().coarsen).assign(result.back().refine.size(), true);
    }
    return result;
  }

  /// Any displacements, and any pressures that do not pull.
  CarriedState random_state(const Model &model)
  {
    std::srand(5);
    CarriedState state;
    for (const auto &body : model.bodies())
      state.displacements.push_back(space_of(*body).hanging_node_expansion() *
                                    Eigen::VectorXd::Random(space_of(*body).n_dofs()));
    state.pressures = Eigen::VectorXd::Random(model.problem().n_pressures()).cwiseAbs();
    return state;
  }

  void expect_same(const CarriedState &a, const CarriedState &b)
  {
    ASSERT_EQ(a.pressures.size(), b.pressures.size());
    EXPECT_LT((a.pressures - b.pressures).lpNorm<Eigen::Infinity>(), 1e-14);
    for (std::size_t body = 0; body < a.displacements.size(); ++body)
    {
      ASSERT_EQ(a.displacements[body].size(), b.displacements[body].size());
      EXPECT_LT((a.displacements[body] - b.displacements[body]).lpNorm<Eigen::Infinity>(), 1e-14);
    }
  }

  class CarriedOver : public testing::TestWithParam<const char *>
  {};

  TEST_P(CarriedOver, there_and_back_changes_no_field)
  {
    const Scene scene = layers({std::string("Discretisation/Degree=") + GetParam()});
    Model model(scene, nullptr);
    const CarriedState before = random_state(model);
    const CarriedState finer = model.adapt(marks(model, true), before).state;
    EXPECT_GT(finer.pressures.size(), before.pressures.size());
    EXPECT_GE(finer.pressures.minCoeff(), 0.);
    EXPECT_LE(finer.pressures.maxCoeff(), before.pressures.maxCoeff() * (1. + 1e-12));
    CarriedState back = model.adapt(marks(model, false), finer).state;
    // Pressures are means over new parts: back on the old ones those of neighbours are mixed in.
    EXPECT_LT((back.pressures - before.pressures).lpNorm<Eigen::Infinity>(), before.pressures.maxCoeff());
    back.pressures = before.pressures;
    expect_same(back, before);
  }

  INSTANTIATE_TEST_SUITE_P(Degree, CarriedOver, testing::Values("1", "2", "3"));

  TEST(Model, observes_its_answer_to_pressures_as_the_interface_problem_does)
  {
    const Scene scene = layers();
    Model model(scene, nullptr);
    model.prepare();
    const InterfaceProblem &problem = model.problem();
    const Eigen::VectorXd pressures = Eigen::VectorXd::LinSpaced(problem.n_pressures(), 1., 2.);
    const Eigen::VectorXd expected =
        problem.loads(0.).response + make_compliance(problem, ComplianceMode::solves, 0.)->apply(pressures);
    const Eigen::VectorXd response = model.observe(model.respond(pressures));
    EXPECT_LT((response - expected).norm(), 1e-12 * expected.norm());
  }

  TEST(Model, refining_keeps_the_applied_force)
  {
    const Scene scene = layers();
    Model model(scene, nullptr);
    const CarriedState before = random_state(model);
    const auto force = [&](const CarriedState &state) {
      return model.problem().weights().dot(state.pressures);
    };
    const double coarse = force(before);
    EXPECT_NEAR(force(model.adapt(marks(model, true), before).state), coarse, 1e-13 * coarse);
  }

  TEST(Model, uniform_pressures_stay_uniform)
  {
    const Scene scene = layers();
    Model model(scene, nullptr);
    CarriedState state = random_state(model);
    state.pressures.setConstant(3.);
    state = model.adapt(marks(model, true), state).state;
    EXPECT_LT((state.pressures.array() - 3.).abs().maxCoeff(), 1e-13);
  }

  TEST(Model, a_body_without_marks_keeps_its_mesh_and_a_pair_of_two_such_bodies_its_coupling)
  {
    const Scene scene = layers();
    Model model(scene, nullptr);
    std::vector<CellMarks> only_lower = marks(model, true);
    only_lower[scene.body_index("upper")] =
        no_marks(model.bodies()[scene.body_index("upper")]->counts().cells);
    EXPECT_TRUE(model.adapt(only_lower, random_state(model)).some_mesh_changed);
    EXPECT_EQ(model.bodies()[scene.body_index("upper")]->counters().meshes, 1u);
    EXPECT_EQ(model.bodies()[scene.body_index("lower")]->counters().meshes, 2u);
  }

  TEST(Model, marks_that_cannot_be_followed_change_nothing)
  {
    const Scene scene = layers();
    Model model(scene, nullptr);
    const CarriedState before = random_state(model);
    const Adapted adapted = model.adapt(marks(model, false), before); // nothing to merge on the initial mesh
    EXPECT_FALSE(adapted.some_mesh_changed);
    expect_same(adapted.state, before);
    for (const auto &body : model.bodies())
      EXPECT_EQ(body->counters().meshes, 1u);
  }

  /// Cells here and there, the same in every run.
  std::vector<CellMarks> scattered_marks(const Model &model, const unsigned int pass)
  {
    std::vector<CellMarks> result = marks(model, true);
    for (std::size_t a = 0; a < result.size(); ++a)
      for (std::size_t cell = 0; cell < result[a].refine.size(); ++cell)
        result[a].refine[cell] = (7 * cell + 3 * a + pass) % 5 < 2;
    return result;
  }

  TEST(Model, passes_the_patch_test_on_meshes_with_hanging_nodes_on_both_sides)
  {
    for (const std::string degree : {"1", "2", "3"})
    {
      const Scene scene =
          Scene::read(ABUT_SOURCE_DIR "/prm/patch-test.prm", {"Discretisation/Degree=" + degree});
      Model model(scene, nullptr);
      for (unsigned int pass = 0; pass < 4; ++pass)
        model.adapt(scattered_marks(model, pass), random_state(model));
      for (const auto &body : model.bodies())
        EXPECT_TRUE(space_of(*body).has_hanging_nodes());
      model.prepare();
      const SchemeResult result =
          InterfaceSolver(model.problem(), scene.decomposition).solve(model.problem().loads(0.), {}, {});
      ASSERT_TRUE(result.converged()) << result.message;
      const double exact = 1e-3 / (2. * .91e-2 + .05 * 1e-2);
      EXPECT_LT((result.traction.array() / exact - 1.).abs().maxCoeff(), 1e-9) << "degree " << degree;
    }
  }

  class WarmStart : public testing::TestWithParam<std::string>
  {};

  TEST_P(WarmStart, saves_steps_on_adapted_meshes)
  {
    const Scene scene =
        layers({"Contact interface/Penalty coefficient=5e-3", "Decomposition/Scheme=" + GetParam()});
    Model model(scene, nullptr);
    AdaptationParameters adaptation;
    adaptation.estimator = "zz";
    const auto indicator = make_indicator(adaptation);
    CarriedState state;
    unsigned int all_warm = 0, all_cold = 0;
    for (unsigned int pass = 0; pass < 5; ++pass)
    {
      model.prepare();
      const InterfaceSolver solver(model.problem(), scene.decomposition);
      const auto loads = model.problem().loads(0.);
      const SchemeResult cold = solver.solve(loads, {}, {}, 1e-4);
      ASSERT_TRUE(cold.converged());
      if (pass > 0)
      {
        const SchemeResult warm = solver.solve(loads, state.pressures, {}, 1e-4);
        ASSERT_TRUE(warm.converged());
        all_warm += warm.steps;
        all_cold += cold.steps;
      }
      state = {{}, cold.traction};
      std::vector<CellMarks> chosen;
      for (std::size_t a = 0; a < model.bodies().size(); ++a)
      {
        const Body &body = *model.bodies()[a];
        const Eigen::VectorXd forces = model.problem().contact_forces(a, cold.traction);
        const Eigen::VectorXd deformation = body.deformation(forces, 0.);
        const CellErrors errors = indicator->estimate({body, deformation, forces});
        chosen.push_back(mark(errors, relative_errors(errors, Normalisation::rms), scene.adaptation));
        state.displacements.push_back(deformation);
      }
      state = model.adapt(chosen, state).state;
    }
    std::cout << "steps to 1e-4 on four adapted meshes: " << all_warm
              << " with the traction of the mesh before, " << all_cold << " without\n";
    EXPECT_LT(all_warm, GetParam() == "neumann" ? .5 * all_cold : all_cold);
  }

  INSTANTIATE_TEST_SUITE_P(Schemes, WarmStart, testing::Values("neumann", "newton", "conjugate"));
} // namespace
