// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace abut
{
  struct ObservedRun;
  struct Scene;
  class PressedLayers;

  /// Into the folder of results: figure09 (contact displacement of the lower body and contact pressure by
  /// pass, beside those of `exact`) as .svg, its two halves as .csv. Throws UserError.
  void write_iteration_figures(const Scene &scene, const ObservedRun &run, const PressedLayers &exact);
} // namespace abut
