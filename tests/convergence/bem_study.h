// SPDX-License-Identifier: LGPL-2.1-or-later
// Boundary elements on polygons with the data of a field known exactly.
#pragma once

#include <abut/base/material.h>
#include <abut/bem/dense_boundary_problem.h>
#include <abut/bem/interior_stress.h>

#include <functional>
#include <vector>

namespace abut
{
  /// A closed polygon, the body on its left.
  struct Curve
  {
    std::vector<Complex> vertices;
    std::vector<std::size_t> sides; ///< the vertices where sides begin; the first is 0
  };

  /// A side from a corner to the next; `places`: where it is divided, from 0 up to less than 1.
  struct DividedSide
  {
    Complex start;
    std::vector<double> places;
  };
  /// n equal parts; or parts that shrink towards the start of the side, or its end, as (i/n)^exponent.
  std::vector<double> uniform(unsigned int n);
  std::vector<double> graded_to_start(unsigned int n, double exponent);
  std::vector<double> graded_to_end(unsigned int n, double exponent);
  Curve divided(const std::vector<DividedSide> &sides);
  /// A regular polygon around the origin; clockwise, as a hole needs it, for `inside_out`.
  Curve regular_polygon(unsigned int n, double radius, bool inside_out = false);

  /// Displacement and stress at a point; the traction at a point of a side with an outward unit normal.
  struct PlaneField
  {
    std::function<Complex(Complex)> displacement;
    std::function<Stress(Complex)> stress;
    std::function<Complex(Complex, Complex)> traction;
  };
  std::function<Complex(Complex, Complex)> traction_of(const std::function<Stress(Complex)> &stress);

  /// Goursat's functions phi, psi and derivatives at a point.
  struct Potentials
  {
    Complex phi, phi_1, phi_2, psi, psi_1;
  };
  /**
   * The field of 2 G u = k phi - z conj(phi') - conj(psi), k = 3 - 4 nu, s_xx + s_yy = 4 Re phi',
   * s_yy - s_xx + 2i s_xy = 2 (conj(z) phi'' + psi').
   */
  PlaneField from_potentials(const Material &material, const std::function<Potentials(Complex)> &potentials);
  /// Uniform stress, with a translation and a rotation.
  PlaneField linear_field(const Material &material);
  /// Exponential potentials: stresses that vary by a factor of about 3 over a unit length.
  PlaneField smooth_field(const Material &material);

  /// A boundary value problem whose solution is known.
  struct BoundaryCase
  {
    Material material{2.6, .3};
    PlaneField field;
    std::vector<Curve> curves;
    /// Directions of the given displacements where a side, at a point, has an outward unit normal.
    std::function<std::vector<Vector2>(Complex, Vector2)> supported;
    std::vector<Complex> points; ///< where the stress is compared
    unsigned int displacement_degree = 1, traction_degree = 1;
    GalerkinRule rule = GalerkinRule::precise();
  };
  /// The same body and loads in other units.
  BoundaryCase in_units(const BoundaryCase &original, double length, double force_per_area);

  /// Relative errors.
  struct BoundaryErrors
  {
    double displacement; ///< L2 norm over the boundary, less the rigid motions where some are free
    double traction;     ///< L2 norm over supported sides, of what is sought
    double stress;       ///< largest error at the points, by the largest stress there
    Eigen::Index n_free_rigid_motions;
  };
  BoundaryErrors solve(const BoundaryCase &problem);

  /// The sides of closed curves as traces of degree 1, without a mesh.
  std::vector<Trace> traces_of(const std::vector<Curve> &curves);
} // namespace abut
