// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/run/limit_distance.h>

#include <algorithm>
#include <cmath>

namespace abut
{
  namespace
  {
    /// Of the reported state; `energy_norm`: of its displacement.
    LimitDistance distance_from(const SchemeResult &limit, const SchemeResult &reached,
                                const InterfaceProblem &problem, const double energy_norm)
    {
      LimitDistance distance;
      for (std::size_t a = 0; a < problem.bodies().size(); ++a)
      {
        const Eigen::VectorXd there = problem.normal_displacements(limit.response, a);
        const double difference = (problem.normal_displacements(reached.iterate, a) - there).norm();
        if (difference > 0.)
          distance.displacement = std::max(distance.displacement, difference / there.norm());
      }
      const Eigen::Index n = problem.n_pressures();
      const double square =
          (reached.traction - limit.traction).dot((reached.response - limit.response).head(n));
      distance.energy = std::sqrt(std::max(square, 0.)) / energy_norm;
      distance.peak_pressure = n > 0 ? limit.traction.maxCoeff() : 0.;
      return distance;
    }
  } // namespace

  std::optional<LimitDistance> limit_distance(const InterfaceProblem &problem, const InterfaceSolver &solver,
                                              const Solution &solution)
  {
    const SchemeResult &reached = solution.iteration;
    if (reached.stopped_by != StoppedBy::increment || !reached.converged() || !solution.compliance_is_dense)
      return {};
    const SchemeResult limit = solver.limit(problem.loads(solution.rigid_displacement), reached.traction);
    if (!limit.converged())
      return {};
    double energy = 0.;
    for (const BodyResult &body : solution.bodies)
      energy += 2. * body.energy;
    return distance_from(limit, reached, problem, std::sqrt(energy));
  }
} // namespace abut
