// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/run/bound_conditions.h>
#include <abut/run/part_cells.h>

namespace abut
{
  namespace
  {
    std::string of_estimator(const AdaptationParameters &parameters, const Estimation &estimation)
    {
      if (!estimation.why_uncertified.empty())
        return estimation.why_uncertified;
      const std::string reason = parameters.why_not_by_law();
      if (reason.empty() && parameters.boundary_solution == BoundarySolution::constant_traction)
        return coarse_boundary_elements;
      return reason;
    }

    std::string of_bodies(const std::vector<BodyResult> &bodies)
    {
      for (const BodyResult &result : bodies)
        if (const std::string reason = result.body->why_no_bound(); !reason.empty())
          return reason;
      return "";
    }

    /// Whether contact reaches an end of one of the sides, where pressures may be infinite and
    /// penetrations are weighted with those found: an end of a stretch that is no plane of symmetry.
    bool presses_with_an_edge(const PairResult &pair)
    {
      for (const Stretch &stretch : pair.surface->partition().stretches())
        if (!stretch.closed)
          for (const auto &[part, end] : {std::pair(stretch.first, 0u), std::pair(stretch.last - 1, 1u)})
            if (pair.presses(part) && !is_at_symmetry(*pair.surface, part, end))
              return true;
      return false;
    }

    std::string of_pairs(const std::vector<PairResult> &pairs)
    {
      for (const PairResult &pair : pairs)
      {
        const std::string contact = "contact " + pair.pair->name();
        if (!pair.missed.empty())
          return contact + " has overlaps that no part of it sees";
        if (presses_with_an_edge(pair))
          return contact + " reaches an edge, where the pressure may be infinite";
      }
      return "";
    }
  } // namespace

  std::string why_no_bound(const Scene &scene, const Solution &solution, const Estimation &estimation)
  {
    for (const std::string &reason :
         {of_estimator(scene.adaptation, estimation), of_bodies(solution.bodies), of_pairs(solution.pairs)})
      if (!reason.empty())
        return reason;
    return "";
  }
} // namespace abut
