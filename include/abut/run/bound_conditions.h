// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/results/estimation.h>
#include <abut/results/results.h>
#include <abut/scene/scene.h>

namespace abut
{
  /**
   * Why `Estimation::bound` is no bound of a solved scene's error, or none was made: one sentence, without
   * the full stop; empty where the conditions of the theory are met. The first reason of several.
   */
  std::string why_no_bound(const Scene &scene, const Solution &solution, const Estimation &estimation);
} // namespace abut
