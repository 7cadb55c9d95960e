// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/body_description.h>

#include <Eigen/Core>

/// A smooth displacement in a body's own frame, with its stress and body force as formulas of x, y, a, b, c,
/// d (numbers), L, M (lambda, mu) and K = M/L.
struct SmoothField
{
  std::string u_x, u_y, s_xx, s_yy, s_xy, f_x, f_y;
  abut::Vector2 (*displacement)(const abut::Vector2 &point, double k);
  Eigen::Matrix2d (*gradient)(const abut::Vector2 &point, double k);
};

/// u = (sin(a x) exp(b y), exp(c x) cos(d y)).
const SmoothField &compressible_field();

/// u = (sin(a x) exp(b y) + K sin(d x) exp(c y), -a/b cos(a x) exp(b y)): lambda div u = M d cos(d x) exp(c
/// y) stays as large as the shear stresses when lambda grows.
const SmoothField &nearly_incompressible_field();

/**
 * A body with a smooth displacement, the body force and the tractions that belong to it written as
 * expressions of a scene: held on the left, moved in y and loaded in x at the bottom, tractions on the right
 * and at the top.
 */
class SmoothSolution
{
public:
  explicit SmoothSolution(const abut::BodyDescription &shape,
                          const SmoothField &field = compressible_field());

  const abut::BodyDescription &description() const { return body_; }
  /// In the plane, at a point of the plane.
  abut::Vector2 displacement(const abut::Vector2 &point) const;
  Eigen::Matrix2d gradient(const abut::Vector2 &point) const;

private:
  const SmoothField &field_;
  double k_;
  abut::BodyDescription body_;
};

/// Relative errors: of the stress in the energy norm and in L2 over xx, yy, zz and twice xy, of the
/// displacement in L2.
struct SmoothErrors
{
  double energy, stress, l2;
};
SmoothErrors solve_smooth(const abut::BodyDescription &shape,
                          const SmoothField &field = compressible_field());
