// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What the choice of methods means for a scene, and all warnings of a run.

#include <abut/run/checks/validity.h>
#include <abut/scene/scheme_entry.h>

#include <sstream>

namespace abut
{
  namespace
  {
    using Bodies = std::vector<std::unique_ptr<Body>>;

    /// Which body's error the estimator fe-be sees a part of only; empty where it sees it whole.
    std::string underestimated_body(const AdaptationParameters &adaptation, const Bodies &bodies,
                                    const Executor &executor)
    {
      if (!Registry<EstimatorEntry>::get().find(adaptation.estimator).has_boundary_elements ||
          adaptation.boundary_solution == BoundarySolution::trace_space ||
          adaptation.boundary_solution == BoundarySolution::reference_quality)
        return {};
      const std::vector<std::size_t> n_vertices = executor.of_bodies(
          bodies.size(), [&](const std::size_t a) { return bodies[a]->singular_vertices().size(); });
      for (std::size_t a = 0; a < bodies.size(); ++a)
        if (n_vertices[a] > 0)
          return bodies[a]->name();
      return {};
    }

    /// That an estimator is far from the true error with some body's degree; empty where it is not.
    std::string rough_estimator(const EstimatorEntry &estimator, const Bodies &bodies)
    {
      for (const auto &body : bodies)
      {
        const unsigned int degree = body->description().degree;
        const EstimatorWorth *const worth = estimator.worth_at(degree);
        if (body->description().is_rigid || worth == nullptr || !worth->is_rough())
          continue;
        std::ostringstream text;
        text << "Adaptation/Estimator = " << estimator.name << " has been " << worth->least << " to "
             << worth->most << " times the true error with elements of degree " << degree << " (body "
             << body->name()
             << "): its marks are good, its values and a Limit are not; fe-be has a bound, kelly is nearer";
        return text.str();
      }
      return "";
    }
  } // namespace

  namespace
  {
    /// That only boundary elements see what a body's displacement jumps by where it is equal in the mean.
    std::string estimator_blind_to_jumps(const EstimatorEntry &estimator, const Bodies &bodies)
    {
      if (estimator.has_boundary_elements || estimator.make_certifier != nullptr || !estimator.estimates())
        return "";
      for (const auto &body : bodies)
      {
        const JointDescription &joints = body->description().joints;
        if (joints.mortar_edges && body->counters().mortars > 0 &&
            (joints.mortar.slave == MortarSlave::coarser || joints.mortar.vertices == MortarVertices::free))
          return "Adaptation/Estimator = " + estimator.name + " does not see that the displacement of body " +
                 body->name() +
                 " jumps at edges between cells and finer ones, where the coarser ones follow or the "
                 "vertices "
                 "are free (Mortar): the error may be several times what it says; fe-be sees it";
      }
      return "";
    }
  } // namespace

  namespace
  {
    /// What is known to be far from the truth in the budget of the last pass; empty where nothing is.
    std::string rough_part(const std::vector<PassRecord> &passes)
    {
      if (passes.empty() || !passes.back().budget.discretisation)
        return "";
      constexpr double round_off = 1e-7; // the root of it
      const ErrorBudget &budget = passes.back().budget;
      if (std::string(budget.dominant().name) != "contact" || !(budget.dominant().error > round_off))
        return "";
      std::ostringstream text;
      text << "most of the estimated error is what the sides of the contact miss of its law ("
           << 100. * budget.dominant().error
           << " %), which is taken on the safe side: the estimate has been up to 3.7 times the true error";
      return text.str();
    }
  } // namespace

  Warnings scheme_warnings(const Scene &scene)
  {
    const DecompositionParameters &decomposition = scene.decomposition;
    if (scheme_of(decomposition).iterates_displacements || scene.contacts.empty() ||
        (!decomposition.relaxation && decomposition.initial_guess == DecompositionParameters().initial_guess))
      return {};
    return {{WarningCode::unused_parameter,
             "Decomposition/Relaxation and Initial guess are for Scheme = neumann; the scheme " +
                 decomposition.scheme + " takes no notice of them"}};
  }

  Warnings estimator_warnings(const Scene &scene, const Model &model)
  {
    Warnings warnings;
    if (const std::string sentence =
            rough_estimator(Registry<EstimatorEntry>::get().find(scene.adaptation.estimator), model.bodies());
        !sentence.empty())
      warnings.push_back({WarningCode::rough_estimator, sentence});
    if (const std::string sentence = estimator_blind_to_jumps(
            Registry<EstimatorEntry>::get().find(scene.adaptation.estimator), model.bodies());
        !sentence.empty())
      warnings.push_back({WarningCode::rough_estimator, sentence});
    const std::string body = underestimated_body(scene.adaptation, model.bodies(), model.executor());
    if (!body.empty())
      warnings.push_back(
          {WarningCode::estimator_sees_a_part,
           "Body " + body +
               " has a vertex where the stress is infinite (a reentrant corner, a support that begins or "
               "ends, a load that jumps): there the boundary elements of Adaptation/Boundary solution = "
               "constant traction and finite element trace are about as coarse as the finite elements, the "
               "error may be up to a half larger than estimated; trace space and reference quality see it "
               "whole"});
    return warnings;
  }

  Warnings process_warnings(const Model &model)
  {
    std::vector<std::size_t> elastic;
    for (std::size_t a = 0; a < model.bodies().size(); ++a)
      if (!model.bodies()[a]->description().is_rigid)
        elastic.push_back(a);
    const unsigned int n_processes = model.executor().n_processes(),
                       n_busy = model.executor().n_busy(elastic);
    if (n_busy >= n_processes)
      return {};
    std::ostringstream text;
    text << n_processes << " processes share a run of " << elastic.size()
         << (elastic.size() == 1 ? " elastic body" : " elastic bodies") << ", which "
         << (elastic.size() == 1 ? "lives in " : "live in ") << n_busy << " of them: " << n_processes - n_busy
         << " had nothing to do; start ";
    if (n_busy > 1)
      text << "no more than " << n_busy;
    else
      text << "it without mpirun";
    text << ", or let a large body live in several (Body <name>/Processes)";
    return {{WarningCode::idle_processes, text.str()}};
  }

  Warnings all_warnings(const Scene &scene, const Model &model, const Results &results,
                        const std::vector<std::string> &dropped_loads)
  {
    Warnings warnings = input_warnings(scene, model);
    append(warnings, result_warnings(model.executor(), results));
    append(warnings, output_point_warnings(model, results.points));
    append(warnings, goal_warnings(scene, model));
    append(warnings, displaced_overlap_warnings(scene, model, results));
    append(warnings, coarse_mesh_warnings(model.executor(), results));
    append(warnings, gap_warnings(scene, results));
    append(warnings, penalty_warnings(scene, results));
    if (const std::string sentence = rough_part(results.passes); !sentence.empty())
      warnings.push_back({WarningCode::rough_estimator, sentence});
    for (const std::string &sentence : dropped_loads)
      warnings.push_back({WarningCode::dropped_load, sentence});
    append(warnings, scheme_warnings(scene));
    append(warnings, estimator_warnings(scene, model));
    append(warnings, process_warnings(model));
    return warnings;
  }
} // namespace abut
