// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact at points that supports hold on both sides: a pressure there is round-off by round-off.
#include <abut/decomposition/interface_solver.h>

#include <gtest/gtest.h>

#include "decomposition_testing.h"

using namespace abut;

namespace
{
  /// The left ends, x = 0 and last on the slave side, are clamped; the upper one is moved by `upper`.
  std::vector<std::string> clamped(const std::string &scheme, const std::string &mode,
                                   const std::string &upper)
  {
    return {"Body upper/Cells=32, 8",
            "Body lower/Cells=32, 8",
            "Body upper/Conditions=left: displacement: 0, " + upper,
            "Body lower/Conditions=left: displacement: 0, 0; bottom: normal displacement: 0",
            "Body upper/Body force=0, -1",
            "Contact interface/Gap=0",
            "Contact interface/Penalty coefficient=0",
            "Decomposition/Scheme=" + scheme,
            "Decomposition/Interface compliance=" + mode,
            "Decomposition/Stopping rule=bound",
            "Decomposition/Tolerance=1e-6"};
  }
} // namespace

TEST(DecompositionHeldParts, ThePressureNextToOneIsDefined)
{
  for (const char *const scheme : {"newton", "conjugate"})
    for (const char *const mode : {"dense", "solves"})
    {
      const TwoLayers layers(clamped(scheme, mode, "0"));
      const InterfaceSolver solver(layers.problem(), layers.parameters());
      const Eigen::VectorXd start = Eigen::VectorXd::Ones(layers.problem().n_pressures());
      const SchemeResult result = solver.solve(layers.loads(), start, {});
      EXPECT_TRUE(result.converged()) << result.message;
      // The part at the held point has joined its neighbour: no pressure on what cannot yield, none that
      // grows.
      const Eigen::Index last = result.traction.size() - 1;
      EXPECT_NEAR(layers.problem().weights()[last], 1.5 * 4. / 32., 1e-12);
      EXPECT_LT(result.traction[last], result.traction[last - 1]) << scheme << ' ' << mode;
      EXPECT_TRUE(solver.motions() != nullptr);
      // 4 x 1 of weight 1, a part of it carried by the clamp
      EXPECT_GT(layers.problem().weights().dot(result.traction), 1.) << scheme << ' ' << mode;
      EXPECT_LT(layers.problem().weights().dot(result.traction), 4.) << scheme << ' ' << mode;
    }
}

TEST(DecompositionHeldParts, ThereAreNoneAtRollers)
{
  const TwoLayers layers({"Body upper/Cells=24, 6", "Body lower/Cells=32, 8",
                          "Contact interface/Penalty coefficient=0", "Decomposition/Scheme=newton",
                          "Decomposition/Stopping rule=bound"});
  const auto compliance = make_compliance(layers.problem(), ComplianceMode::dense, 0.);
  const MotionTerms motions = make_motion_terms(layers.problem());
  EXPECT_TRUE(HeldParts(layers.problem(), *compliance, motions).indices().empty());
}
