// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/counts.h>
#include <abut/base/numbers.h>
#include <abut/base/table.h>
#include <abut/report/console.h>
#include <abut/report/forces.h>
#include <abut/report/summary.h>

#include <cmath>
#include <ostream>

namespace abut
{
  namespace
  {
    std::string percent(const double share)
    {
      return short_number(100. * share, 2) + " %";
    }

    void print_bodies(std::ostream &out, const Results &results)
    {
      TextTable table = {
          {"body", "cells", "unknowns", "strain energy", "max von Mises", "max strain", "max displacement"}};
      for (const BodyResult &result : results.bodies)
      {
        const Counts counts = result.body->counts();
        table.push_back({result.body->name(), std::to_string(counts.cells), std::to_string(counts.dofs),
                         short_number(result.energy, 6), short_number(result.peaks.von_mises.value),
                         percent(result.peaks.strain.value), short_number(result.peaks.displacement.value)});
      }
      out << aligned(table);
    }

    void print_contacts(std::ostream &out, const Results &results)
    {
      if (results.pairs.empty())
        return;
      TextTable table = {
          {"contact", "normal force", "peak pressure", "contact length", "penetration", "max sliding"}};
      for (const PairResult &result : results.pairs)
        table.push_back({result.pair->name(), short_number(result.normal_force, 6),
                         short_number(result.max_pressure, 5), short_number(result.contact_length),
                         short_number(result.max_penetration, 3), short_number(result.max_sliding, 3)});
      out << '\n' << aligned(table);
    }

    void print_forces(std::ostream &out, const Results &results)
    {
      const std::vector<ForceOnBody> forces = forces_on_bodies(results);
      TextTable table = {{"force on", "from", "x", "y"}};
      for (const ForceOnBody &force : forces)
        table.push_back(
            {force.body, force.origin, short_number(force.force.x(), 6), short_number(force.force.y(), 6)});
      if (!forces.empty())
        out << '\n' << aligned(table);
      for (const Imbalance &found : imbalances(results))
        out << "  Body " << found.body << " is out of balance: forces by " << short_number(found.forces, 2)
            << " of their sizes, moments by " << short_number(found.moments, 2) << ".\n";
    }

    void print_points(std::ostream &out, const std::vector<PointResult> &points)
    {
      if (points.empty())
        return;
      TextTable table = {{"at", "x", "y", "displacement x", "displacement y", "von Mises"}};
      for (const PointResult &point : points)
        table.push_back({point.body->name(), short_number(point.place.x()), short_number(point.place.y()),
                         short_number(point.displacement.x(), 6), short_number(point.displacement.y(), 6),
                         short_number(point.stress.von_mises(), 5)});
      out << '\n' << aligned(table);
    }

    /// Why the iteration ended.
    std::string stop_text(const SchemeResult &iteration)
    {
      switch (iteration.stopped_by)
      {
      case StoppedBy::bound:
        return "by the guaranteed bound";
      case StoppedBy::residual:
        return "by the residual of the contact law";
      case StoppedBy::increment:
        return "because the contact displacement changed by only " + short_number(iteration.increment, 3);
      case StoppedBy::maximum_steps:
        return "by the maximum number of steps";
      case StoppedBy::stalled:
        return "because it no longer approached a limit";
      }
      return "";
    }

    void print_iteration(std::ostream &out, const Results &results)
    {
      const SchemeResult &iteration = results.iteration;
      const unsigned int steps = results.steps();
      out << "\n  Stopped after " << steps << (steps == 1 ? " step " : " steps ") << stop_text(iteration);
      if (iteration.relaxation > 0.)
        out << ", gamma = " << short_number(iteration.relaxation, 3);
      out << ".\n";
      if (std::isfinite(iteration.iteration_error))
        out << "  Iteration error (energy norm) " << (iteration.error_is_bound ? "at most " : "about ")
            << short_number(iteration.iteration_error, 3) << " of the solution.\n";
      if (const auto &limit = results.limit_distance)
        out << "  What that is worth: contact displacement " << percent(limit->displacement)
            << " from the limit of the iteration, energy norm " << percent(limit->energy)
            << "; largest load there " << short_number(limit->peak_pressure, 5) << ".\n";
    }

    /// One line for each mesh.
    void print_passes(std::ostream &out, const Results &results)
    {
      if (results.passes.empty() || !results.passes.back().discretisation)
        return;
      const bool has_contact = !results.pairs.empty();
      const auto value = [](const std::optional<double> &number, const int digits) {
        return number ? short_number(*number, digits) : std::string("-");
      };
      const auto total = [&](const PassRecord &pass) {
        return pass.total ? (pass.error_is_bound() ? "<= " : "~ ") + value(pass.total, 3) : "-";
      };
      TextTable table = {{"pass", "cells", "unknowns", "steps", "eta max", "estimated", "iteration", "total",
                          "true energy", "true stress", "pressure", "effectivity", "of total", "seconds"}};
      for (const PassRecord &pass : results.passes)
        table.push_back({std::to_string(pass.pass), std::to_string(pass.counts.cells),
                         std::to_string(pass.counts.dofs), has_contact ? std::to_string(pass.steps) : "-",
                         value(pass.eta_max, 3), value(pass.discretisation, 3),
                         has_contact ? short_number(pass.iteration, 3) : "-", total(pass),
                         value(pass.true_errors.energy, 3), value(pass.true_errors.stress, 3),
                         value(pass.true_errors.pressure, 3), value(pass.effectivity(), 3),
                         value(pass.effectivity_total, 3), short_number(pass.seconds, 3)});
      out << "\n  Passes; errors are relative, in the energy norm but for true stress (L2 over xx, yy, zz, 2 "
             "xy)"
          << (has_contact ? "\n  and pressure (L2)" : "")
          << ";\n  effectivity: estimated by true error of the stress; of total: total by true energy\n"
          << aligned(without_empty_columns(table));
      const PassRecord &last = results.passes.back();
      if (last.error_is_bound())
        out << "  The total bounds the error of the energy norm, as far as boundary elements are exact.\n";
      else if (last.total)
        out << "  The total is an estimate and no bound: " << last.estimate_reason << ".\n";
      if (results.adaptation_end)
        out << "  The adaptation ended by: " << results.adaptation_end->stopped_by << '\n';
    }

    void print_true_errors(std::ostream &out, const TrueErrors &errors)
    {
      TextTable table;
      const auto row = [&](const std::string &name, const std::optional<double> &error) {
        if (error)
          table.push_back({name, percent(*error)});
      };
      row("energy norm", errors.energy);
      row("stress", errors.stress);
      row("pressure", errors.pressure);
      row("force", errors.force);
      if (!table.empty())
        out << "\n  Errors against the exact solution\n" << aligned(table);
    }

    void print_times(std::ostream &out, const Times &times, const double total)
    {
      const auto seconds = [](const double value) { return short_number(value, 3); };
      out << '\n'
          << aligned(
                 {{"time in s", "total", "mesh", "assemble", "factorise", "solve", "interface", "estimate",
                   "adapt", "reference", "output"},
                  {"", seconds(total), seconds(times.mesh), seconds(times.assemble), seconds(times.factorise),
                   seconds(times.solve), seconds(times.interface), seconds(times.estimate),
                   seconds(times.adapt), seconds(times.reference), seconds(times.output)}});
    }
  } // namespace

  void print_warnings(std::ostream &out, const std::vector<Warning> &warnings)
  {
    for (const Warning &warning : warnings)
      out << "  WARNING (" << to_string(warning.code) << "): " << warning.text << '\n';
  }

  void print_results(std::ostream &out, const Results &results, const std::string &directory,
                     const double total_seconds)
  {
    print_bodies(out, results);
    print_contacts(out, results);
    print_forces(out, results);
    print_points(out, results.points);
    out << "\n  Plane strain; forces and energies are per thickness.\n";
    if (!results.pairs.empty())
      print_iteration(out, results);
    if (!results.converged())
      out << (results.pairs.empty() ? "\n" : "") << "  NOT CONVERGED: " << results.message() << '\n';
    print_passes(out, results);
    print_true_errors(out, results.true_errors);
    print_times(out, results.times, total_seconds);
    if (!results.left_out.empty())
    {
      out << "\n  Left out, since this scene does not need it:";
      for (std::size_t i = 0; i < results.left_out.size(); ++i)
        out << (i == 0 ? " " : ", ") << results.left_out[i];
      out << '\n';
    }
    out << "\n  Results are in " << directory << '\n';
  }
} // namespace abut
