// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What a pass makes of a mesh, and when the passes end.
#include <abut/decomposition/interface_solver.h>
#include <abut/decomposition/measures.h>
#include <abut/run/adaptation_end.h>
#include <abut/run/estimate.h>
#include <abut/run/evaluate.h>
#include <abut/run/pass.h>
#include <abut/run/tolerance_end.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace abut;

namespace
{
  Scene pressed_layers(const std::vector<std::string> &more = {})
  {
    std::vector<std::string> overrides = {"Body upper/Cells=12, 3", "Body lower/Cells=16, 4"};
    overrides.insert(overrides.end(), more.begin(), more.end());
    return Scene::read(ABUT_SOURCE_DIR "/prm/two-layers-rollers.prm", overrides);
  }

  const std::vector<std::string> soft_contact = {"Contact interface/Penalty coefficient=5e-2",
                                                 "Decomposition/Scheme=neumann"};

  std::vector<std::string> with(std::vector<std::string> overrides, const std::vector<std::string> &more)
  {
    overrides.insert(overrides.end(), more.begin(), more.end());
    return overrides;
  }

  /// The outcome of the first pass, without an estimate.
  PassOutcome first_pass(const Scene &scene, Model &model, const RunObserver &observer = {})
  {
    model.prepare();
    return make_pass({scene, model})->run({}, observer);
  }

  // Fig. 2 of the paper on a mesh that stays is the parallel Neumann scheme, step by step.
  TEST(Pass, CombinedStepsAreThoseOfTheNeumannScheme)
  {
    constexpr unsigned int n_steps = 5;
    const Scene solved = pressed_layers(
        with(soft_contact, {"Decomposition/Maximum steps=5", "Decomposition/Tolerance=1e-12"}));
    Scene combined = solved;
    combined.adaptation.combined = true;
    Model model(solved, nullptr);
    std::vector<StepRecord> expected, found;
    RunObserver observer;
    observer.step = [&](const StepRecord &record) { expected.push_back(record); };
    first_pass(solved, model, observer);
    ASSERT_EQ(expected.size(), n_steps);

    observer.step = [&](const StepRecord &record) { found.push_back(record); };
    const auto pass = make_pass({combined, model});
    std::optional<CarriedState> state;
    for (unsigned int k = 0; k < n_steps; ++k)
      state = pass->run(state, observer).state;
    for (unsigned int k = 0; k < n_steps; ++k)
    {
      // Increments are differences of displacements: round-off is that of these.
      EXPECT_NEAR(found[k].increment, expected[k].increment, 1e-10) << k;
      EXPECT_NEAR(found[k].normal_force, expected[k].normal_force, 1e-9 * expected[k].normal_force) << k;
      EXPECT_NEAR(found[k].max_pressure, expected[k].max_pressure, 1e-9 * expected[k].max_pressure) << k;
    }
  }

  TEST(Pass, ContactForcesBalanceTheDisplacementAndEstimateForcesFollowTheLaw)
  {
    const Scene scene =
        pressed_layers(with(soft_contact, {"Adaptation/Estimator=fe-be", "Decomposition/Tolerance=1e-1",
                                           "Decomposition/Stopping rule=bound"}));
    Model model(scene, nullptr);
    model.prepare();
    const auto indicator = make_indicator(scene.adaptation);
    const PassOutcome outcome = make_pass({scene, model, indicator.get()})->run({}, {});
    const Solution &solution = outcome.solution;
    const Eigen::VectorXd law = model.problem().pressures(solution.iteration.response);
    ASSERT_GT((law - solution.iteration.traction).norm(), 1e-6 * law.norm()); // stopped early
    for (std::size_t a = 0; a < solution.bodies.size(); ++a)
    {
      const BodyResult &body = solution.bodies[a];
      EXPECT_LT(body.reactions.equilibrium_residual, 1e-9);
      EXPECT_EQ(body.contact_forces, model.problem().contact_forces(a, solution.iteration.traction));
      EXPECT_EQ(body.estimate_forces, model.problem().contact_forces(a, law));
    }
    EXPECT_TRUE(outcome.estimation.mismatch.has_value());
  }

  TEST(Pass, CountsWhatIsCarriedOn)
  {
    const Scene scene = pressed_layers(soft_contact);
    Model model(scene, nullptr);
    const PassOutcome outcome = first_pass(scene, model);
    EXPECT_EQ(outcome.state.pressures, outcome.solution.iteration.traction);
    ASSERT_EQ(outcome.state.displacements.size(), 2u);
    EXPECT_EQ(outcome.state.displacements[1], outcome.solution.bodies[1].displacement);
    EXPECT_TRUE(outcome.estimation.errors.empty());
  }

  class AdaptationEndTest : public testing::Test
  {
  protected:
    std::optional<AdaptationEnd> end(const double eta, const std::size_t dofs, const std::size_t n_missed = 0)
    {
      PassRecord pass;
      pass.eta_max = eta;
      pass.counts.dofs = dofs;
      pass.n_missed = n_missed;
      passes_.push_back(pass);
      return adaptation_end({scene_, model_}, SchemeResult(), passes_);
    }

    const Scene scene_ =
        pressed_layers({"Body upper/Adapt=true", "Adaptation/Estimator=zz", "Adaptation/Limit=.1",
                        "Adaptation/Maximum passes=3", "Adaptation/Maximum unknowns=1000"});
    const Model model_{scene_, nullptr};
    std::vector<PassRecord> passes_;
  };

  TEST_F(AdaptationEndTest, GoesOnAboveTheLimit)
  {
    EXPECT_FALSE(end(.2, 100));
    EXPECT_FALSE(end(.05, 100, 1)) << "contact was missed";
  }

  TEST_F(AdaptationEndTest, EndsBelowTheLimit)
  {
    const auto reached = end(.1, 100);
    ASSERT_TRUE(reached);
    EXPECT_EQ(reached->stopped_by, "limit");
    EXPECT_EQ(reached->message, "");
  }

  TEST_F(AdaptationEndTest, EndsAtTheMaximaWithAMessage)
  {
    const auto too_large = end(.2, 1000);
    ASSERT_TRUE(too_large);
    EXPECT_EQ(too_large->stopped_by, "maximum unknowns");
    EXPECT_NE(too_large->message.find("the maximum of unknowns has come, eta is 0.2"), std::string::npos);
    EXPECT_FALSE(end(.2, 100));
    const auto too_many = end(.2, 100);
    ASSERT_TRUE(too_many);
    EXPECT_EQ(too_many->stopped_by, "maximum passes");
    EXPECT_NE(no_cell_to_split({scene_, model_}, passes_.back()).message.find("no cell is left"),
              std::string::npos);
  }

  /// What is said of a goal whose changes stay as large as they are.
  std::string advice(const std::string &goal)
  {
    const Scene scene = Scene::read(ABUT_SOURCE_DIR "/prm/two-layers-tolerance.prm", {"Goal=" + goal});
    PassRecord pass;
    pass.goal = GoalRecord{1., .1, 0.};
    const auto end = tolerance_end(scene, std::vector<PassRecord>(8, pass));
    return end ? end->message : "";
  }

  TEST(ToleranceEnd, AdvisesAgainstAskingForTheGoalItself)
  {
    const std::string force = advice("force"), pressure = advice("peak pressure"),
                      stress = advice("stress at (0.9, 0.8)");
    for (const std::string &text : {force, pressure, stress})
      EXPECT_NE(text.find("The goal does not settle: Goal = "), std::string::npos) << text;
    for (const std::string &text : {pressure, stress})
      EXPECT_NE(text.find("ask for the force"), std::string::npos) << text;
    EXPECT_EQ(force.find("ask for"), std::string::npos) << force;
    EXPECT_NE(force.find("hold it along a side"), std::string::npos) << force;
  }
} // namespace
