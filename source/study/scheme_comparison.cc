// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/base/stopwatch.h>
#include <abut/base/user_error.h>
#include <abut/decomposition/interface_solver.h>
#include <abut/decomposition/measures.h>
#include <abut/decomposition/schemes/neumann.h>
#include <abut/report/atomic_file.h>
#include <abut/run/model.h>
#include <abut/study/result_file.h>
#include <abut/study/scheme_comparison.h>
#include <abut/study/scheme_table.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <ostream>

namespace abut
{
  namespace
  {
    using Loads = InterfaceProblem::Loads;

    const std::string reference_scheme = "newton"; // its solution is what the others are measured by

    /// All that there are, that of the reference solution first.
    std::vector<std::string> compared_schemes()
    {
      std::vector<std::string> names = {reference_scheme};
      for (const SchemeEntry &scheme : Registry<SchemeEntry>::get().entries())
        if (scheme.name != reference_scheme)
          names.push_back(scheme.name);
      return names;
    }

    /// The solution that the others are measured by.
    struct ReferenceSolution
    {
      SchemeResult result;
      std::unique_ptr<InterfaceSolver> solver;
      double norm = 0.;

      double distance(const SchemeResult &other) const
      {
        const Eigen::VectorXd change = other.traction - result.traction;
        const double square = change.dot(solver->compliance().apply(change).head(change.size()));
        return std::sqrt(std::max(square, 0.)) / norm;
      }
    };

    ReferenceSolution solve_reference(const InterfaceProblem &problem, DecompositionParameters parameters,
                                      const Loads &loads)
    {
      constexpr double asked = 1e-13, needed = 1e-9; // round-off may leave more than is asked
      parameters.scheme = reference_scheme;
      parameters.tolerance = asked;
      parameters.maximum_steps = DecompositionParameters().maximum_steps;
      ReferenceSolution reference;
      reference.solver = std::make_unique<InterfaceSolver>(problem, parameters);
      reference.result = reference.solver->solve(loads, {}, {});
      const MotionTerms &motions = *reference.solver->motions();
      if (!(reference.result.iteration_error <= needed) ||
          !motions.is_balanced(reference.result.traction, reference.result.motions(motions.held)))
        throw ComputationError("The reference solution has not been found: " + reference.result.message);
      const Eigen::VectorXd response =
          loads.response + reference.solver->compliance().apply(reference.result.traction);
      reference.norm = reference_norm(problem, loads, reference.result.traction, response);
      return reference;
    }

    std::vector<unsigned int> count_solves(const Model &model)
    {
      std::vector<unsigned int> counts;
      for (const auto &body : model.bodies())
        counts.push_back(body->counters().solves);
      return counts;
    }

    /// Of the body that was solved most often since.
    unsigned int most_solves_since(const std::vector<unsigned int> &before, const Model &model)
    {
      unsigned int most = 0;
      const std::vector<unsigned int> now = count_solves(model);
      for (std::size_t a = 0; a < now.size(); ++a)
        most = std::max(most, now[a] - before[a]);
      return most;
    }

    /// What takes motions as unknowns; empty where nothing does.
    std::string moving_body(const Model &model)
    {
      for (const auto &body : model.bodies())
        if (!body->free_rigid_motions().empty())
          return "not run: contact alone holds the body " + body->name();
        else if (body->resultant())
          return "not run: the body " + body->name() +
                 " carries a given force, which takes several solutions";
      return {};
    }

    std::string pair_without_penalty(const Model &model)
    {
      for (const ContactPair *pair : model.pairs())
        if (!(pair->penalty() > 0.))
          return "not run: the contact " + pair->name() + " has no penalty";
      return {};
    }

    /// Why a scene is beyond a scheme; empty where it is not.
    std::string beyond(const SchemeEntry &scheme, const Model &model)
    {
      const std::string moving = scheme.takes_motions ? "" : moving_body(model);
      return moving.empty() && !scheme.solves_exact_contact ? pair_without_penalty(model) : moving;
    }

    /// Whether the scheme is worth running; else sets message and prediction.
    bool can_run(const Model &model, const DecompositionParameters &parameters, SchemeRun &run)
    {
      constexpr double most_steps = 25000.;
      const SchemeEntry &scheme = scheme_of(parameters);
      run.message = beyond(scheme, model);
      if (!run.message.empty())
        return false;
      if (!scheme.iterates_displacements)
        return true;
      run.predicted_steps = scheme.expected_solves(scheme.chosen(model.problem(), parameters), 0);
      if (*run.predicted_steps > most_steps)
        run.message = "not run: too many steps";
      return run.message.empty();
    }

    std::string dropped_loads(const ReferenceSolution &reference)
    {
      std::string lines;
      for (const std::string &sentence : reference.solver->motions()->dropped_loads)
        lines += sentence + '\n';
      return lines;
    }

    SchemeRun run_scheme(const Model &model, const DecompositionParameters &parameters, const Loads &loads,
                         const ReferenceSolution &reference)
    {
      SchemeRun run;
      run.scheme = parameters.scheme;
      if (!can_run(model, parameters, run))
        return run;
      const std::vector<unsigned int> solves = count_solves(model);
      SchemeResult result;
      double seconds = 0.;
      try
      {
        const Stopwatch watch(seconds);
        result = InterfaceSolver(model.problem(), parameters).solve(loads, {}, {});
      }
      catch (const ComputationError &error) // the others are told nevertheless
      {
        run.message = error.what();
        run.failed = true;
        return run;
      }
      run.seconds = seconds;
      run.solves = most_solves_since(solves, model);
      run.converged = result.converged();
      run.steps = result.steps;
      run.iteration_error = result.iteration_error;
      run.distance = reference.distance(result);
      run.message = result.message;
      return run;
    }
  } // namespace

  bool compare_schemes(const std::string &file, const std::vector<std::string> &overrides, const bool quiet,
                       std::ostream &out)
  {
    const Scene scene = Scene::read(file, overrides);
    if (scene.contacts.empty())
      throw UserError(file + ": Contacts: received an empty list, schemes are compared on contacts");
    const auto exact = make_exact_solution(scene); // conditions may refer to it
    Model model(scene, exact.get());
    model.prepare();
    const Loads loads = model.problem().loads(0.);
    DecompositionParameters parameters = scene.decomposition;
    parameters.stopping_rule = StoppingRule::bound;
    const ReferenceSolution reference = solve_reference(model.problem(), parameters, loads);
    std::vector<SchemeRun> runs;
    for (const std::string &scheme : compared_schemes())
    {
      parameters.scheme = scheme;
      runs.push_back(run_scheme(model, parameters, loads, reference));
    }
    const OutputDirectory directory(scene.output_directory);
    const std::string path = write_result(scene, "schemes.csv", scheme_csv(runs));
    if (!quiet)
      out << model.counts().dofs << " unknowns, " << model.problem().n_pressures()
          << " of the contact; tolerance " << short_number(parameters.tolerance)
          << "; distances from a solution to " << short_number(reference.result.iteration_error, 2) << "\n\n"
          << scheme_table(runs) << dropped_loads(reference) << "\n  The same in " << path << '\n';
    return std::all_of(runs.begin(), runs.end(),
                       [](const SchemeRun &run) { return !run.failed && (!run.steps || run.converged); });
  }
} // namespace abut
