// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A run that goes on from the state between any two passes ends as the run did that was not interrupted, bit
// by bit: meshes are made again in the same way, and nothing that the next pass needs is missing in the
// state.
#include <abut/base/user_error.h>
#include <abut/run/simulation.h>

#include <gtest/gtest.h>

using namespace abut;

namespace
{
  std::vector<std::string> joined(std::vector<std::string> overrides, const std::vector<std::string> &more)
  {
    overrides.insert(overrides.end(), more.begin(), more.end());
    return overrides;
  }

  const std::vector<std::string> adaptive = {"Body upper/Cells=12, 3",  "Body lower/Cells=16, 4",
                                             "Body upper/Adapt=true",   "Body lower/Adapt=true",
                                             "Adaptation/Estimator=zz", "Adaptation/Marking=doerfler",
                                             "Adaptation/Fraction=0.3", "Adaptation/Maximum passes=4"};

  struct ResumedScene
  {
    std::string name, file;
    std::vector<std::string> overrides;
    std::size_t n_passes; ///< at least
  };

  struct Recorded
  {
    std::vector<Bytes> states; ///< after every pass but the last
    Bytes passes, bodies, pressures;
    std::string stopped_by, message;
    std::vector<std::string> warnings;
  };

  /// But for the seconds and what they were spent on.
  Bytes packed_passes(std::vector<PassRecord> passes)
  {
    for (PassRecord &pass : passes)
    {
      pass.cost = {};
      pass.seconds = 0.;
    }
    return packed(passes);
  }

  Recorded record(Simulation &simulation)
  {
    Recorded recorded;
    RunObserver observer;
    observer.adapted = [&](const RunState &state) { recorded.states.push_back(packed(state)); };
    const Results results = simulation.run(observer);
    recorded.passes = packed_passes(results.passes);
    recorded.bodies = packed(results.bodies);
    recorded.pressures = packed(results.iteration.traction);
    recorded.stopped_by = results.adaptation_end ? results.adaptation_end->stopped_by : "";
    recorded.message = results.message();
    for (const Warning &warning : results.warnings)
      recorded.warnings.push_back(warning.text);
    return recorded;
  }

  RunState state_of(Bytes bytes)
  {
    RunState state;
    unpack(bytes, state);
    return state;
  }

  /// From a state, in a simulation of its own.
  Recorded resumed(const Scene &scene, const Bytes &bytes)
  {
    Simulation simulation(scene);
    simulation.go_on_from(state_of(bytes));
    return record(simulation);
  }

  void expect_same(const Recorded &found, const Recorded &expected)
  {
    EXPECT_TRUE(found.bodies == expected.bodies);
    EXPECT_TRUE(found.pressures == expected.pressures);
    EXPECT_TRUE(found.passes == expected.passes);
    EXPECT_EQ(found.stopped_by, expected.stopped_by);
    EXPECT_EQ(found.message, expected.message);
    EXPECT_EQ(found.warnings, expected.warnings);
  }

  class Resumed : public ::testing::TestWithParam<ResumedScene>
  {};

  TEST_P(Resumed, EndsAsIfItHadNotBeenInterrupted)
  {
    const Scene scene =
        Scene::read(std::string(ABUT_SOURCE_DIR) + "/prm/" + GetParam().file, GetParam().overrides);
    Simulation simulation(scene);
    const Recorded whole = record(simulation);
    ASSERT_GE(whole.states.size() + 1, GetParam().n_passes);
    for (std::size_t k = 0; k < whole.states.size(); ++k)
    {
      SCOPED_TRACE("after pass " + std::to_string(k));
      const Recorded rest = resumed(scene, whole.states[k]);
      expect_same(rest, whole);
      EXPECT_EQ(rest.states.size(), whole.states.size() - k - 1);
    }
  }

  // What has been left out of the state is missed: else the comparison would see nothing.
  TEST(ResumedState, NeedsWhatIsCarriedOver)
  {
    const Scene scene = Scene::read(ABUT_SOURCE_DIR "/prm/two-layers-tolerance.prm", {"Tolerance=0.003"});
    Simulation simulation(scene);
    const Recorded whole = record(simulation);
    ASSERT_GE(whole.states.size(), 2u);
    RunState state = state_of(whole.states.back());
    for (Eigen::VectorXd &displacement : state.carried->displacements)
      displacement *= 1. + 1e-6;
    EXPECT_FALSE(resumed(scene, packed(state)).passes == whole.passes);
  }

  // How accurately the pass before had to be solved.
  TEST(ResumedState, NeedsWhatThePassKeeps)
  {
    const Scene scene =
        Scene::read(ABUT_SOURCE_DIR "/prm/two-layers-rollers.prm",
                    joined(adaptive, {"Adaptation/Estimator=zz", "Decomposition/Scheme=conjugate"}));
    Simulation simulation(scene);
    const Recorded whole = record(simulation);
    ASSERT_GE(whole.states.size(), 2u);
    RunState state = state_of(whole.states[1]);
    const std::optional<double> no_ratio;
    const double tiny_error = 1e-6;
    state.pass = packed(no_ratio, tiny_error);
    ASSERT_EQ(state.pass.size(), state_of(whole.states[1]).pass.size());
    EXPECT_FALSE(resumed(scene, packed(state)).passes == whole.passes);
  }

  TEST(ResumedState, IsRefusedByAnotherScene)
  {
    const std::string file = ABUT_SOURCE_DIR "/prm/two-layers-tolerance.prm";
    const Scene scene = Scene::read(file);
    Simulation simulation(scene);
    const Recorded whole = record(simulation);
    ASSERT_FALSE(whole.states.empty());
    EXPECT_THROW(resumed(Scene::read(file, {"Body lower/Cells=5, 3"}), whole.states.back()), UserError);
    EXPECT_THROW(resumed(Scene::read(file, {"Body lower/Degree=1"}), whole.states.back()), UserError);
  }

  TEST(ResumedState, CountsAndTimesWhatWasBefore)
  {
    const Scene scene = Scene::read(ABUT_SOURCE_DIR "/prm/two-layers-tolerance.prm");
    Simulation simulation(scene);
    const Recorded whole = record(simulation);
    ASSERT_FALSE(whole.states.empty());
    RunState state = state_of(whole.states.back());
    state.seconds = 1000.;
    state.times.solve = 500.;
    Simulation rest(scene);
    rest.go_on_from(state);
    const Results results = rest.run({});
    EXPECT_GT(results.passes.back().seconds, 1000. - state.times.reference - state.times.output);
    EXPECT_GT(results.times.solve, 500.);
    for (std::size_t a = 0; a < results.bodies.size(); ++a)
      EXPECT_EQ(results.bodies[a].counters.factorisations, results.passes.size());
  }

  const std::vector<std::string> groove = {"Body disc/Cells=16, 6",   "Body left/Cells=12, 6",
                                           "Body right/Cells=12, 6",  "Body disc/Adapt=true",
                                           "Adaptation/Estimator=zz", "Adaptation/Maximum passes=3"};

  const std::vector<ResumedScene> scenes = {
      {"tolerance", "two-layers-tolerance.prm", {"Tolerance=0.003"}, 3},
      {"goal", "two-layers-tolerance.prm", {"Tolerance=0.01", "Goal=force"}, 3},
      {"hanging_nodes_by_fe_be", "two-layers-rollers.prm", joined(adaptive, {"Adaptation/Estimator=fe-be"}),
       4},
      {"one_body_stays", "two-layers-rollers.prm", joined(adaptive, {"Body upper/Adapt=false"}), 4},
      {"penalised", "two-layers-rollers.prm",
       joined(adaptive, {"Contact interface/Penalty coefficient=0.05"}), 4},
      {"coarsening", "two-layers-rollers.prm",
       joined(adaptive, {"Adaptation/Marking=fixed fraction", "Adaptation/Coarsening=0.2"}), 4},
      {"mortar_edges", "two-layers-rollers.prm", joined(adaptive, {"Body lower/Nonconforming edges=mortar"}),
       4},
      {"triangles", "two-layers-rollers.prm",
       joined(adaptive, {"Body upper/Cell type=triangles", "Body upper/Degree=2"}), 4},
      {"combined", "two-layers-paper.prm", {"Body upper/Cells=32, 8", "Body lower/Cells=16, 4"}, 3},
      {"floating_disc", "v-groove.prm", groove, 3},
      {"rigid_side",
       "hertz.prm",
       {"Tolerance=0.1", "Body roller/Cells=16, 8", "Body block/Cells=24, 12"},
       2}};

  INSTANTIATE_TEST_SUITE_P(Scenes, Resumed, ::testing::ValuesIn(scenes),
                           [](const auto &scene) { return scene.param.name; });
} // namespace
