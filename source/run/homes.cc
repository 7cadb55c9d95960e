// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/free_memory.h>
#include <abut/base/user_error.h>
#include <abut/run/homes.h>

#include <deal.II/base/exceptions.h>

#include <cmath>
#include <limits>

namespace abut
{
  namespace
  {
    /// Of a Cholesky factor in the plane: 7 n log2 n numbers (1.3 GB of 1.2 million unknowns).
    double predicted_factor_bytes(const double n_unknowns)
    {
      return 7. * sizeof(double) * n_unknowns * std::log2(n_unknowns + 2.);
    }
    double cost_of(const double n_unknowns)
    {
      constexpr double growth = 1.25;
      return std::pow(n_unknowns, growth);
    }
  } // namespace

  unsigned int n_homes(const BodyDescription &body, const std::size_t n_unknowns,
                       const unsigned int n_processes, const double free_bytes)
  {
    if (n_processes == 1 || body.is_rigid)
      return 1;
    if (body.n_processes > n_processes)
      throw UserError(body.section() + "/Processes: received " + std::to_string(body.n_processes) +
                      ", but this run has only " + std::to_string(n_processes) + "; start it by mpirun -np " +
                      std::to_string(body.n_processes) + ", or allow 0 (automatic)");
    if (body.shares_mesh && body.n_processes > 0 && body.n_processes < n_processes)
      throw UserError(body.section() + "/Processes: received " + std::to_string(body.n_processes) + " of " +
                      std::to_string(n_processes) +
                      " for a body with Distributed mesh = true, which takes all; allowed is 0");
    if (body.shares_mesh)
      return n_processes;
    if (body.n_processes > 0)
      return body.n_processes;
    return predicted_factor_bytes(static_cast<double>(n_unknowns)) > free_bytes ? n_processes : 1;
  }

  std::vector<BodyLoad> described_loads(const std::vector<BodyDescription> &bodies)
  {
    std::vector<BodyLoad> loads;
    for (const BodyDescription &body : bodies)
      loads.push_back({cost_of(2. * body.cells[0] * body.cells[1] * body.degree * body.degree)});
    return loads;
  }

  std::vector<BodyLoad> body_loads(const std::vector<std::unique_ptr<Body>> &bodies,
                                   const std::vector<bool> &stay, const Executor &executor)
  {
    AssertDimension(bodies.size(), stay.size());
    const double free_bytes =
        executor.processes() ? free_memory(*executor.processes()) : std::numeric_limits<double>::infinity();
    std::vector<BodyLoad> loads;
    for (std::size_t a = 0; a < bodies.size(); ++a)
    {
      const std::size_t n_unknowns = bodies[a]->counts().dofs;
      const unsigned int n =
          stay[a] ? executor.n_processes_of(a)
                  : n_homes(bodies[a]->description(), n_unknowns, executor.n_processes(), free_bytes);
      loads.push_back({cost_of(static_cast<double>(n_unknowns)), stay[a], n});
    }
    return loads;
  }
} // namespace abut
