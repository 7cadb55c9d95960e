// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact nodes that supports hold on both sides: a pressure there is round-off by round-off.
#include <abut/decomposition/interface_solver.h>
#include <abut/user_error.h>

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

TEST(DecompositionHeldNodes, TouchingOnesCarryNoPressure)
{
  for (const char *const scheme : {"newton", "conjugate"})
    for (const char *const mode : {"dense", "solves"})
    {
      const TwoLayers layers(clamped(scheme, mode, "0"));
      const InterfaceSolver solver(layers.problem(), layers.parameters());
      const Eigen::VectorXd start = Eigen::VectorXd::Ones(layers.problem().n_pressures());
      const SchemeResult result = solver.solve(layers.loads(), start, {});
      EXPECT_TRUE(result.converged()) << result.message;
      EXPECT_EQ(result.traction[result.traction.size() - 1], 0.) << scheme << ' ' << mode;
      // 4 x 1 of weight 1, a part of it carried by the clamp
      EXPECT_GT(layers.problem().weights().dot(result.traction), 1.) << scheme << ' ' << mode;
      EXPECT_LT(layers.problem().weights().dot(result.traction), 4.) << scheme << ' ' << mode;
    }
}

TEST(DecompositionHeldNodes, OverlappingOnesAreRefusedWithTheirPlace)
{
  for (const char *const scheme : {"newton", "conjugate"})
    for (const char *const mode : {"dense", "solves"})
    {
      const TwoLayers layers(clamped(scheme, mode, "-1e-3"));
      const InterfaceSolver solver(layers.problem(), layers.parameters());
      try
      {
        solver.solve(layers.loads(), {}, {});
        ADD_FAILURE() << scheme << ' ' << mode;
      }
      catch (const ComputationError &error)
      {
        const std::string text = error.what();
        EXPECT_NE(text.find("Contact interface: at (0, 1)"), std::string::npos) << text;
        EXPECT_NE(text.find("overlap by 0.001"), std::string::npos) << text;
      }
    }
}

TEST(DecompositionHeldNodes, ThereAreNoneAtRollers)
{
  const TwoLayers layers({"Body upper/Cells=24, 6", "Body lower/Cells=32, 8",
                          "Contact interface/Penalty coefficient=0", "Decomposition/Scheme=newton",
                          "Decomposition/Stopping rule=bound"});
  const auto compliance = make_compliance(layers.problem(), ComplianceMode::dense, 0.);
  const MotionTerms motions = make_motion_terms(layers.problem());
  EXPECT_TRUE(HeldNodes(layers.problem(), *compliance, motions).indices().empty());
}
