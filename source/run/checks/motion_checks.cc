// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What rigid motions do to normals that stay those of the undeformed bodies.

#include <abut/run/checks/validity.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <sstream>

namespace abut
{
  namespace
  {
    /// Of the depth that the sides are pressed in by: what results are read to.
    constexpr double largest_gap_error = .02;

    /// Positive where convex.
    double curvature(const Segment &segment)
    {
      const auto &[from, to] = segment.end_normals;
      return std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to)) / segment.length;
    }

    /// What the normal turns with as the sides move along each other: between convex sides as the line from
    /// one centre to the other, 1 / (R + R'); else with the flatter side. On a flat side it does not turn,
    /// wherever the other one moves to.
    double turning(const double a, const double b)
    {
      const double flatter = std::min(std::abs(a), std::abs(b));
      return a > 0. && b > 0. ? a * b / (a + b) : flatter;
    }

    /// The largest of every part of the surface.
    std::vector<double> turnings(const PairResult &pair)
    {
      std::vector<double> largest(pair.surface->partition().parts().size(), 0.);
      const Trace &cut = *pair.pair->cut_side().trace, &other = *pair.pair->other_side().trace;
      for (const Piece &piece : pair.surface->partition().pieces())
        if (piece.link == pair.pair->link())
          largest[piece.part] =
              std::max(largest[piece.part], turning(curvature(cut.segments()[piece.cut_segment]),
                                                    curvature(other.segments()[piece.other_segment])));
      return largest;
    }

    /// The parts of the pair that press, and those next to one.
    std::vector<std::size_t> parts_near_contact(const PairResult &pair)
    {
      std::vector<bool> pressed(pair.surface->partition().parts().size());
      for (std::size_t k = 0; k < pressed.size(); ++k)
        pressed[k] = pair.presses(k);
      const std::vector<bool> is_near = pair.surface->near_contact(pressed);
      std::vector<std::size_t> near;
      std::copy_if(pair.parts.begin(), pair.parts.end(), std::back_inserter(near),
                   [&](const std::size_t k) { return is_near[k]; });
      return near;
    }

    /// The depth over which the sides would overlap on these parts if they did not deform; where everything
    /// presses, the whole of it.
    double pressed_depth(const PairResult &pair, const std::vector<std::size_t> &parts)
    {
      double least = std::numeric_limits<double>::infinity(), most = -least, largest = 0.;
      for (const std::size_t k : parts)
      {
        const double gap = pair.rigid_gaps[static_cast<Eigen::Index>(k)];
        least = std::min(least, gap);
        most = std::max(most, gap);
        largest = std::max(largest, std::abs(gap));
      }
      const bool everywhere = std::all_of(pair.parts.begin(), pair.parts.end(),
                                          [&](const std::size_t k) { return pair.presses(k); });
      return everywhere ? largest : most - least;
    }
  } // namespace

  /// A point that moves by u along a side of curvature kappa stands u^2 kappa / 2 off the side's tangent.
  Warnings motion_warnings(const PairResult &pair)
  {
    const std::vector<std::size_t> near = parts_near_contact(pair);
    if (near.empty())
      return {};
    const std::vector<double> kappa = turnings(pair);
    double error = 0., moved = 0., turn = 0.;
    for (const std::size_t k : near)
    {
      const double u = std::abs(pair.rigid_sliding[static_cast<Eigen::Index>(k)]);
      if (!(.5 * u * u * kappa[k] > error))
        continue;
      error = .5 * u * u * kappa[k];
      moved = u;
      turn = u * kappa[k];
    }
    const double depth = pressed_depth(pair, near);
    if (!(error > largest_gap_error * depth))
      return {};
    std::ostringstream text;
    text.precision(3);
    text << "Contact " << pair.pair->name() << ": at the contact the bodies move along each other by "
         << moved << ", which turns the sides by " << turn * 180. / M_PI
         << " degrees; normals are those of the undeformed bodies, so that the gap is " << error
         << " off where the sides are pressed in by " << depth << ": pressures may be up to some "
         << 100. * error / depth << " % off; place the body where it touches (Shift)";
    return {{WarningCode::far_motion, text.str()}};
  }
} // namespace abut
