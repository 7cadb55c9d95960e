// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/reference/legendre_second_kind.h>
#include <abut/reference/pole_sum.h>

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>

namespace abut
{
  namespace
  {
    constexpr double pole_pi = boost::math::constants::pi<double>();
    constexpr double far_ratio = 3.;       // of the distance by the radius of a group
    constexpr std::size_t small_group = 2; // segments that are not worth moments of their own

    double at_legendre(const std::array<double, 4> &c, const double t)
    {
      return c[0] + t * (c[1] + 1.5 * c[2] * t + .5 * c[3] * (5. * t * t - 3.)) - .5 * c[2];
    }
  } // namespace

  PoleSum::PoleSum(std::vector<PressureSegment> segments) : segments_(std::move(segments))
  {
    std::sort(segments_.begin(), segments_.end(),
              [](const PressureSegment &a, const PressureSegment &b) { return a.from() < b.from(); });
    if (!segments_.empty())
      add_group(0, segments_.size());
  }

  std::size_t PoleSum::add_group(const std::size_t first, const std::size_t last)
  {
    Group group;
    group.first = first;
    group.last = last;
    const double from = segments_[first].from(), to = segments_[last - 1].to();
    group.middle = .5 * (from + to);
    group.radius = .5 * (to - from);
    if (last - first > small_group)
    {
      // 20 Gauss points integrate the powers exactly
      using Gauss = boost::math::quadrature::gauss<double, 20>;
      for (std::size_t i = first; i < last; ++i)
      {
        const double half = .5 * (segments_[i].end - segments_[i].start);
        for (std::size_t q = 0; q < Gauss::abscissa().size(); ++q)
          for (const double t : {-Gauss::abscissa()[q], Gauss::abscissa()[q]})
          {
            const double place = (segments_[i].from() + half * (1. + t) - group.middle) / group.radius;
            double term = half * Gauss::weights()[q] * at_legendre(segments_[i].legendre, t);
            for (double &moment : group.moments)
            {
              moment += term;
              term *= place;
            }
          }
      }
      // halves by place: images lie far from what they mirror
      const auto split = std::upper_bound(
          segments_.begin() + static_cast<std::ptrdiff_t>(first) + 1,
          segments_.begin() + static_cast<std::ptrdiff_t>(last) - 1, group.middle,
          [](const double place, const PressureSegment &segment) { return place < segment.from(); });
      const auto middle = static_cast<std::size_t>(split - segments_.begin());
      group.halves = {add_group(first, middle), add_group(middle, last)};
    }
    groups_.push_back(group);
    return groups_.size() - 1;
  }

  // The slope by (tau^2 - 1) Q_n' = n (tau Q_n - Q_{n-1}) and (tau^2 - 1) Q_0' = -1.
  void PoleSum::add_near(const PressureSegment &segment, const std::complex<double> z,
                         PeriodicPressure::Potential &sum) const
  {
    const std::complex<double> from_start = z - segment.origin - segment.start;
    const std::complex<double> from_end = z - segment.origin - segment.end;
    const double half = 0.5 * (segment.end - segment.start);
    const std::complex<double> tau = 0.5 * (from_start + from_end) / half;
    const LegendreSecondKind q = legendre_second_kind(from_start, from_end);
    const std::array<double, 4> &c = segment.legendre;
    sum.value += 2. * (c[0] * q[0] + c[1] * q[1] + c[2] * q[2] + c[3] * q[3]);
    const std::complex<double> slope =
        c[1] * (tau * q[1] - q[0]) + 2. * c[2] * (tau * q[2] - q[1]) + 3. * c[3] * (tau * q[3] - q[2]) - c[0];
    const std::complex<double> square = from_start * from_end;
    sum.slope += 2. * half / std::norm(square) * std::conj(square) * slope;
  }

  void PoleSum::add(const std::size_t index, const std::complex<double> z,
                    PeriodicPressure::Potential &sum) const
  {
    const Group &group = groups_[index];
    const std::complex<double> from_middle = z - group.middle;
    if (group.halves.empty())
      for (std::size_t i = group.first; i < group.last; ++i)
        add_near(segments_[i], z, sum);
    else if (std::norm(from_middle) < far_ratio * far_ratio * group.radius * group.radius)
      for (const std::size_t half : group.halves)
        add(half, z, sum);
    else
    {
      const std::complex<double> inverse = std::conj(from_middle) / std::norm(from_middle);
      const std::complex<double> step = group.radius * inverse;
      std::complex<double> value = 0., slope = 0.;
      for (std::size_t k = n_moments; k-- > 0;)
      {
        value = value * step + group.moments[k];
        slope = slope * step + double(k + 1) * group.moments[k];
      }
      sum.value += inverse * value;
      sum.slope -= inverse * inverse * slope;
    }
  }

  PeriodicPressure::Potential PoleSum::operator()(const std::complex<double> z) const
  {
    PeriodicPressure::Potential sum{0., 0.};
    if (!groups_.empty())
      add(groups_.size() - 1, z, sum);
    const std::complex<double> factor(0., 1. / pole_pi);
    return {factor * sum.value, factor * sum.slope};
  }
} // namespace abut
