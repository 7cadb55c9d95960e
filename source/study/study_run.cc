// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/base/stopwatch.h>
#include <abut/comparison/true_errors.h>
#include <abut/run/point_values.h>
#include <abut/run/simulation.h>
#include <abut/study/study_run.h>

#include <cmath>

namespace abut
{
  namespace
  {
    /// Empty without a reference value.
    std::optional<double> relative_error(const double value, const double reference)
    {
      if (!(std::abs(reference) > 0.))
        return {};
      return std::abs(value / reference - 1.);
    }

    /// Errors against the fine run, as far as it is good enough.
    void compare_with(const FineRun &fine, const Scene &scene, const Solution &solution, StudyPass &pass)
    {
      const TrueErrors errors =
          true_errors(fine.solution, scene, solution.bodies, solution.pairs, Executor());
      pass.is_compared = errors.energy && fine.error <= allowed_fine_error * *errors.energy;
      if (!pass.is_compared)
        return;
      pass.record.true_errors = errors;
      pass.peak_pressure_error =
          relative_error(pass.quantities.max_pressure(), fine.quantities.max_pressure());
      pass.strain_energy_error = relative_error(pass.quantities.strain_energy, fine.quantities.strain_energy);
    }

    std::string refusal_of(const StudyRun &run)
    {
      std::string refused;
      for (const StudyPass &pass : run.passes)
        if (!pass.is_compared)
          refused += (refused.empty() ? "" : ", ") + std::to_string(pass.record.pass);
      if (refused.empty())
        return {};
      return "the fine run is no reference for pass " + refused + " of the variant `" + run.name() +
             "`: its own estimated error, " + short_number(*run.reference_error, 2) +
             ", is not at least 10 times smaller than the error found; allow it more passes or unknowns in "
             "Study/Reference run";
    }
  } // namespace

  StudyRun run_variant(const StudyParameters::Variant &variant, const Scene &scene, const FineRun *fine)
  {
    const bool has_exact = scene.reference.is_named();
    if (has_exact)
      fine = nullptr;
    StudyRun run;
    run.variant = variant;
    run.reference = has_exact ? scene.reference.solution : fine != nullptr ? fine_run_name : "";
    if (fine != nullptr)
      run.reference_error = fine->error;
    Simulation simulation(scene);
    double looking = 0.; // seconds in the observer, which the run counts as its own
    RunObserver observer;
    observer.state = [&](const PassState &state) {
      StudyPass pass;
      pass.record = state.results.passes.back();
      pass.record.seconds -= looking;
      const Stopwatch watch(looking);
      pass.quantities = quantities_of(state.results);
      pass.quantities.points =
          quantities_at(point_values(simulation.scene(), state.results.bodies, Executor()));
      if (fine != nullptr)
        compare_with(*fine, simulation.scene(), state.results, pass);
      run.passes.push_back(std::move(pass));
    };
    const Results results = simulation.run(observer);
    run.converged = results.converged();
    run.warnings = results.warnings;
    if (fine != nullptr)
      run.refusal = refusal_of(run);
    return run;
  }
} // namespace abut
