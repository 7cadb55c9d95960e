// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace abut
{
  struct ObservedRun;
  struct Scene;

  /// Into the folder of results: figure04 (von Mises stress on the last mesh) and figure07 (initial, third,
  /// last mesh), each as .svg and .csv. Throws UserError.
  void write_mesh_figures(const Scene &scene, const ObservedRun &run);
} // namespace abut
