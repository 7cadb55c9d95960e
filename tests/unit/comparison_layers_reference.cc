// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The contact law of the layers' exact solution: with `penalised` it has the penalty of the scene's pair.
#include <abut/base/numbers.h>
#include <abut/reference/layers_contact.h>
#include <abut/reference/penalised_layers_contact.h>
#include <abut/run/model.h>

#include <gtest/gtest.h>

using namespace abut;

namespace
{
  using Overrides = std::vector<std::string>;

  Scene small_layers(const Overrides &more)
  {
    Overrides overrides = {"Body upper/Cells=8, 2", "Body lower/Cells=12, 3"};
    overrides.insert(overrides.end(), more.begin(), more.end());
    return Scene::read(ABUT_SOURCE_DIR "/prm/two-layers-rollers.prm", overrides);
  }

  /// The layers of the parameter file.
  LayersContactData steel_layers()
  {
    const Layer steel{2.1e5, 0.3, 1.};
    return {{{steel, steel}}, 4., 1e-3, 1.366e-3};
  }

  double force_of(const Scene &scene)
  {
    return make_exact_solution(scene)->force().value();
  }

  const std::string penalised = "Reference/Contact=penalised";

  TEST(LayersReference, has_no_penalty_where_nothing_is_said)
  {
    EXPECT_NEAR(force_of(small_layers({})) / LayersContact(steel_layers()).force(), 1., 1e-12);
  }

  class PenaltyOfThePair : public testing::TestWithParam<std::pair<Overrides, double>>
  {};

  TEST_P(PenaltyOfThePair, is_that_of_the_penalised_solution)
  {
    const auto &[overrides, penalty] = GetParam();
    Overrides all = overrides;
    all.push_back(penalised);
    const Scene scene = small_layers(all);
    const PenalisedLayersContact expected(steel_layers(), penalty);
    EXPECT_NEAR(Model(scene, nullptr).pairs().front()->penalty() / penalty, 1., 1e-12);
    EXPECT_NEAR(force_of(scene) / expected.force(), 1., 1e-10);
    const auto exact = make_exact_solution(scene);
    EXPECT_NEAR(exact->pressure()(Vector2(.4, 1.)) / expected.pressure(.4), 1., 1e-10);
    EXPECT_NEAR(exact->stress(0)(Vector2(.4, .3)).yy / expected.stress(0, Vector2(.4, .7)).yy, 1., 1e-10);
    EXPECT_NEAR(exact->stress(1)(Vector2(.4, .3)).yy / expected.stress(1, Vector2(.4, .3)).yy, 1., 1e-10);
  }

  INSTANTIATE_TEST_SUITE_P(
      Given, PenaltyOfThePair,
      testing::Values(std::pair{Overrides{"Contact interface/Penalty coefficient=5e-4"}, 5e-4 / 2.1e5},
                      std::pair{Overrides{"Contact interface/Penalty coefficient=0.05"}, .05 / 2.1e5},
                      std::pair{Overrides{"Contact interface/Penalty=1e-6"}, 1e-6},
                      std::pair{Overrides{"Contact interface/Penalty coefficient=5e-4",
                                          "Body upper/Contact depth=0.5"},
                                3.75e-4 / 2.1e5}));

  // The depth behind a side is that of the pair, wherever the bodies lie and whatever their heights.
  TEST(LayersReference, has_the_penalty_of_bodies_that_are_turned_and_of_different_heights)
  {
    const Overrides placed = {"Body upper/Size=4, 0.5",
                              "Body lower/Size=4, 2",
                              "Body upper/Rotation angle=30",
                              "Body lower/Rotation angle=30",
                              "Body upper/Shift=-1, 1.7320508075688772",
                              penalised};
    Overrides by_coefficient = placed, by_value = placed;
    by_coefficient.push_back("Contact interface/Penalty coefficient=0.05");
    const Scene scene = small_layers(by_coefficient);
    const double penalty = Model(scene, nullptr).pairs().front()->penalty();
    EXPECT_NEAR(penalty / (.5 * .05 * (.5 + 2.) / 2.1e5), 1., 1e-12);
    by_value.push_back("Contact interface/Penalty=" + exact_number(penalty));
    EXPECT_NEAR(force_of(scene) / force_of(small_layers(by_value)), 1., 1e-10);
  }

  // Lengths twice as large with the same moduli: displacements and theta too, stresses as before.
  TEST(LayersReference, has_the_penalty_in_the_lengths_of_the_bodies)
  {
    const Overrides scales = {"Body upper/Scale=2", "Body lower/Scale=2", "Body upper/Shift=0, 2", penalised};
    for (const std::string own : {"Penalty coefficient=0.05", "Penalty=1e-6"})
    {
      const bool is_length = own == "Penalty=1e-6";
      Overrides scaled = scales;
      scaled.push_back("Contact interface/" + (is_length ? std::string("Penalty=2e-6") : own));
      EXPECT_NEAR(force_of(small_layers(scaled)) /
                      force_of(small_layers({penalised, "Contact interface/" + own})),
                  1., 1e-10)
          << own;
    }
  }
} // namespace
