// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/contact/pressure_profile.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <tuple>

namespace abut
{
  PressureProfile::PressureProfile(const ContactSurface &surface, const Eigen::VectorXd &pressures)
      : intervals_(intervals_of(surface)), pressures_(pressures)
  {
    AssertDimension(pressures.size(), surface.n_parts());
  }

  std::vector<PressureProfile::Interval> PressureProfile::intervals_of(const ContactSurface &surface)
  {
    std::vector<Interval> intervals;
    for (const Piece &piece : surface.partition().pieces())
    {
      const std::size_t side = surface.cut_side_of(piece);
      const Trace &trace = *surface.cut_sides()[side];
      const Segment &segment = trace.segments()[piece.cut_segment];
      const auto share = [&](const double s) {
        return (segment.arc_start + s * segment.length) / trace.length();
      };
      intervals.push_back({side, share(piece.start), share(piece.end), piece.part});
    }
    std::sort(intervals.begin(), intervals.end(), [](const Interval &a, const Interval &b) {
      return std::tie(a.side, a.start) < std::tie(b.side, b.start);
    });
    return intervals;
  }

  Eigen::VectorXd PressureProfile::on_parts_of(const ContactSurface &surface) const
  {
    Eigen::VectorXd lengths = Eigen::VectorXd::Zero(surface.n_parts()), sums = lengths;
    auto first = intervals_.begin(); // that may still meet the present interval
    for (const Interval &interval : intervals_of(surface))
    {
      while (first != intervals_.end() &&
             std::tie(first->side, first->end) < std::tie(interval.side, interval.start))
        ++first;
      const double side_length = surface.cut_sides()[interval.side]->length();
      const auto part = static_cast<Eigen::Index>(interval.part);
      lengths[part] += side_length * (interval.end - interval.start);
      for (auto old = first;
           old != intervals_.end() && old->side == interval.side && old->start < interval.end; ++old)
        sums[part] += side_length * pressures_[static_cast<Eigen::Index>(old->part)] *
                      std::max(0., std::min(old->end, interval.end) - std::max(old->start, interval.start));
    }
    return sums.cwiseQuotient(lengths);
  }
} // namespace abut
