// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/body_description.h>

#include <Eigen/Core>

/**
 * The displacement u = (sin(a x) exp(b y), exp(c x) cos(d y)) in a body's own frame, with the body force and
 * the tractions that belong to it, written as expressions of a scene: held on the left, moved in y and loaded
 * in x at the bottom, tractions on the right and at the top.
 */
class SmoothSolution
{
public:
  explicit SmoothSolution(const abut::BodyDescription &shape);

  const abut::BodyDescription &description() const { return body_; }
  /// In the plane, at a point of the plane.
  abut::Vector2 displacement(const abut::Vector2 &point) const;
  Eigen::Matrix2d gradient(const abut::Vector2 &point) const;

private:
  abut::BodyDescription body_;
};

/// Relative errors of the displacement that a body computes.
struct SmoothErrors
{
  double energy, l2;
};
SmoothErrors solve_smooth(const abut::BodyDescription &shape);
