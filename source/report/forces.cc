// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/report/forces.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    constexpr double balance_round_off = 1e-9; // relative

    /// Components that are round-off beside the largest one are 0.
    void drop_round_off(std::vector<ForceOnBody> &forces)
    {
      constexpr double round_off = 1e-12;
      double largest = 0.;
      for (const ForceOnBody &force : forces)
        largest = std::max(largest, force.force.cwiseAbs().maxCoeff());
      for (ForceOnBody &force : forces)
        force.force = (force.force.array().abs() > round_off * largest).select(force.force, 0.);
    }
  } // namespace

  std::vector<ForceOnBody> forces_on_bodies(const Results &results)
  {
    std::vector<ForceOnBody> forces;
    for (const PairResult &pair : results.pairs)
      forces.push_back(
          {results.bodies[pair.pair->slave().body].body->name(), "contact " + pair.pair->name(), pair.force});
    for (const BodyResult &body : results.bodies)
      for (const auto &[boundary, force] : body.reactions.by_boundary)
        forces.push_back({body.body->name(), "support " + boundary, force});
    drop_round_off(forces);
    return forces;
  }

  std::vector<Imbalance> imbalances(const Results &results)
  {
    std::vector<Imbalance> found;
    for (const BodyResult &body : results.bodies)
    {
      const Reactions &reactions = body.reactions;
      if (reactions.equilibrium_residual > balance_round_off || reactions.moment_residual > balance_round_off)
        found.push_back({body.body->name(), reactions.equilibrium_residual, reactions.moment_residual});
    }
    return found;
  }
} // namespace abut
