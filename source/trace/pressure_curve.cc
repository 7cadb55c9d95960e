// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/trace/pressure_curve.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

namespace abut
{
  namespace
  {
    /// A value and its place along a surface.
    struct Node
    {
      double place, value;
    };

    double secant(const Node &from, const Node &to)
    {
      return to.place > from.place ? (to.value - from.value) / (to.place - from.place) : 0.;
    }

    /// The values at the places of one stretch and what is between them.
    class MonotoneCubic
    {
    public:
      MonotoneCubic(const Partition &partition, const Eigen::VectorXd &values, const std::size_t part)
          : partition_(partition), values_(values), stretch_(partition.stretch_of(part)),
            part_(static_cast<std::ptrdiff_t>(part - stretch_.first))
      {}

      /// At a place between those of the neighbours of the part.
      double at(const double arc) const
      {
        const std::ptrdiff_t left = arc < node(part_).place ? part_ - 1 : part_;
        if (!exists(left) || !exists(left + 1))
          return node(part_).value;
        const Node from = node(left), to = node(left + 1);
        const double h = to.place - from.place;
        if (!(h > 0.))
          return to.value;
        const double s = (arc - from.place) / h, r = 1. - s;
        if (from.value == 0. || to.value == 0.) // an end of contact: concave, not flat
          return r * from.value + s * to.value;
        return r * r * (1. + 2. * s) * from.value + s * s * (1. + 2. * r) * to.value +
               h * s * r * (r * slope(left) - s * slope(left + 1));
      }

    private:
      std::ptrdiff_t size() const { return static_cast<std::ptrdiff_t>(stretch_.last - stretch_.first); }
      /// Positions in the stretch; those of a closed one go on round it.
      bool exists(const std::ptrdiff_t i) const
      {
        return (stretch_.closed && size() > 1) || (i >= 0 && i < size());
      }
      Node node(const std::ptrdiff_t i) const
      {
        const std::ptrdiff_t rounds = i >= 0 ? i / size() : -1;
        const std::size_t k = stretch_.first + static_cast<std::size_t>(i - rounds * size());
        return {partition_.parts()[k].place_arc + static_cast<double>(rounds) * stretch_.length,
                values_[static_cast<Eigen::Index>(k)]};
      }

      double slope(const std::ptrdiff_t i) const
      {
        if (!exists(i - 1))
          return end_slope(node(i), node(i + 1), exists(i + 2) ? node(i + 2) : node(i + 1));
        if (!exists(i + 1))
          return end_slope(node(i), node(i - 1), exists(i - 2) ? node(i - 2) : node(i - 1));
        const Node before = node(i - 1), here = node(i), after = node(i + 1);
        const double a = secant(before, here), b = secant(here, after);
        if (!(a * b > 0.))
          return 0.;
        const double to_left = here.place - before.place, to_right = after.place - here.place,
                     share = (to_left + 2. * to_right) / (3. * (to_left + to_right));
        return a * b / (share * b + (1. - share) * a);
      }

      /// Of the parabola through three nodes, as far as that keeps the curve monotone.
      static double end_slope(const Node &end, const Node &next, const Node &second)
      {
        const double a = (next.value - end.value) / (next.place - end.place);
        if (second.place == next.place)
          return a;
        const double b = (second.value - next.value) / (second.place - next.place),
                     slope = a + (a - b) * (next.place - end.place) / (second.place - end.place);
        if (!(slope * a > 0.))
          return 0.;
        return std::abs(slope) > 3. * std::abs(a) ? 3. * a : slope;
      }

      const Partition &partition_;
      const Eigen::VectorXd &values_;
      const Stretch &stretch_;
      const std::ptrdiff_t part_;
    };

    /// From where the parts of an end begin, outwards.
    double outwards(const Partition &partition, const ContactEnd &end, const double arc)
    {
      const Stretch &stretch = partition.stretch_of(end.parts.front());
      const double ahead = arc - end.start;
      return end.direction * (stretch.closed ? std::remainder(ahead, stretch.length) : ahead);
    }
  } // namespace

  PressureCurve::PressureCurve(const Partition &partition, const Eigen::VectorXd &loads,
                               const bool ends_like_root)
      : partition_(&partition), end_of_part_(partition.parts().size(), -1),
        values_(partition.reported_pressures(loads))
  {
    if (!ends_like_root)
      return;
    ends_ = find_contact_ends(partition, loads);
    for (std::size_t i = 0; i < ends_.size(); ++i)
      for (const std::size_t k : ends_[i].parts)
      {
        const auto row = static_cast<Eigen::Index>(k);
        end_of_part_[k] = static_cast<int>(i);
        if (loads[row] > 0.)
          values_[row] = ends_[i].pressure(outwards(partition, ends_[i], partition.parts()[k].place_arc));
      }
  }

  double PressureCurve::at(const std::size_t part, const double arc) const
  {
    AssertIndexRange(part, end_of_part_.size());
    if (const int end = end_of_part_[part]; end >= 0)
    {
      const ContactEnd &there = ends_[static_cast<std::size_t>(end)];
      return there.pressure(outwards(*partition_, there, arc));
    }
    return std::max(0., MonotoneCubic(*partition_, values_, part).at(arc));
  }
} // namespace abut
