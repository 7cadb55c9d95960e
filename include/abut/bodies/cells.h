// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/archive.h>
#include <abut/base/material.h>
#include <abut/base/vector2.h>

#include <functional>
#include <vector>

namespace abut
{
  /// A cell of a body's mesh, undeformed.
  struct CellInfo
  {
    std::vector<Vector2> vertices;
    Vector2 centre = Vector2::Zero();
    double diameter = 0.;
    unsigned int level = 0; ///< how often it was split
    bool at_boundary = false;
    bool at_glue = false; ///< one of its edges is glued
    Material material;

    void serialize(Archive &archive)
    {
      archive(vertices, centre, diameter, level, at_boundary, at_glue, material);
    }
  };

  /// The mean over those cells at a point that are of one material.
  struct MaterialStress
  {
    Material material;
    Stress stress;
    unsigned int n_cells = 0;

    void serialize(Archive &archive) { archive(material, stress, n_cells); }
  };

  /// Sets of points in the cells of a body. Cells are visited by their index, points of a cell in an order
  /// that is always the same.
  enum class SamplePoints
  {
    energy,     ///< those at which the body integrates its energy
    comparison, ///< where a better stress is compared with that of the body: p + 1 Gauss points a direction
    precise,    ///< for integrals of exact solutions: p + 2 Gauss points a direction
    output,     ///< corners and what lies between them, where result files have values. Without weights
    outline     ///< around each cell, counter-clockwise, enough for curved edges. Without weights
  };

  struct SamplePoint
  {
    unsigned int cell;
    Vector2 place; ///< undeformed, world frame
    double weight; ///< area
  };

  /// Receives a point with the displacement and its gradient (row: component) there.
  using DisplacementVisitor = std::function<void(const SamplePoint &point, const Vector2 &displacement,
                                                 const Eigen::Matrix2d &gradient)>;
  /// Receives a point with the stress there, world frame.
  using StressVisitor = std::function<void(const SamplePoint &point, const Stress &stress)>;
} // namespace abut
