// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/executor.h>
#include <abut/bem/interior_stress.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace abut
{
  namespace
  {
    constexpr std::size_t stress_tile = 16; // points that share the elements in the cache

    /// From s_xx + s_yy and s_yy - s_xx + 2i s_xy.
    Stress plane_strain_stress(const double trace, const Complex deviator, const double poisson_ratio)
    {
      return {.5 * (trace - deviator.real()), .5 * (trace + deviator.real()), .5 * deviator.imag(),
              poisson_ratio * trace};
    }
  } // namespace

  unsigned int checked_degree(const std::size_t n_elements, const BoundaryValues &values)
  {
    for (const Eigen::MatrixXcd *matrix : {&values.traction, &values.slope})
      if (matrix->cols() != static_cast<Eigen::Index>(n_elements) || matrix->rows() < 1 ||
          matrix->rows() > max_density_degree + 1)
        throw std::invalid_argument("InteriorStress: " + std::to_string(matrix->rows()) + " x " +
                                    std::to_string(matrix->cols()) + " values for " +
                                    std::to_string(n_elements) +
                                    " elements; allowed are one column per element and 1 to " +
                                    std::to_string(max_density_degree + 1) + " rows");
    return static_cast<unsigned int>(std::max(values.traction.rows(), values.slope.rows())) - 1;
  }

  std::vector<StressDensity> stress_densities(const BoundaryValues &values, const double shear_modulus,
                                              const double poisson_ratio)
  {
    const Complex i(0., 1.); // the polynomials are real: conj acts on their coefficients
    std::vector<StressDensity> densities(static_cast<std::size_t>(values.traction.cols()));
    for (std::size_t e = 0; e < densities.size(); ++e)
      for (unsigned int n = 0; n <= max_density_degree; ++n)
      {
        const auto column = static_cast<Eigen::Index>(e);
        const Complex t = n < values.traction.rows() ? values.traction(n, column) : Complex(0.);
        const Complex g = n < values.slope.rows() ? values.slope(n, column) : Complex(0.);
        densities[e].q[n] = (i * t + 2. * shear_modulus * g) / (4. - 4. * poisson_ratio);
        densities[e].p[n] = -i * std::conj(t) - std::conj(densities[e].q[n]);
      }
    return densities;
  }

  Stress interior_stress(const StressSums &sums, const double poisson_ratio)
  {
    const double pi = std::acos(-1.);
    return plane_strain_stress(2. / pi * sums.q_imag, Complex(sums.p_imag, -sums.p_real) / pi, poisson_ratio);
  }

  InteriorStress::InteriorStress(const std::vector<BoundaryElement> &elements, const BoundaryValues &values,
                                 const double shear_modulus, const double poisson_ratio)
      : n_elements_(elements.size()), poisson_ratio_(poisson_ratio),
        rules_(checked_degree(elements.size(), values))
  {
    Assert(shear_modulus > 0., dealii::ExcMessage("a body has a stiffness"));
    const std::vector<StressDensity> densities = stress_densities(values, shear_modulus, poisson_ratio);
    for (std::size_t first = 0; first < n_elements_; first += StressGroup::max_size)
    {
      const std::size_t size = std::min<std::size_t>(StressGroup::max_size, n_elements_ - first);
      groups_.emplace_back(&elements[first], &densities[first], static_cast<unsigned int>(size), rules_);
    }
  }

  Stress InteriorStress::at(const Complex z) const
  {
    Stress stress;
    evaluate(&z, 1, &stress);
    return stress;
  }

  std::vector<Stress> InteriorStress::at(const std::vector<Complex> &points) const
  {
    std::vector<Stress> stresses(points.size());
    const std::size_t n_tiles = (points.size() + stress_tile - 1) / stress_tile;
    for_each(n_tiles, [&](const std::size_t tile) {
      const std::size_t first = tile * stress_tile;
      evaluate(&points[first], std::min(stress_tile, points.size() - first), &stresses[first]);
    });
    return stresses;
  }

  void InteriorStress::evaluate(const Complex *points, const std::size_t n_points, Stress *stresses) const
  {
    std::array<StressSums, stress_tile> sums;
    for (const StressGroup &group : groups_)
      for (std::size_t i = 0; i < n_points; ++i)
        group.add(rules_, points[i], sums[i]);
    for (std::size_t i = 0; i < n_points; ++i)
      stresses[i] = interior_stress(sums[i], poisson_ratio_);
  }

  Stress boundary_stress(const Complex traction, const Complex slope, const Complex direction,
                         const double shear_modulus, const double poisson_ratio)
  {
    Assert(std::abs(std::abs(direction) - 1.) < 1e-8, dealii::ExcMessage("directions have unit length"));
    const Complex normal(direction.imag(), -direction.real());
    const Complex in_frame = traction * std::conj(normal); // s_nn + i s_nt
    const double s_nn = in_frame.real(), s_nt = in_frame.imag();
    const double stretch = (slope * std::conj(direction)).real();
    const double s_tt = (2. * shear_modulus * stretch + poisson_ratio * s_nn) / (1. - poisson_ratio);
    const Complex turn = std::conj(normal);
    return plane_strain_stress(s_nn + s_tt, Complex(s_tt - s_nn, 2. * s_nt) * turn * turn, poisson_ratio);
  }
} // namespace abut
