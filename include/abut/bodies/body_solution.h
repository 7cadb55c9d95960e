// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/body.h>

namespace abut
{
  /// One body and its present solution.
  struct BodySolution
  {
    const Body &body;
    const Eigen::VectorXd &deformation;    ///< all unknowns, less the rigid motion
    const Eigen::VectorXd &contact_forces; ///< trace vector
  };
} // namespace abut
