// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What the estimator fe-be is worth in scenes whose exact response to the applied traction is known: layers
// in contact, a flat punch, a reentrant corner.

#include <gtest/gtest.h>

#include "estimator_passes.h"
#include "solved_scene.h"

namespace
{
  using namespace abut;
  using Overrides = std::vector<std::string>;

  const Overrides coarse_layers{"Body upper/Cells=16, 4", "Body lower/Cells=16, 4"};

  Overrides equal_cells(const unsigned int n_passes)
  {
    return {"Adaptation/Marking=fixed fraction", "Adaptation/Fraction=1",
            "Adaptation/Maximum passes=" + std::to_string(n_passes)};
  }

  Overrides joined(Overrides first, const Overrides &second)
  {
    first.insert(first.end(), second.begin(), second.end());
    return first;
  }

  class EstimatorOnLayers : public ::testing::TestWithParam<std::string>
  {};

  /// Smooth loads: right within 5 % on every mesh, and cell by cell; sigma_B far better than sigma_F.
  TEST_P(EstimatorOnLayers, IsRightOnEqualCells)
  {
    const EstimatorPasses passes(GetParam() + ", equal cells", "estimators-" + GetParam() + ".prm",
                                 joined(coarse_layers, equal_cells(3)));
    ASSERT_EQ(passes.passes().size(), 3u);
    passes.expect_effectivity_within(.95, 1.05);
    passes.expect_better_ratio_below(.15, 1); // from 32 x 8
    passes.expect_correlation_above(.99);
  }

  TEST_P(EstimatorOnLayers, IsRightWithHangingNodes)
  {
    const EstimatorPasses passes(GetParam() + ", adapted", "estimators-" + GetParam() + ".prm",
                                 joined(coarse_layers, {"Adaptation/Maximum passes=6"}));
    ASSERT_EQ(passes.passes().size(), 6u);
    passes.expect_effectivity_within(.95, 1.05);
    passes.expect_better_ratio_below(.15, 1);
    passes.expect_correlation_above(.99);
  }

  INSTANTIATE_TEST_SUITE_P(Layers, EstimatorOnLayers, ::testing::Values("sliding", "bonded"),
                           [](const auto &parameter) { return parameter.param; });

  struct SingularCase
  {
    std::string name, scene;
    unsigned int degree;
    Overrides meshes;
    double least, most; ///< of the effectivity, every pass
  };

  std::ostream &operator<<(std::ostream &out, const SingularCase &given)
  {
    return out << given.name;
  }

  std::vector<SingularCase> singular_cases()
  {
    const Overrides adapted{"Adaptation/Maximum passes=12", "Adaptation/Maximum unknowns=2000"};
    return {{"PunchEqual", "flat-punch.prm", 1, equal_cells(4), .85, 1.15},
            {"PunchAdapted", "flat-punch.prm", 1, adapted, .85, 1.15},
            {"CornerEqual", "corner.prm", 1, equal_cells(4), .8, 1.25},
            {"CornerAdapted", "corner.prm", 1, adapted, .8, 1.25},
            {"CornerEqualQ2", "corner.prm", 2, equal_cells(4), .8, 1.25},
            {"CornerAdaptedQ2", "corner.prm", 2, adapted, .8, 1.25},
            {"PunchEqualQ2", "flat-punch.prm", 2, equal_cells(4), .8, 1.25},
            {"PunchAdaptedQ2", "flat-punch.prm", 2, adapted, .8, 1.25}};
  }

  class EstimatorOnSingularScenes : public ::testing::TestWithParam<SingularCase>
  {};

  TEST_P(EstimatorOnSingularScenes, SeesTheError)
  {
    const SingularCase &given = GetParam();
    const EstimatorPasses passes(
        given.name, given.scene,
        joined({"Adaptation/Estimator=fe-be", "Discretisation/Degree=" + std::to_string(given.degree)},
               given.meshes));
    passes.expect_effectivity_within(given.least, given.most);
  }

  INSTANTIATE_TEST_SUITE_P(Singular, EstimatorOnSingularScenes, ::testing::ValuesIn(singular_cases()),
                           [](const auto &parameter) { return parameter.param.name; });

  /// Elements that are not split towards the corner see three quarters of the error, and the run says so.
  TEST(EstimatorInScenes, WarnsWhereItUnderestimates)
  {
    for (const auto &[kind, warned] : {std::pair<std::string, bool>{"constant traction", true},
                                       {"finite element trace", true},
                                       {"trace space", false},
                                       {"reference quality", false}})
    {
      const SolvedScene solved("corner.prm", {"Adaptation/Estimator=fe-be", "Adaptation/Maximum passes=1",
                                              "Adaptation/Boundary solution=" + kind});
      const auto &warnings = solved.results().warnings;
      const bool says_so = std::any_of(warnings.begin(), warnings.end(), [](const Warning &warning) {
        return warning.code == WarningCode::estimator_sees_a_part;
      });
      EXPECT_EQ(says_so, warned) << kind;
      const double effectivity = solved.results().passes.back().effectivity().value();
      EXPECT_EQ(effectivity < .8, warned) << kind;
    }
  }

  TEST(EstimatorInScenes, KellyHasNoBetterStress)
  {
    const SolvedScene solved("corner.prm", {"Adaptation/Estimator=kelly", "Adaptation/Maximum passes=1"});
    EXPECT_FALSE(solved.results().passes.back().quality.value().has_better);
  }
} // namespace
