// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/results/results.h>
#include <abut/run/model.h>

namespace abut
{
  /// Refuses points that no elastic body has, or not the body named (UserError). All processes have to call
  /// it, as what follows.
  void check_output_points(const Scene &scene, const Model &model);

  /// The solution at the scene's points, one after the other, of each body asked that has them.
  std::vector<PointResult> point_values(const Scene &scene, const std::vector<BodyResult> &bodies,
                                        const Executor &executor);
} // namespace abut
