// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What the displacements of a pair's sides say of the pairing.

#include <abut/run/checks/validity.h>
#include <abut/run/part_cells.h>
#include <abut/trace/common_normal.h>
#include <abut/trace/contact_runs.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

namespace abut
{
  namespace
  {
    /// Points stay paired as they were before anything moved. Of the shorter side, and of the contact there:
    /// however small the cells are, a round body's gap, x^2 / 2R, is off by a twelfth of its depth then.
    constexpr double largest_sliding_share = .1, noticed_sliding_share = .02;

    /// Of the force that may act where nothing lies opposite any more: what results are read to.
    constexpr double largest_share_beyond = .01;

    struct Sliding
    {
      double distance = 0., limit = 0.;
      Vector2 place = Vector2::Zero();
    };

    /// The part that slides farthest beside its limit, of those beyond it.
    std::optional<Sliding> largest_sliding(const PairResult &pair, const double most)
    {
      const std::vector<PartCell> cells = part_cells(*pair.surface);
      std::optional<Sliding> largest;
      double worst = 1.;
      for (const Stretch &stretch : pair.surface->partition().stretches())
        for (const ContactRun &run :
             contact_runs(stretch, [&](const std::size_t k) { return pair.presses(k); }))
        {
          double length = 0.;
          for (const std::size_t k : run)
            length += pair.part(k).length;
          for (const std::size_t k : run)
          {
            const double distance = std::abs(pair.sliding[static_cast<Eigen::Index>(k)]),
                         limit = std::min(std::max(cells[k].longer, noticed_sliding_share * length), most);
            if (!(distance > worst * limit))
              continue;
            worst = distance / limit;
            largest = {distance, limit, pair.part(k).place};
          }
        }
      return largest;
    }

    Warnings sliding_warnings(const PairResult &pair)
    {
      const double most = largest_sliding_share * std::min(pair.pair->cut_side().trace->length(),
                                                           pair.pair->other_side().trace->length());
      const auto sliding = largest_sliding(pair, most);
      if (!sliding)
        return {};
      std::ostringstream text;
      text.precision(3);
      text << "Contact " << pair.pair->name() << ": at (" << sliding->place.x() << ", " << sliding->place.y()
           << ") the sides slide along each other by " << sliding->distance << ", more than "
           << (sliding->limit < most ? "a cell there, or a fiftieth of the contact ("
                                     : "a tenth of the side (")
           << sliding->limit
           << "): their points stay paired as they were before anything moved; place the bodies where they "
              "come to lie (Shift) and prescribe the rest";
      return {{WarningCode::sideways_displacement, text.str()}};
    }

    /// Whether a point of a side that moves along it by `distance` (in the side's direction) passes its end:
    /// a corner is one.
    bool passes_end(const Trace &side, std::size_t segment, const double s, const double distance)
    {
      const bool onwards = distance > 0.;
      double rest = std::abs(distance);
      if (rest >= side.length()) // a closed side has no end to arrive at
        return true;
      double room = side.segments()[segment].length * (onwards ? 1. - s : s);
      while (rest > room)
      {
        const auto next = onwards ? side.following(segment) : side.preceding(segment);
        if (!next || !side.is_smooth_after(onwards ? segment : *next))
          return true;
        rest -= room;
        segment = *next;
        room = side.segments()[segment].length;
      }
      return false;
    }

    /// Share of the pair's force on points of a side which, once displaced, have nothing opposite. Where one
    /// side is longer its points are left behind all the time: that side counts which loses less.
    double share_beyond(const PairResult &pair)
    {
      const Trace &cut = *pair.pair->cut_side().trace, &other = *pair.pair->other_side().trace;
      const CommonNormal normal(cut, other);
      double of_cut = 0., of_other = 0.;
      for (const Piece &piece : pair.surface->partition().pieces())
      {
        if (piece.link != pair.pair->link() || !pair.presses(piece.part))
          continue;
        const auto part = static_cast<Eigen::Index>(piece.part);
        const double middle = .5 * (piece.start + piece.end), distance = pair.sliding[part];
        const double t = normal.project(piece.cut_segment, middle, piece.other_segment).t;
        const double force =
            pair.loads[part] * arc_length(cut, cut.segments()[piece.cut_segment], piece.start, piece.end);
        if (passes_end(other, piece.other_segment, t, distance))
          of_cut += force;
        if (passes_end(cut, piece.cut_segment, middle, distance))
          of_other += force;
      }
      const double beyond = std::min(of_cut, of_other);
      return beyond > 0. ? beyond / pair.normal_force : 0.;
    }

    Warnings leaving_warnings(const PairResult &pair)
    {
      const double share = share_beyond(pair);
      if (!(share > largest_share_beyond))
        return {};
      std::ostringstream text;
      text.precision(3);
      text << "Contact " << pair.pair->name() << ": " << 100. * share
           << " % of its force acts where the sides, once displaced, no longer lie opposite each other (they "
              "slide by up to "
           << pair.max_sliding << "); place the bodies where they come to lie (Shift) and prescribe the rest";
      return {{WarningCode::side_leaves_master, text.str()}};
    }

    /// Contact that is smaller than a part.
    Warnings missed_warnings(const PairResult &pair)
    {
      if (pair.missed.empty())
        return {};
      const auto deepest = std::max_element(
          pair.missed.begin(), pair.missed.end(),
          [](const MissedContact &a, const MissedContact &b) { return a.overlap < b.overlap; });
      std::ostringstream text;
      text.precision(3);
      text << "Contact " << pair.pair->name() << ": the bodies overlap by up to " << deepest->overlap
           << " at (" << deepest->place.x() << ", " << deepest->place.y()
           << ") and elsewhere outside the parts in contact; contact smaller than a cell is not resolved, "
              "use finer cells there or let the bodies adapt (Body <name>/Adapt)";
      return {{WarningCode::missed_contact, text.str()}};
    }

    Warnings hidden_warnings(const PairResult &pair)
    {
      if (!pair.parts.empty())
        return {};
      return {{WarningCode::hidden_pair, "Contact " + pair.pair->name() +
                                             ": other bodies lie between its sides everywhere; it carries "
                                             "nothing"}};
    }
  } // namespace

  Warnings pair_warnings(const PairResult &pair)
  {
    Warnings warnings;
    for (const auto check : {missed_warnings, hidden_warnings, sliding_warnings, leaving_warnings})
      append(warnings, check(pair));
    return warnings;
  }

  Warnings touch_warnings(const std::vector<PairResult> &pairs)
  {
    constexpr double round_off = 1e-9; // of the depth: sides that touch without a force
    const PairResult *nearest = nullptr;
    for (const PairResult &pair : pairs)
    {
      if (pair.normal_force > 0. || !pair.missed.empty())
        return {};
      if (!nearest || pair.nearest.gap < nearest->nearest.gap)
        nearest = &pair;
    }
    if (!nearest || !std::isfinite(nearest->nearest.gap) ||
        nearest->nearest.gap <=
            round_off * std::min(nearest->pair->slave().depth, nearest->pair->master().depth))
      return {};
    std::ostringstream text;
    text.precision(3);
    text << "Nothing touches: the smallest gap that is left is " << nearest->nearest.gap << ", of contact "
         << nearest->pair->name() << " at (" << nearest->nearest.place.x() << ", "
         << nearest->nearest.place.y()
         << "); move the bodies nearer (Shift, a displacement condition) or check the gap (Gap)";
    return {{WarningCode::nothing_touches, text.str()}};
  }

  Warnings result_warnings(const Executor &executor, const Solution &solution)
  {
    Warnings warnings = touch_warnings(solution.pairs);
    for (const Warnings &of_body : executor.of_bodies(
             solution.bodies.size(), [&](const std::size_t a) { return body_warnings(solution.bodies[a]); }))
      append(warnings, of_body);
    std::vector<const ContactSurface *> seen;
    for (const PairResult &pair : solution.pairs)
    {
      append(warnings, pair_warnings(pair));
      append(warnings, motion_warnings(pair));
      append(warnings, edge_warnings(pair, solution.bodies));
      if (std::find(seen.begin(), seen.end(), pair.surface) != seen.end())
        continue;
      seen.push_back(pair.surface);
      append(warnings, pressure_warnings(pair));
    }
    return warnings;
  }
} // namespace abut
