// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bem/far_pairs.h>

#include <deal.II/base/exceptions.h>

namespace abut
{
  FarPairs::FarPairs(const GalerkinRule &rule, const unsigned int degree) : degree_(degree)
  {
    Assert(degree <= max_density_degree, dealii::ExcMessage("no such polynomials"));
    for (const GalerkinRule::FarPoints &far : rule.far)
    {
      distances_.push_back(far.distance);
      rules_.emplace_back(GalerkinRule::points(far.n_points, degree), degree);
    }
  }

  int FarPairs::tier(const double distance, const double length) const
  {
    int index = -1;
    for (const double least : distances_)
      if (distance >= least * length)
        ++index;
    return index;
  }

  void FarPairs::set_seconds(const BoundaryElement &first, const Partners &seconds)
  {
    for (std::size_t lane = 0; lane < n_lanes; ++lane)
    {
      const BoundaryElement &second = *seconds[lane];
      // Differences of vertices before sums: the distance keeps its digits.
      const Complex centre = .5 * ((second.start - first.start) + (second.end - first.end));
      const auto k = static_cast<Eigen::Index>(lane);
      seconds_.x[k] = centre.real();
      seconds_.y[k] = centre.imag();
      seconds_.half_x[k] = .5 * (second.end - second.start).real();
      seconds_.half_y[k] = .5 * (second.end - second.start).imag();
      seconds_.direction_x[k] = second.direction.real();
      seconds_.direction_y[k] = second.direction.imag();
      scale_[k] = .25 * first.length * second.length;
    }
  }

  FarPairs::Kernels FarPairs::kernels(const Seconds &seconds, const Lanes &x, const Lanes &y,
                                      const Complex first_direction)
  {
    const Lanes square = x * x + y * y, inverse = 1. / square;
    return {{square.log(), (x * x - y * y) * inverse, -2. * x * y * inverse,
             (seconds.direction_y * x - seconds.direction_x * y) * inverse,
             (first_direction.imag() * x - first_direction.real() * y) * inverse}};
  }

  void FarPairs::integrate(const BoundaryElement &first, const Partners &seconds,
                           const std::size_t first_tier, const std::size_t second_tier)
  {
    AssertIndexRange(first_tier, n_tiers());
    AssertIndexRange(second_tier, n_tiers());
    const LegendreRule &outer = rules_[first_tier], &inner = rules_[second_tier];
    const unsigned int size = degree_ + 1;
    const Complex half = .5 * (first.end - first.start);
    set_seconds(first, seconds);
    std::array<Kernels, max_density_degree + 1> partial;
    for (unsigned int i = 0; i < size; ++i)
      for (unsigned int j = 0; j < size; ++j)
        integrals_[i][j].fill(Lanes::Zero());
    for (Eigen::Index p = 0; p < outer.points.size(); ++p)
    {
      const Lanes x = seconds_.x - outer.points[p] * half.real(),
                  y = seconds_.y - outer.points[p] * half.imag();
      for (unsigned int j = 0; j < size; ++j)
        partial[j].fill(Lanes::Zero());
      for (Eigen::Index q = 0; q < inner.points.size(); ++q)
      {
        const double eta = inner.points[q];
        const Kernels values =
            kernels(seconds_, x + eta * seconds_.half_x, y + eta * seconds_.half_y, first.direction);
        for (unsigned int j = 0; j < size; ++j)
          for (unsigned int k = 0; k < values.size(); ++k)
            partial[j][k] += inner.weighted(q, j) * values[k];
      }
      for (unsigned int i = 0; i < size; ++i)
        for (unsigned int j = 0; j < size; ++j)
          for (unsigned int k = 0; k < partial[j].size(); ++k)
            integrals_[i][j][k] += outer.weighted(p, i) * partial[j][k];
    }
  }

  void FarPairs::copy(const std::size_t lane, PairIntegrals &integrals) const
  {
    AssertIndexRange(lane, n_lanes);
    AssertDimension(integrals.log.rows(), static_cast<Eigen::Index>(degree_ + 1));
    const auto l = static_cast<Eigen::Index>(lane);
    const double scale = scale_[l], by_two_pi = scale / (2. * M_PI);
    for (unsigned int j = 0; j <= degree_; ++j)
      for (unsigned int i = 0; i <= degree_; ++i)
      {
        const Kernels &values = integrals_[i][j];
        integrals.log(i, j) = .5 * scale * values[0][l];
        integrals.even_real(i, j) = scale * values[1][l];
        integrals.even_imag(i, j) = scale * values[2][l];
        integrals.double_layer(i, j) = -by_two_pi * values[3][l];
        integrals.reversed(i, j) = by_two_pi * values[4][l];
      }
  }
} // namespace abut
