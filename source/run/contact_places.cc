// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/run/contact_places.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    Vector2 nearest_on_chord(const Trace &side, const Segment &segment, const Vector2 &place)
    {
      const Vector2 start = side.point(segment, 0.), chord = side.point(segment, 1.) - start;
      return start + std::clamp((place - start).dot(chord) / chord.squaredNorm(), 0., 1.) * chord;
    }
  } // namespace

  std::vector<PlaceOnBody> places_on_bodies(const PairResult &pair, const double arc,
                                            const std::vector<BodyResult> &bodies)
  {
    const ContactBody &cut = pair.pair->cut_side(), &other = pair.pair->other_side();
    const auto is_elastic = [&](const ContactBody &side) {
      return !bodies[side.body].body->description().is_rigid;
    };
    for (const Piece &piece : pair.surface->partition().pieces())
    {
      const Segment &segment = cut.trace->segments()[piece.cut_segment];
      const double s = piece.start + (arc - piece.arc) / segment.length;
      if (piece.link != pair.pair->link() || s < piece.start || s > piece.end)
        continue;
      const Segment &opposite = other.trace->segments()[piece.other_segment];
      const Vector2 place = cut.trace->point(segment, s);
      std::vector<PlaceOnBody> places;
      if (is_elastic(cut))
        places.push_back({cut.body, place, segment.cell});
      if (is_elastic(other))
        places.push_back({other.body, nearest_on_chord(*other.trace, opposite, place), opposite.cell});
      return places;
    }
    return {};
  }
} // namespace abut
