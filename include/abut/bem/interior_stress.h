// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/material.h>
#include <abut/bem/stress_group.h>

#include <Eigen/Core>

#include <vector>

namespace abut
{
  /**
   * What the stress inside follows from, on each element a polynomial in eta: coefficients of the Legendre
   * polynomials P_0, P_1, ... in the rows (at most max_density_degree + 1 of them), one column per element.
   * The two may differ in degree.
   */
  struct BoundaryValues
  {
    Eigen::MatrixXcd traction; ///< t_x + i t_y, the force per length that acts on the body
    Eigen::MatrixXcd slope;    ///< d(u_x + i u_y)/ds along the element's direction, dimensionless
  };

  /**
   * Stress of plane strain inside a body from tractions and slopes of the displacement on its boundary. With
   * zeta on the boundary, w = zeta - z, k = 3 - 4 nu and
   *
   *   q = (i t + 2 G du/ds) / (k + 1),   p = -i conj(t) - conj(q)
   *   s_xx + s_yy           = 4 Re (1/(2 pi i)) int q/w ds
   *   s_yy - s_xx + 2i s_xy = (1/(pi i)) int (p/w - conj(w) q/w^2) ds,   s_zz = nu (s_xx + s_yy)
   *
   * These are Cauchy's integrals of the potentials of Kolosov and Muskhelishvili
   * [Muskhelishvili1953, chapter 2]: q ds is d(phi), so that a translation does not enter at
   * all and a rotation only as a constant of q. Own derivation.
   *
   * The elements close the boundary of the body, in any order, each run through with the body on its left.
   * Inside, the result is as accurate as the values given, to about 1e-14 of the largest traction and 2 G
   * times the largest slope, down to 1e-12 lengths from an element; outside it is zero. A point on the
   * boundary itself is not served (it yields either limit, or nothing finite at a node): see
   * boundary_stress(). Near a node where values jump that ought not to, the stress has the logarithm that
   * belongs to the jump.
   */
  class InteriorStress
  {
  public:
    /// Throws std::invalid_argument if the values do not fit the elements or their degree is too high.
    InteriorStress(const std::vector<BoundaryElement> &elements, const BoundaryValues &values,
                   double shear_modulus, double poisson_ratio);

    Stress at(Complex z) const;
    /// The same at many points, to the last bit: on several threads where there is enough to do.
    std::vector<Stress> at(const std::vector<Complex> &points) const;

  private:
    void evaluate(const Complex *points, std::size_t n_points, Stress *stresses) const;

    std::size_t n_elements_;
    double poisson_ratio_;
    StressRules rules_;
    std::vector<StressGroup> groups_;
  };

  /// The higher of both degrees. Throws std::invalid_argument where values do not fit the elements or their
  /// degree is too high.
  unsigned int checked_degree(std::size_t n_elements, const BoundaryValues &values);
  /// The densities p and q of InteriorStress.
  std::vector<StressDensity> stress_densities(const BoundaryValues &values, double shear_modulus,
                                              double poisson_ratio);
  /// From the sums over all elements.
  Stress interior_stress(const StressSums &sums, double poisson_ratio);

  /**
   * Stress on the boundary itself, in plane strain, from traction and slope there; direction is that of the
   * element, with the body on its left, n = -i direction and tau = direction:
   *
   *   s_nn = t.n,   s_nt = t.tau,   s_tt = 2 G/(1 - nu) tau.du/ds + nu/(1 - nu) s_nn
   *
   * (Hooke's law; finite up to nu = 1/2).
   */
  Stress boundary_stress(Complex traction, Complex slope, Complex direction, double shear_modulus,
                         double poisson_ratio);
} // namespace abut
