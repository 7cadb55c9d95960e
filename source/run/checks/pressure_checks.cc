// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What the pressures of a surface say of the mesh.

#include <abut/run/checks/validity.h>
#include <abut/run/part_cells.h>
#include <abut/trace/contact_runs.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace abut
{
  namespace
  {
    /// The pair of the surface that a part belongs to, the first of them.
    const std::string &pair_name(const ContactSurface &surface, const std::size_t part)
    {
      const auto &pairs = surface.pairs();
      return std::find_if(pairs.begin(), pairs.end(),
                          [&](const ContactPair &pair) {
                            return pair.weights()[static_cast<Eigen::Index>(part)] > 0.;
                          })
          ->name();
    }

    std::vector<ContactRun> runs_within(const PairResult &pair, const Stretch &stretch)
    {
      return contact_runs(stretch, [&](const std::size_t k) { return pair.presses(k); });
    }

    /// Fewer have no shape: the peak is that of a part. Two cells of a polygon for a curve are a little
    /// shorter.
    constexpr double fewest_cells = 2. * (1. - 1e-3);

    Warnings width_warnings(const PairResult &pair)
    {
      const std::vector<PartCell> cells = part_cells(*pair.surface);
      for (const Stretch &stretch : pair.surface->partition().stretches())
        for (const ContactRun &run : runs_within(pair, stretch))
        {
          if (fills(run, stretch))
            continue;
          double length = 0., cell = 0.;
          for (const std::size_t k : run)
          {
            length += pair.part(k).length;
            cell = std::max({cell, cells[k].shorter, cells[k].carrier});
          }
          if (is_at_symmetry(*pair.surface, run.front(), 0) || is_at_symmetry(*pair.surface, run.back(), 1))
            length *= 2.; // it goes on beyond the plane
          if (length >= fewest_cells * cell)
            continue;
          const Vector2 &place = pair.part(run.front()).place;
          std::ostringstream text;
          text.precision(3);
          text << "Contact " << pair_name(*pair.surface, run.front()) << ": the contact at (" << place.x()
               << ", " << place.y() << ") is " << length << " wide, less than two cells of " << cell
               << ": its width and peak pressure are those of the mesh, and where motions are prescribed so "
                  "is "
                  "its force; use finer cells there or let the bodies adapt (Body <name>/Adapt)";
          return {{WarningCode::narrow_contact, text.str()}};
        }
      return {};
    }

    /// Amplitude of pressures that go up and down, of their mean. Sound pairs stay below 2.2 %
    /// (doc/results.md).
    constexpr double largest_wave = .05;

    /// The largest half-waves that are those of the mesh, in cells of the coarser side: a pressure can follow
    /// the edges of these, or alternate from one to the next.
    constexpr double longest_half_wave = 1.5;

    /// As many of them, one after the other: a dome has two, a step and a kink one.
    constexpr std::size_t fewest_half_waves = 3;

    /// The parts from the first that presses to the last, without those at the ends, where contact ends
    /// somewhere within them.
    std::vector<std::size_t> inner_parts(const PairResult &pair, const Stretch &stretch)
    {
      const std::vector<ContactRun> runs = runs_within(pair, stretch);
      if (runs.empty())
        return {};
      const std::size_t n = stretch.last - stretch.first;
      std::vector<std::size_t> parts;
      for (std::size_t k = runs.front().front(); k != runs.back().back();
           k = stretch.first + (k - stretch.first + 1) % n)
        parts.push_back(k);
      return parts.empty() ? parts : std::vector<std::size_t>(parts.begin() + 1, parts.end());
    }

    /// The mean of the pressures of those parts that press.
    double mean_pressure(const PairResult &pair, const std::vector<std::size_t> &parts)
    {
      double sum = 0.;
      std::size_t n = 0;
      for (const std::size_t k : parts)
        if (pair.presses(k))
        {
          sum += pair.pressures[static_cast<Eigen::Index>(k)];
          ++n;
        }
      return n > 0 ? sum / static_cast<double>(n) : 0.;
    }

    /// Where pressures turn, from up to down or from down to up, by more than `least` each time; the first
    /// and the last part too.
    std::vector<std::size_t> turning_parts(const PairResult &pair, const std::vector<std::size_t> &parts,
                                           const double least)
    {
      const auto pressure = [&](const std::size_t k) { return pair.pressures[static_cast<Eigen::Index>(k)]; };
      std::vector<std::size_t> turns = {parts.front()};
      std::size_t farthest = parts.front(); // since the last turn
      double direction = 0.;
      for (const std::size_t k : parts)
      {
        if (direction == 0. && std::abs(pressure(k) - pressure(farthest)) > least)
          direction = pressure(k) > pressure(farthest) ? 1. : -1.;
        if (direction * (pressure(k) - pressure(farthest)) > 0.)
          farthest = k;
        else if (direction * (pressure(farthest) - pressure(k)) > least)
        {
          turns.push_back(farthest);
          farthest = k;
          direction = -direction;
        }
      }
      turns.push_back(farthest);
      return turns;
    }

    struct Wave
    {
      double amplitude = 0.; ///< of the mean pressure
      std::size_t part = 0;
    };

    /// The largest of at least `fewest_half_waves` on end that are no longer than the mesh makes them.
    Wave largest_wave_within(const PairResult &pair, const Stretch &stretch,
                             const std::vector<PartCell> &cells)
    {
      const std::vector<std::size_t> parts = inner_parts(pair, stretch);
      if (parts.empty())
        return {};
      const double mean = mean_pressure(pair, parts);
      const std::vector<std::size_t> turns = turning_parts(pair, parts, 2. * largest_wave * mean);
      Wave largest;
      std::size_t n_on_end = 0;
      double smallest = 0.; // of those on end
      for (std::size_t i = 0; i + 1 < turns.size(); ++i)
      {
        const Part &from = pair.part(turns[i]), &to = pair.part(turns[i + 1]);
        const double cell = std::max(cells[turns[i]].longer, cells[turns[i + 1]].longer);
        const double amplitude = .5 *
                                 std::abs(pair.pressures[static_cast<Eigen::Index>(turns[i + 1])] -
                                          pair.pressures[static_cast<Eigen::Index>(turns[i])]) /
                                 mean;
        if (!(std::abs(to.place_arc - from.place_arc) <= longest_half_wave * cell &&
              amplitude > largest_wave))
        {
          n_on_end = 0;
          continue;
        }
        smallest = n_on_end == 0 ? amplitude : std::min(smallest, amplitude);
        if (++n_on_end >= fewest_half_waves && smallest > largest.amplitude)
          largest = {smallest, turns[i]};
      }
      return largest;
    }

    Warnings roughness_warnings(const PairResult &pair)
    {
      const std::vector<PartCell> cells = part_cells(*pair.surface);
      Wave worst;
      for (const Stretch &stretch : pair.surface->partition().stretches())
      {
        const Wave here = largest_wave_within(pair, stretch, cells);
        if (here.amplitude > worst.amplitude)
          worst = here;
      }
      if (!(worst.amplitude > 0.))
        return {};
      const Vector2 &place = pair.part(worst.part).place;
      std::ostringstream text;
      text.precision(3);
      text << "Contact " << pair_name(*pair.surface, worst.part) << ": around (" << place.x() << ", "
           << place.y() << ") the pressure goes up and down with the cells, by " << 100. * worst.amplitude
           << " % of its mean: neither its peak nor its single values mean anything, its force does; let "
              "Multipliers be automatic, or make the cells of the stiffer side no finer than those of the "
              "other";
      return {{WarningCode::rough_pressure, text.str()}};
    }
  } // namespace

  Warnings pressure_warnings(const PairResult &pair)
  {
    Warnings warnings = width_warnings(pair);
    append(warnings, roughness_warnings(pair));
    return warnings;
  }
} // namespace abut
