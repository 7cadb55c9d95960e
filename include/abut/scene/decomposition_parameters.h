// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace abut
{
  enum class InitialGuess
  {
    elastic_layer, ///< the paper's, literally: normal displacements on the contact nodes that just close the
                   ///< gap
    elastic_layer_response ///< the bodies' response to the layer pressure overlap/(k_1 + k_2 + theta)
  };

  enum class StoppingRule
  {
    bound,    ///< guaranteed iteration error, relative, energy norm
    increment ///< the paper's: relative change of the contact displacement, each body
  };

  enum class ComplianceMode
  {
    automatic, ///< whichever is expected to be cheaper
    dense,     ///< the interface compliance as a matrix, made once
    solves     ///< a solve of every body in every step
  };

  /// What the section `Decomposition` says.
  struct DecompositionParameters
  {
    std::string scheme = "newton"; ///< a word with a SchemeEntry
    InitialGuess initial_guess = InitialGuess::elastic_layer_response;
    std::optional<double> relaxation; ///< gamma; empty: automatic
    StoppingRule stopping_rule = StoppingRule::bound;
    double tolerance = 1e-6;
    unsigned int maximum_steps = 100000;
    ComplianceMode compliance = ComplianceMode::automatic;

    static void declare(dealii::ParameterHandler &prm);
    static DecompositionParameters parse(dealii::ParameterHandler &prm);
  };
} // namespace abut
