// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/lagrange_basis.h>
#include <abut/bem/galerkin_rule.h>
#include <abut/bem/legendre_moments.h>

#include <deal.II/base/exceptions.h>

namespace abut
{
  GalerkinRule GalerkinRule::precise()
  {
    return {24, 7, 10, 1., {{1., 12}, {2., 8}, {4., 6}, {16., 4}, {64., 3}}};
  }

  GalerkinRule GalerkinRule::estimating()
  {
    return {6, 3, 3, 2., {{1., 5}, {4., 3}, {16., 2}}};
  }

  LegendreRule::LegendreRule(const unsigned int n_points, const unsigned int degree)
  {
    Assert(degree <= max_density_degree, dealii::ExcMessage("no such polynomials"));
    const GaussRule gauss(n_points);
    points = 2. * gauss.points.array() - 1.;
    weighted.resize(n_points, degree + 1);
    for (Eigen::Index q = 0; q < n_points; ++q)
    {
      const auto p = legendre_values(points[q]);
      for (unsigned int n = 0; n <= degree; ++n)
        weighted(q, n) = 2. * gauss.weights[q] * p[n];
    }
  }
} // namespace abut
