// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/vector_versions.h>
#include <abut/bem/far_pairs.h>

#include <deal.II/base/exceptions.h>

namespace abut
{
  namespace
  {
    constexpr std::size_t far_lanes = FarPairs::n_lanes;

    /// The kernels of one lane at w.
    inline void set_kernels(const double x, const double y, const double second_x, const double second_y,
                            const double first_x, const double first_y, double *const kernels)
    {
      const double square = x * x + y * y, inverse = 1. / square;
      kernels[0] = vector_log(square);
      kernels[far_lanes] = (x * x - y * y) * inverse;
      kernels[2 * far_lanes] = -2. * x * y * inverse;
      kernels[3 * far_lanes] = (second_y * x - second_x * y) * inverse;
      kernels[4 * far_lanes] = (first_y * x - first_x * y) * inverse;
    }

    inline void add_scaled(const double factor, const FarPairs::Kernels &values, FarPairs::Kernels &sum)
    {
      for (std::size_t k = 0; k < FarPairs::n_kernels * far_lanes; ++k)
        sum[k] += factor * values[k];
    }

    /// Sums over the points of both elements.
    ABUT_VECTOR_VERSIONS
    void sum_over_points(const BoundaryElement &first, const FarPairs::Seconds &seconds,
                         const LegendreRule &outer, const LegendreRule &inner, FarPairs::Integrals &integrals)
    {
      const FarPairs::Seconds own = seconds;
      const double half_x = .5 * (first.end - first.start).real(),
                   half_y = .5 * (first.end - first.start).imag(), direction_x = first.direction.real(),
                   direction_y = first.direction.imag();
      const auto size = static_cast<std::size_t>(outer.weighted.cols());
      FarPairs::Kernels values;
      std::array<FarPairs::Kernels, max_density_degree + 1> partial;
      for (std::size_t i = 0; i < size; ++i)
        for (std::size_t j = 0; j < size; ++j)
          integrals[i][j].fill(0.);
      for (Eigen::Index p = 0; p < outer.points.size(); ++p)
      {
        for (std::size_t j = 0; j < size; ++j)
          partial[j].fill(0.);
        for (Eigen::Index q = 0; q < inner.points.size(); ++q)
        {
          const double eta = inner.points[q], x = outer.points[p] * half_x, y = outer.points[p] * half_y;
          for (std::size_t lane = 0; lane < far_lanes; ++lane)
            set_kernels(own.x[lane] - x + eta * own.half_x[lane], own.y[lane] - y + eta * own.half_y[lane],
                        own.direction_x[lane], own.direction_y[lane], direction_x, direction_y,
                        values.data() + lane);
          for (std::size_t j = 0; j < size; ++j)
            add_scaled(inner.weighted(q, static_cast<Eigen::Index>(j)), values, partial[j]);
        }
        for (std::size_t i = 0; i < size; ++i)
          for (std::size_t j = 0; j < size; ++j)
            add_scaled(outer.weighted(p, static_cast<Eigen::Index>(i)), partial[j], integrals[i][j]);
      }
    }
  } // namespace

  FarPairs::FarPairs(const GalerkinRule &rule, const unsigned int degree)
      : degree_(degree), n_distances_(static_cast<int>(rule.far.size()))
  {
    Assert(degree <= max_density_degree, dealii::ExcMessage("no such polynomials"));
    for (const GalerkinRule::FarPoints &far : rule.far)
    {
      distances_.push_back(far.distance);
      rules_.emplace_back(GalerkinRule::points(far.n_points, degree), degree);
    }
  }

  void FarPairs::set_seconds(const BoundaryElement &first, const Partners &seconds)
  {
    for (std::size_t lane = 0; lane < n_lanes; ++lane)
    {
      const BoundaryElement &second = *seconds[lane];
      // Differences of vertices before sums: the distance keeps its digits.
      const Complex centre = .5 * ((second.start - first.start) + (second.end - first.end));
      seconds_.x[lane] = centre.real();
      seconds_.y[lane] = centre.imag();
      seconds_.half_x[lane] = .5 * (second.end - second.start).real();
      seconds_.half_y[lane] = .5 * (second.end - second.start).imag();
      seconds_.direction_x[lane] = second.direction.real();
      seconds_.direction_y[lane] = second.direction.imag();
      scale_[lane] = .25 * first.length * second.length;
    }
  }

  void FarPairs::integrate(const BoundaryElement &first, const Partners &seconds,
                           const std::size_t first_tier, const std::size_t second_tier)
  {
    AssertIndexRange(first_tier, n_tiers());
    AssertIndexRange(second_tier, n_tiers());
    set_seconds(first, seconds);
    sum_over_points(first, seconds_, rules_[first_tier], rules_[second_tier], integrals_);
  }

  void FarPairs::copy(const std::size_t lane, PairIntegrals &integrals) const
  {
    AssertIndexRange(lane, n_lanes);
    AssertDimension(integrals.log.rows(), static_cast<Eigen::Index>(degree_ + 1));
    const double scale = scale_[lane], by_two_pi = scale / (2. * M_PI);
    const std::array<double, n_kernels> factors = {{.5 * scale, scale, scale, -by_two_pi, by_two_pi}};
    const std::array<double *, n_kernels> blocks = {
        {integrals.log.data(), integrals.even_real.data(), integrals.even_imag.data(),
         integrals.double_layer.data(), integrals.reversed.data()}};
    std::size_t place = 0;
    for (unsigned int j = 0; j <= degree_; ++j)
      for (unsigned int i = 0; i <= degree_; ++i, ++place)
      {
        const double *const values = integrals_[i][j].data() + lane;
        for (std::size_t k = 0; k < n_kernels; ++k)
          blocks[k][place] = factors[k] * values[k * n_lanes];
      }
  }
} // namespace abut
