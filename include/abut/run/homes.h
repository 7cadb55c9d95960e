// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/executor.h>
#include <abut/bodies/body.h>

#include <memory>
#include <vector>

namespace abut
{
  /**
   * What decides where the bodies live. The cost of a body is its unknowns to the power 1.25, as the seconds
   * for a factor grow from 10 thousand to a million of them. It has as many processes as its description
   * says or, where that says nothing, one; but all where its factor would not fit into the memory that a
   * process has free. `stay`: bodies that are left where they are. All processes have to call it. Throws
   * UserError for more processes than there are.
   */
  std::vector<BodyLoad> body_loads(const std::vector<std::unique_ptr<Body>> &bodies,
                                   const std::vector<bool> &stay, const Executor &executor);
} // namespace abut
