// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What the gap does within the cells that press.

#include <abut/run/checks/validity.h>
#include <abut/run/contact_mismatch.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace abut
{
  namespace
  {
    /// Energy norm, relative: more than what an estimate may be wrong by.
    constexpr double noticeable_mismatch = .3;

    std::vector<bool> near_parts(const PairResult &pair)
    {
      std::vector<bool> presses;
      for (std::size_t k = 0; k < static_cast<std::size_t>(pair.loads.size()); ++k)
        presses.push_back(pair.presses(k));
      return pair.surface->near_contact(presses);
    }

    double norm_of(const std::vector<BodyResult> &bodies)
    {
      double square = 0.;
      for (const BodyResult &body : bodies)
        square += 2. * body.energy;
      return std::sqrt(square);
    }

    /// Where the sides are farthest apart within the parts that press.
    NearestPoint farthest_within(const PairResult &pair, const std::vector<BodyResult> &bodies)
    {
      const auto displacement = [&](const ContactBody &side) -> Eigen::VectorXd {
        const BodyResult &result = bodies[side.body];
        return result.body->of_side(result.body->trace_of(result.displacement), side.side);
      };
      const GapSamples &samples = pair.pair->samples();
      const Eigen::VectorXd gaps =
          samples.gaps(displacement(pair.pair->cut_side()), displacement(pair.pair->other_side()));
      NearestPoint farthest{Vector2::Zero(), 0.};
      for (Eigen::Index i = 0; i < gaps.size(); ++i)
        if (gaps[i] > farthest.gap &&
            pair.presses(samples.pieces[static_cast<std::size_t>(i / GapSamples::per_piece)].part))
          farthest = {samples.places[static_cast<std::size_t>(i)], gaps[i]};
      return farthest;
    }

    Warnings coarse_gap_warnings(const PairResult &pair, const std::vector<BodyResult> &bodies)
    {
      const double mismatch = std::sqrt(mismatch_of(*pair.pair, near_parts(pair), bodies).law),
                   norm = std::hypot(norm_of(bodies), mismatch);
      if (!(mismatch > noticeable_mismatch * norm))
        return {};
      const NearestPoint farthest = farthest_within(pair, bodies);
      std::ostringstream text;
      text.precision(2);
      text
          << "Contact " << pair.pair->name()
          << ": the gap goes up and down within the cells that press, the sides stay up to " << farthest.gap
          << " apart there, at (" << farthest.place.x() << ", " << farthest.place.y()
          << "), which changes some " << 100. * mismatch / norm
          << " % of the deformation (energy norm) and with it pressures and forces: use smaller cells there, "
             "let the bodies adapt (Body <name>/Adapt), or set Tolerance";
      return {{WarningCode::coarse_gap, text.str()}};
    }

    /// Of the mean pressure: what a step adds to it that has the length of a part to rise in.
    constexpr double noticeable_peak = .05;

    double stiffness_of_surfaces(const ContactPair &pair)
    {
      return 1. / (1. / pair.slave().plane_modulus + 1. / pair.master().plane_modulus);
    }

    /// A step of the gap presses in like the edge of a punch.
    Warnings step_warnings(const PairResult &pair)
    {
      if (pair.pair->gap_steps().empty() || !(pair.contact_length > 0.))
        return {};
      const std::vector<bool> near = near_parts(pair);
      const double mean = pair.normal_force / pair.contact_length;
      for (const GapStep &step : pair.pair->gap_steps())
      {
        const double peak =
            stiffness_of_surfaces(*pair.pair) * step.height / (M_PI * pair.part(step.part).length);
        if (!near[step.part] || !(peak > noticeable_peak * mean))
          continue;
        std::ostringstream text;
        text.precision(3);
        text << "Contact " << pair.pair->name() << ": Gap has a step of " << step.height << " at ("
             << step.place.x() << ", " << step.place.y()
             << "), next to what presses; there the exact pressure is infinite: it grows with every "
                "refinement, and the force is known to a cell; use smaller cells there, or let the gap rise";
        return {{WarningCode::singular_pressure, text.str()}};
      }
      return {};
    }
  } // namespace

  Warnings gap_warnings(const Scene &scene, const Solution &solution)
  {
    Warnings warnings;
    for (const PairResult &pair : solution.pairs)
    {
      if (!scene.has_tolerance()) // which asks for smaller cells there by itself
        append(warnings, coarse_gap_warnings(pair, solution.bodies));
      append(warnings, step_warnings(pair));
    }
    return warnings;
  }
} // namespace abut
