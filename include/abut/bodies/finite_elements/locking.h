// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/finite_elements/space.h>
#include <abut/bodies/finite_elements/supports.h>

namespace abut
{
  /// nu beyond which elements that lock give wrong results.
  constexpr double largest_locking_ratio = .45;

  /**
   * Refuses (UserError) what no projection of the divergence mends above nu = .45, unless the body allows it
   * (Allow locking): triangles, which lock, and degree 1 where supports hold every side in both directions.
   * The pressure of Q1/P0 then has a checkerboard, which gets into energy and reactions.
   */
  void refuse_locking(const BodyDescription &body, const Space &space, const Supports &supports);
} // namespace abut
