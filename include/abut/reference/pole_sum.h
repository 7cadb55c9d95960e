// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/reference/periodic_pressure.h>

#include <array>
#include <vector>

namespace abut
{
  /// A piece of pressure, sum_n c_n P_n, between origin + start and origin + end. Positions are kept as
  /// distances from a mirror, which are exact.
  struct PressureSegment
  {
    double origin;
    double start;
    double end;
    std::array<double, 4> legendre;

    double from() const { return origin + start; }
    double to() const { return origin + end; }
  };

  /**
   * (i/pi) int p(s)/(z - s) ds of many segments, and its derivative. Segments near z are integrated in closed
   * form (legendre_second_kind); of others, whole groups by their moments: sum_k M_k/(z - c)^(k+1) about the
   * middle c of the group, with an error of 1e-16 of its pressure where z is three times farther than its
   * ends.
   */
  class PoleSum
  {
  public:
    PoleSum() = default;
    /// The segments in any order.
    explicit PoleSum(std::vector<PressureSegment> segments);

    PeriodicPressure::Potential operator()(std::complex<double> z) const;
    const std::vector<PressureSegment> &segments() const { return segments_; }

  private:
    static constexpr std::size_t n_moments = 36; ///< 3^-36 < 1e-17

    /// The segments [first, last) of the sorted list, and the groups that it consists of; none: a small one.
    struct Group
    {
      std::size_t first = 0, last = 0;
      double middle = 0., radius = 0.;
      std::array<double, n_moments> moments{}; ///< by powers of the radius
      std::vector<std::size_t> halves;
    };

    std::size_t add_group(std::size_t first, std::size_t last);
    void add_near(const PressureSegment &segment, std::complex<double> z,
                  PeriodicPressure::Potential &sum) const;
    void add(std::size_t group, std::complex<double> z, PeriodicPressure::Potential &sum) const;

    std::vector<PressureSegment> segments_; // from left to right
    std::vector<Group> groups_;             // the last one has all
  };
} // namespace abut
