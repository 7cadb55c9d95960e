// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace abut
{
  /**
   * Solves the interface problem of a scene's initial meshes by every scheme, from its own first guess to
   * Decomposition/Tolerance, and prints steps, solves, seconds, the scheme's own iteration error, and the
   * distance from a reference solution of the same problem (the scheme newton to 1e-13); the same into
   * schemes.csv in the output directory. The scheme neumann is run where it needs at most 25000 steps, else
   * its count is predicted. Whether all that were run have converged. Throws UserError, also for a scene
   * without contact, and ComputationError where there is no reference.
   */
  bool compare_schemes(const std::string &file, const std::vector<std::string> &overrides, bool quiet,
                       std::ostream &out);
} // namespace abut
