// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace abut
{
  /// What one scheme needed for a scene's interface problem. Where it was not run, `message` says why.
  struct SchemeRun
  {
    std::string scheme;
    std::optional<unsigned int> steps;
    std::optional<double> predicted_steps;  ///< of neumann
    bool converged = false, failed = false; ///< failed: without a result
    unsigned int solves = 0;                ///< right sides of the body that was solved most often
    double seconds = std::nan("");          ///< of the compliance and the steps
    double iteration_error = std::nan("");  ///< the scheme's own, see SchemeResult
    /// From the reference solution of the same discrete problem, in the energy norm, relative as the
    /// iteration error is.
    double distance = std::nan("");
    std::string message; ///< why it was not run or has not converged
  };

  /// For people, a line for each scheme and one for each message.
  std::string scheme_table(const std::vector<SchemeRun> &runs);

  /// The same for programs.
  std::string scheme_csv(const std::vector<SchemeRun> &runs);
} // namespace abut
