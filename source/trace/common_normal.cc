// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/plane_geometry.h>
#include <abut/trace/common_normal.h>

#include <deal.II/base/exceptions.h>

#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace abut
{
  namespace
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double smallest_cosine = .2; // between the common normal and either side's

    double shortest_segment(const Trace &side)
    {
      return std::min_element(side.segments().begin(), side.segments().end(),
                              [](const Segment &a, const Segment &b) { return a.length < b.length; })
          ->length;
    }

    /// A zero of f in [0, 1], from its values at the ends; the nearer end where they have one sign.
    template <typename Function>
    double zero_between(const Function &f, const double at_start, const double at_end)
    {
      if (!(at_start * at_end < 0.))
        return std::abs(at_start) <= std::abs(at_end) ? 0. : 1.;
      std::uintmax_t most_steps = 60;
      const auto [low, high] = boost::math::tools::toms748_solve(
          f, 0., 1., at_start, at_end, boost::math::tools::eps_tolerance<double>(52), most_steps);
      return .5 * (low + high);
    }
  } // namespace

  CommonNormal::CommonNormal(const Trace &cut, const Trace &other)
      : cut_(cut), other_(other), cut_weight_(cut, shortest_segment(other)),
        other_weight_(other, shortest_segment(cut)), cut_ends_(ends_of(cut, cut_weight_)),
        other_ends_(ends_of(other, other_weight_)), blocks_(make_blocks())
  {}

  CommonNormal::Place CommonNormal::place_on(const Trace &side, const NormalWeight &weight,
                                             const std::size_t segment, const double s)
  {
    AssertIndexRange(segment, side.segments().size());
    Assert(s > -1e-9 && s < 1. + 1e-9, dealii::ExcMessage("a place of a segment lies in [0, 1]"));
    const Segment &at = side.segments()[segment];
    return {side.point(at, s), Trace::averaged_normal(at, s), weight.at(segment, s)};
  }

  CommonNormal::Ends CommonNormal::ends_of(const Trace &side, const NormalWeight &weight)
  {
    Ends ends;
    for (std::size_t i = 0; i < side.segments().size(); ++i)
      ends.push_back({{place_on(side, weight, i, 0.), place_on(side, weight, i, 1.)}});
    return ends;
  }

  Vector2 CommonNormal::direction(const Place &cut, const Place &other)
  {
    return (other.weight * cut.normal - cut.weight * other.normal) / (cut.weight + other.weight);
  }

  double CommonNormal::offset(const Place &cut, const Place &other)
  {
    return cross(other.point - cut.point, direction(cut, other));
  }

  std::optional<CommonNormal::Facing> CommonNormal::facing(const std::size_t segment, const double s,
                                                           const double deepest) const
  {
    const Place place = place_on(cut_, cut_weight_, segment, s);
    std::optional<Facing> first;
    const auto look_at = [&](const std::size_t j) {
      // With its body on the left, the other side faces this one when it runs across the normal from left to
      // right.
      if (!(offset(place, other_ends_[j][0]) <= 0. && offset(place, other_ends_[j][1]) > 0.))
        return;
      const Facing facing = project(place, j);
      if (look_at_each_other(place, facing) && facing.opposite.gap >= -deepest &&
          (!first || facing.opposite.gap < first->opposite.gap))
        first = facing;
    };
    for (const Block &block : blocks_)
      if (sign_of_offsets(place, block) == 0)
        for (std::size_t j = block.first; j < block.last; ++j)
          look_at(j);
    return first;
  }

  bool CommonNormal::look_at_each_other(const Place &place, const Facing &facing) const
  {
    const Vector2 there = Trace::averaged_normal(other_.segments()[facing.segment], facing.opposite.t);
    return facing.opposite.normal.dot(place.normal) > smallest_cosine &&
           facing.opposite.normal.dot(there) < -smallest_cosine;
  }

  Opposite CommonNormal::project(const std::size_t segment, const double s,
                                 const std::size_t other_segment) const
  {
    return project(place_on(cut_, cut_weight_, segment, s), other_segment).opposite;
  }

  CommonNormal::Facing CommonNormal::project(const Place &place, const std::size_t other_segment) const
  {
    AssertIndexRange(other_segment, other_ends_.size());
    const auto &ends = other_ends_[other_segment];
    const auto miss = [&](const double t) {
      return offset(place, place_on(other_, other_weight_, other_segment, t));
    };
    const double t = zero_between(miss, offset(place, ends[0]), offset(place, ends[1]));
    const Place other = place_on(other_, other_weight_, other_segment, t);
    const Vector2 normal = direction(place, other).normalized();
    return {other_segment, {t, (other.point - place.point).dot(normal), normal}};
  }

  std::optional<double> CommonNormal::place_opposite(const std::size_t segment,
                                                     const std::size_t other_segment, const double t) const
  {
    AssertIndexRange(other_segment, other_ends_.size());
    const auto &ends = other_ends_[other_segment];
    return place_opposite(segment, t == 0.   ? ends[0]
                                   : t == 1. ? ends[1]
                                             : place_on(other_, other_weight_, other_segment, t));
  }

  std::vector<double> CommonNormal::places_opposite_ends(const std::size_t segment) const
  {
    AssertIndexRange(segment, cut_ends_.size());
    const auto &[start, end] = cut_ends_[segment];
    std::vector<double> places;
    for (const Block &block : blocks_)
    {
      const int at_start = sign_of_offsets(start, block);
      if (at_start != 0 && at_start == sign_of_offsets(end, block))
        continue;
      for (std::size_t j = block.first; j < block.last; ++j)
        for (const Place &other : other_ends_[j])
          if (const auto place = place_opposite(segment, other))
            places.push_back(*place);
    }
    return places;
  }

  std::optional<double> CommonNormal::place_opposite(const std::size_t segment, const Place &other) const
  {
    AssertIndexRange(segment, cut_ends_.size());
    const auto &[start, end] = cut_ends_[segment];
    const double at_start = offset(start, other), at_end = offset(end, other);
    if (!(at_start * at_end < 0.))
      return {};
    return zero_between(
        [&](const double s) { return offset(place_on(cut_, cut_weight_, segment, s), other); }, at_start,
        at_end);
  }

  std::vector<CommonNormal::Block> CommonNormal::make_blocks() const
  {
    const std::size_t n = other_ends_.size();
    const auto size = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(n))));
    std::vector<Block> blocks;
    for (std::size_t first = 0; first < n; first += size)
    {
      Block block{first, std::min(first + size, n), {0., 0.}, 0., {0., 0.}, 0., infinity, 0.};
      const auto for_each_end = [&](const auto &f) {
        for (std::size_t j = block.first; j < block.last; ++j)
          for (const Place &place : other_ends_[j])
            f(place);
      };
      const double share = .5 / static_cast<double>(block.last - block.first);
      for_each_end([&](const Place &place) {
        block.centre += share * place.point;
        block.normal += share * place.normal;
      });
      for_each_end([&](const Place &place) {
        block.radius = std::max(block.radius, (place.point - block.centre).norm());
        block.spread = std::max(block.spread, (place.normal - block.normal).norm());
        block.least = std::min(block.least, place.weight);
        block.most = std::max(block.most, place.weight);
      });
      blocks.push_back(block);
    }
    return blocks;
  }

  int CommonNormal::sign_of_offsets(const Place &cut, const Block &block)
  {
    // The common normal is d = a n_x - (1 - a) n_y, no longer than 1. With that of the block, d_0, and its
    // centre c
    //   (y - x) x d = (c - x) x d_0 + (y - c) x d + (c - x) x (d - d_0),
    //   d - d_0 = (a - a_0) (n_x + n_0) - (1 - a) (n_y - n_0).
    constexpr double round_off = 1e-12;
    const double low = block.least / (cut.weight + block.least),
                 high = block.most / (cut.weight + block.most);
    const double share = .5 * (low + high);
    const Vector2 to_centre = block.centre - cut.point;
    const double offset = cross(to_centre, share * cut.normal - (1. - share) * block.normal);
    const double turn = .5 * (high - low) * (cut.normal + block.normal).norm() + (1. - low) * block.spread;
    const double bound = block.radius + to_centre.norm() * (turn + round_off);
    return offset > bound ? 1 : offset < -bound ? -1 : 0;
  }
} // namespace abut
