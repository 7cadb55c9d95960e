// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/run/budget.h>

#include <cmath>

namespace abut
{
  namespace
  {
    /// Relative; nothing where the square is none.
    std::optional<double> relative_root(const double square, const double norm)
    {
      if (!std::isfinite(square) || !(norm > 0.))
        return {};
      return std::sqrt(std::max(square, 0.)) / norm;
    }

    double norm_of_solution(const std::vector<BodyResult> &bodies)
    {
      double energy = 0.;
      for (const BodyResult &body : bodies)
        energy += 2. * body.energy;
      return std::sqrt(energy);
    }
  } // namespace

  ErrorBudget error_budget(const Executor &executor, const Solution &solution, const Estimation &estimation,
                           const std::optional<PenaltyChange> &penalty)
  {
    ErrorBudget budget;
    budget.discretisation = estimation.discretisation();
    budget.contact = estimation.contact();
    budget.bounded_part = estimation.bound();
    if (std::isfinite(solution.iteration.iteration_error))
      budget.iteration = solution.iteration.iteration_error;
    double round_off = 0., geometry = 0.;
    for (const auto &[of_round_off, of_geometry] :
         executor.of_bodies(solution.bodies.size(), [&](const std::size_t a) {
           const BodyResult &body = solution.bodies[a];
           return std::make_pair(body.body->round_off_energy(body.deformation, body.contact_forces),
                                 body.body->geometry_energy(body.deformation));
         }))
    {
      round_off += of_round_off;
      geometry += of_geometry;
    }
    const double norm = norm_of_solution(solution.bodies);
    budget.linear_algebra = relative_root(round_off, norm);
    budget.geometry = relative_root(geometry, norm);
    if (penalty)
      budget.penalty = relative_root(penalty->energy, norm);
    return budget;
  }
} // namespace abut
