// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/adaptation/indicator.h>
#include <abut/run/model.h>

namespace abut
{
  /// What a run works with. The meshes of the model change from pass to pass, the rest stays.
  struct Setup
  {
    const Scene &scene;
    const Model &model;
    const Indicator *indicator = nullptr; ///< null: nothing is estimated
    const Indicator *certifier = nullptr; ///< what estimates again where the goal is near; null: nothing does
    const ExactSolution *exact = nullptr; ///< null: none is known
  };
} // namespace abut
