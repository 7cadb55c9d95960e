// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/expression.h>

#include <string>

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
      layers_bonded,  ///< the same with faces that are held along themselves
      infinite_layers_sliding, ///< layers without an end; for scenes of finite layers with free right ends
      infinite_layers_bonded,
      hertz,      ///< two half-planes, `Force`, composite radius `Radius`
      lame,       ///< a disc or ring shrunk into a ring
      flat_punch, ///< a half-plane under the pressure of a rigid punch, `Half width`, `Force`
      corner      ///< the singular field of an L-shape, `Amplitude`
    };
    /// The contact law the solution obeys.
    enum class Contact
    {
      exact,
      penalised ///< with the penalty of the scene's pair; layers between rollers only
    };
    Solution solution = Solution::none;
    Contact contact = Contact::exact;
    double approach = 0.;
    double gap_curvature = 0.;
    double force = 0.; ///< of the whole contact, where a scene has half of it too
    double radius = 0.;
    double half_width = 0.;
    double amplitude = 0.;

    static void declare(dealii::ParameterHandler &prm);
    /// Reads the section the handler stands in. Throws UserError.
    static ReferenceParameters parse(dealii::ParameterHandler &prm, const Constants &constants);
  };

  /// The name used in the parameter file.
  std::string to_string(ReferenceParameters::Solution solution);
} // namespace abut
