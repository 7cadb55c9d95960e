// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/executor.h>
#include <abut/report/apart.h>
#include <abut/report/exaggeration.h>

#include <string>
#include <vector>

namespace abut
{
  /// The von Mises stress of every cell, the mean over it.
  std::vector<double> mean_von_mises(const BodyResult &result);

  /// A body as it is drawn.
  struct DrawnBody
  {
    std::vector<Polyline> cells;   ///< outlines, enough points for curved edges
    std::vector<double> von_mises; ///< mean over each cell; none of a rigid body
    bool is_rigid = false;         ///< its only cell is the body

    void serialize(Archive &archive) { archive(cells, von_mises, is_rigid); }
  };

  /// A stretch of parts as it is drawn, with its contact pressure.
  struct DrawnContact
  {
    Polyline nodes;   ///< the parts' places
    Polyline normals; ///< outward, undeformed
    std::vector<double> pressures;

    void serialize(Archive &archive) { archive(nodes, normals, pressures); }
  };

  /// All bodies with their motions exaggerated.
  struct DrawnScene
  {
    std::vector<DrawnBody> bodies;
    std::vector<DrawnContact> contacts;
    double size = 0.; ///< diagonal of the box around the undeformed bodies
    Exaggeration exaggeration;
    bool moved_apart = false; ///< some body is drawn elsewhere

    void serialize(Archive &archive) { archive(bodies, contacts, size, exaggeration, moved_apart); }
  };

  /// A body where it lies before anything moves, with the stress of its solution.
  DrawnBody undeformed_body(const BodyResult &result);

  /**
   * The deformed scene: deformations times a factor (1, 2 or 5 times a power of ten) such that the bodies'
   * largest deformation relative to their mean is at most, and at least 2/5 of, a twentieth of the scene's
   * size; rigid motions times one by which what touches is drawn as touching (see `exaggeration_of`).
   *
   * Initial gaps are drawn at their size, and those given as an expression not at all: bodies in contact may
   * stand apart, and those that would overlap are drawn elsewhere (see `shifts_apart`). Bodies are drawn
   * where they live: all processes have to call it.
   */
  DrawnScene deformed_scene(const Results &results, const Executor &executor);

  /// Which factors apply to what, for people.
  std::string deformation_caption(const DrawnScene &scene);
} // namespace abut
