// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What the mesh does where nobody asks for an estimate.

#include <abut/adaptation/kelly.h>
#include <abut/results/estimation.h>
#include <abut/run/checks/validity.h>

#include <algorithm>
#include <sstream>

namespace abut
{
  namespace
  {
    /// Energy norm, relative. A cantilever of degree 1 has 36 % with two square cells across, is 15 % too
    /// stiff then, and has 19 % with four; the project's scenes are below 15 %.
    constexpr double largest_error = .25;

    /// The indicator takes some 4 microseconds a cell, a tenth of a run: it is not noticed up to here.
    constexpr std::size_t most_cells_looked_at = 5000;

    /// Below it a body is at rest, its error is round-off.
    constexpr double smallest_strain = 1e-12;

    double estimated_error(const Executor &executor, const Solution &solution)
    {
      Estimation estimation;
      estimation.errors = executor.of_bodies(solution.bodies.size(), [&](const std::size_t a) {
        const BodyResult &body = solution.bodies[a];
        return body.body->description().is_rigid
                   ? CellErrors()
                   : KellyIndicator().estimate({*body.body, body.deformation, body.contact_forces});
      });
      return estimation.discretisation();
    }

    bool some_are_linear(const std::vector<BodyResult> &bodies)
    {
      return std::any_of(bodies.begin(), bodies.end(), [](const BodyResult &result) {
        const BodyDescription &body = result.body->description();
        return !body.is_rigid && body.degree == 1;
      });
    }
  } // namespace

  Warnings coarse_mesh_warnings(const Executor &executor, const Results &results)
  {
    std::size_t n_cells = 0;
    double strain = 0.;
    for (const BodyResult &body : results.bodies)
    {
      n_cells += body.body->counts().cells;
      strain = std::max(strain, body.peaks.regular_strain.value);
    }
    if (results.passes.back().discretisation || n_cells > most_cells_looked_at || !(strain > smallest_strain))
      return {};
    const double error = estimated_error(executor, results);
    if (!(error > largest_error))
      return {};
    std::ostringstream text;
    text.precision(2);
    text << "The mesh is too coarse: an estimated " << 100. * error
         << " % of the deformation (energy norm) is its error, energies and the displacements under given "
            "loads "
            "are some "
         << 100. * error * error << " % off, stresses more; use "
         << (some_are_linear(results.bodies) ? "Discretisation/Degree = 2, finer cells," : "finer cells")
         << " or set Tolerance";
    return {{WarningCode::coarse_mesh, text.str()}};
  }
} // namespace abut
