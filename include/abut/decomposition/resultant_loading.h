// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <string>

namespace abut
{
  /**
   * Finds the displacement of a rigid side for which its support's force is `target`: a secant method between
   * brackets (false position, Illinois variant) on the increasing function `force`. `guess` is a first size
   * of the displacement. Ends when |force - target| <= tolerance max(|target|, |force(0)|). Throws
   * ComputationError, beginning with `name`, where no displacement carries the force, e.g. because contact
   * cannot pull.
   */
  double find_rigid_displacement(const std::function<double(double displacement)> &force, double target,
                                 double guess, double tolerance, const std::string &name);
} // namespace abut
