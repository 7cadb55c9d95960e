// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/archive.h>

#include <Eigen/Core>

#include <cmath>

namespace abut
{
  /// Stress of plane strain, tension positive; zz = nu (xx + yy).
  struct Stress
  {
    double xx = 0., yy = 0., xy = 0., zz = 0.;

    /// Huber-Mises equivalent stress, all four components.
    double von_mises() const
    {
      return std::sqrt(.5 * ((xx - yy) * (xx - yy) + (yy - zz) * (yy - zz) + (zz - xx) * (zz - xx)) +
                       3. * xy * xy);
    }

    /// sigma : sigma, the integrand of the L2 norm over xx, yy, zz and twice xy.
    double square() const { return xx * xx + yy * yy + zz * zz + 2. * xy * xy; }
  };
  template <> inline constexpr bool consists_of_numbers<Stress> = true;

  inline Stress operator+(const Stress &a, const Stress &b)
  {
    return {a.xx + b.xx, a.yy + b.yy, a.xy + b.xy, a.zz + b.zz};
  }

  inline Stress operator*(const Stress &s, const double factor)
  {
    return {s.xx * factor, s.yy * factor, s.xy * factor, s.zz * factor};
  }

  inline Stress operator-(const Stress &a, const Stress &b)
  {
    return {a.xx - b.xx, a.yy - b.yy, a.xy - b.xy, a.zz - b.zz};
  }

  /// Isotropic linear elasticity in plane strain, (1)-(2) of the paper.
  struct Material
  {
    double young_modulus;
    double poisson_ratio;

    double lambda() const
    {
      return young_modulus * poisson_ratio / ((1. + poisson_ratio) * (1. - 2. * poisson_ratio));
    }
    double mu() const { return young_modulus / (2. * (1. + poisson_ratio)); }

    void serialize(Archive &archive) { archive(young_modulus, poisson_ratio); }

    /// sigma = lambda d I + 2 mu eps, from grad u (row: component, column: derivative) and d, which is div u
    /// or stands for it.
    Stress stress(const Eigen::Matrix2d &gradient, const double divergence) const
    {
      const double xx = lambda() * divergence + 2. * mu() * gradient(0, 0);
      const double yy = lambda() * divergence + 2. * mu() * gradient(1, 1);
      return {xx, yy, mu() * (gradient(0, 1) + gradient(1, 0)), poisson_ratio * (xx + yy)};
    }
    /// sigma = lambda tr(eps) I + 2 mu eps.
    Stress stress(const Eigen::Matrix2d &gradient) const { return stress(gradient, gradient.trace()); }

    /// sigma : C^-1 sigma, the integrand of the squared energy norm, for a stress of plane strain.
    double energy_density(const Stress &s) const
    {
      const double trace = s.xx + s.yy + s.zz, nu = poisson_ratio;
      return ((1. + nu) * s.square() - nu * trace * trace) / young_modulus;
    }
  };

  inline bool operator==(const Material &a, const Material &b)
  {
    return a.young_modulus == b.young_modulus && a.poisson_ratio == b.poisson_ratio;
  }
} // namespace abut
