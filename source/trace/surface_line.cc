// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/trace/surface_line.h>

#include <algorithm>
#include <limits>

namespace abut
{
  SurfaceLine::SurfaceLine(const Surface &surface)
  {
    std::vector<std::vector<bool>> laid, follows;
    for (const SurfaceSide &side : surface.cut)
    {
      places_.emplace_back(side.trace->segments().size());
      laid.emplace_back(side.trace->segments().size(), false);
    }
    follows = laid;
    const auto for_each = [&](const auto &f) {
      for (std::size_t side = 0; side < surface.cut.size(); ++side)
        for (std::size_t i = 0; i < places_[side].size(); ++i)
          f(Id{side, i});
    };
    for_each([&](const Id &id) {
      if (const auto after = next(surface, id))
        follows[after->side][after->segment] = true;
    });
    for_each([&](const Id &id) {
      if (!follows[id.side][id.segment])
        lay_row(surface, id, laid);
    });
    for_each([&](const Id &id) { // what is left is closed
      if (!laid[id.side][id.segment])
        lay_row(surface, id, laid);
    });
  }

  std::optional<SurfaceLine::Id> SurfaceLine::across(const Surface &surface, const Id &id,
                                                     const bool forwards) const
  {
    const Segment &segment = at(surface, id);
    std::optional<Id> nearest;
    double smallest = std::numeric_limits<double>::max();
    for (std::size_t side = 0; side < surface.cut.size(); ++side)
      for (std::size_t i = 0; side != id.side && i < places_[side].size(); ++i)
      {
        const Trace &trace = *surface.cut[side].trace;
        if (forwards ? trace.preceding(i) : trace.following(i))
          continue;
        const Segment &other = trace.segments()[i], &first = forwards ? segment : other,
                      &second = forwards ? other : segment;
        const double distance = (second.points.front() - first.points.back()).norm();
        if (distance <= smallest_share_of_box * std::min(segment.length, other.length) &&
            distance < smallest && is_smooth(first.end_normals[1], second.end_normals[0]))
        {
          smallest = distance;
          nearest = Id{side, i};
        }
      }
    return nearest;
  }

  std::optional<SurfaceLine::Id> SurfaceLine::next(const Surface &surface, const Id &id) const
  {
    if (const auto following = surface.cut[id.side].trace->following(id.segment))
      return Id{id.side, *following};
    const auto after = across(surface, id, true);
    if (!after)
      return {};
    const auto back = across(surface, *after, false); // unless that one follows another more closely
    return back && back->side == id.side && back->segment == id.segment ? after : std::nullopt;
  }

  void SurfaceLine::lay_row(const Surface &surface, const Id &first, std::vector<std::vector<bool>> &laid)
  {
    const double start = rows_.empty() ? 0. : rows_.back().start + rows_.back().length;
    double place = start;
    std::optional<Id> id = first;
    std::optional<Id> before;
    while (id && !laid[id->side][id->segment])
    {
      if (before)
        place += (at(surface, *id).points.front() - at(surface, *before).points.back()).norm();
      laid[id->side][id->segment] = true;
      places_[id->side][id->segment] = {rows_.size(), place};
      place += at(surface, *id).length;
      before = id;
      id = next(surface, *id);
    }
    const bool closed = id && id->side == first.side && id->segment == first.segment;
    rows_.push_back({start, place - start, closed});
  }
} // namespace abut
