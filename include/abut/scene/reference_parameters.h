// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/expression.h>

namespace dealii
{
  class ParameterHandler;
}

namespace abut
{
  /// Exact solutions a scene may name, with their data (section `Reference`).
  struct ReferenceParameters
  {
    enum class Solution
    {
      none,
      layers_sliding, ///< two layers with sliding faces and roller ends, pressed by `Approach`, gap `Gap
                      ///< curvature` x^2
      layers_bonded   ///< the same with faces that are held along themselves
    };
    Solution solution = Solution::none;
    double approach = 0.;
    double gap_curvature = 0.;

    static void declare(dealii::ParameterHandler &prm);
    /// Reads the section the handler stands in. Throws UserError.
    static ReferenceParameters parse(dealii::ParameterHandler &prm, const Constants &constants);
  };
} // namespace abut
