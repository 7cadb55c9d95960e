// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/counts.h>
#include <abut/base/libraries.h>
#include <abut/mesh/quality.h>
#include <abut/report/json.h>
#include <abut/report/pass_summary.h>
#include <abut/report/points.h>
#include <abut/report/summary.h>

#include <deal.II/base/config.h>

#include <algorithm>
#include <cholmod.h>
#include <cmath>
#include <sys/resource.h>

namespace abut
{
  namespace
  {
    Json components(const Vector2 &value)
    {
      return Json::array({number(value.x()), number(value.y())});
    }

    Json body_summary(const BodyResult &result)
    {
      const Counts counts = result.body->counts();
      const MeshQuality quality = result.body->mesh_quality();
      const auto level = [&](const unsigned int value) {
        return counts.cells == 0 ? Json(nullptr) : Json(value);
      };
      Json reactions = Json::object();
      for (const auto &[boundary, force] : result.reactions.by_boundary)
        reactions[boundary] = components(force);
      return {{"name", result.body->name()},
              {"processes", result.n_processes},
              {"mesh_processes", result.n_meshes},
              {"cells", counts.cells},
              {"dofs", counts.dofs},
              {"boundary_dofs", counts.boundary_dofs},
              {"cells_at_glue", result.cells.n_at_glue},
              {"condition", number(result.condition)},
              {"energy", number(result.energy)},
              {"max_von_mises", number(result.peaks.von_mises.value)},
              {"max_strain", number(result.peaks.strain.value)},
              {"max_displacement", number(result.peaks.displacement.value)},
              {"rigid_displacement",
               result.body->resultant() ? number(result.rigid_displacement) : Json(nullptr)},
              {"min_level", level(result.cells.min_level)},
              {"max_level", level(result.cells.max_level)},
              {"h_max", number(quality.h_max)},
              {"h_boundary", number(quality.h_boundary)},
              {"h_ratio", number(quality.h_boundary / quality.h_max)},
              {"regularity", number(quality.regularity)},
              {"reactions", reactions},
              {"equilibrium_residual", number(result.reactions.equilibrium_residual)},
              {"moment_residual", number(result.reactions.moment_residual)}};
    }

    Json contact_summary(const PairResult &result)
    {
      return {{"name", result.pair->name()},
              {"force", components(result.force)},
              {"normal_force", number(result.normal_force)},
              {"max_pressure", number(result.max_pressure)},
              {"contact_length", number(result.contact_length)},
              {"max_penetration", number(result.max_penetration)},
              {"min_gap", number(result.min_gap)},
              {"max_sliding", number(result.max_sliding)},
              {"penalty", number(result.pair->penalty())},
              {"coverage", number(result.pair->coverage())},
              {"missed_contact", result.missed.size()}};
    }

    Json error_summary(const Results &results)
    {
      const PassRecord pass = results.passes.empty() ? PassRecord() : results.passes.back();
      return {{"norm", "energy"},
              {"discretisation", number(pass.discretisation)},
              {"contact", number(pass.budget.contact)},
              {"penalty", number(pass.budget.penalty)},
              {"iteration", number(results.iteration.iteration_error)},
              {"linear_algebra", number(pass.budget.linear_algebra)},
              {"geometry", number(pass.budget.geometry)},
              {"bound", number(pass.budget.bound())},
              {"estimate", number(pass.budget.estimate())},
              {"dominant", pass.budget.discretisation ? Json(pass.budget.dominant().name) : Json()},
              {"total", number(pass.total)},
              {"error_is_bound", pass.error_is_bound()},
              {"estimate_reason", pass.estimate_reason},
              {"stress", number(pass.stress)},
              {"pressure", number(pass.pressure)},
              {"eta_max", number(pass.eta_max)},
              {"effectivity", number(pass.effectivity())},
              {"effectivity_total", number(pass.effectivity_total)}};
    }

    Json goal_summary(const Results &results)
    {
      const Scene &scene = *results.scene;
      if (!scene.has_tolerance())
        return nullptr;
      const PassRecord pass = results.passes.empty() ? PassRecord() : results.passes.back();
      const bool energy = !pass.goal;
      return {
          {"name", scene.goal.text()},
          {"tolerance", scene.tolerance},
          {"value", energy ? Json() : number(pass.goal->value)},
          {"error", energy ? number(pass.total) : number(pass.goal->total())},
          {"discretisation", energy ? number(pass.budget.discretisation) : number(pass.goal->discretisation)},
          {"penalty", energy ? number(pass.budget.penalty) : number(pass.goal->penalty)}};
    }

    Json true_error_summary(const TrueErrors &errors)
    {
      return {{"energy", number(errors.energy)},
              {"stress", number(errors.stress)},
              {"pressure", number(errors.pressure)},
              {"force", number(errors.force)},
              {"norms",
               {{"energy", "energy norm, all bodies"},
                {"stress", "L2 over xx, yy, zz and twice xy, all bodies"},
                {"pressure", "L2 of the reported pressures over the first contact"},
                {"force", "normal force of the first contact"}}}};
    }

    /// Displacement of the scene's first side with a given resultant, if it has one.
    Json rigid_displacement(const Results &results)
    {
      const auto given =
          std::find_if(results.bodies.begin(), results.bodies.end(),
                       [](const BodyResult &body) { return body.body->resultant().has_value(); });
      return given != results.bodies.end() ? number(given->rigid_displacement) : Json(nullptr);
    }

    Json iteration_summary(const Results &results)
    {
      Json distance;
      if (const auto &limit = results.limit_distance)
        distance = {{"displacement", number(limit->displacement)},
                    {"energy", number(limit->energy)},
                    {"peak_pressure", number(limit->peak_pressure)}};
      return {{"increment", number(results.iteration.increment)},
              {"error_is_bound",
               results.iteration.error_is_bound && std::isfinite(results.iteration.iteration_error)},
              {"limit_distance", distance},
              {"rigid_displacement", rigid_displacement(results)},
              {"dense_compliance", results.compliance_is_dense}};
    }

    Json time_summary(const Times &times, const double total)
    {
      return {{"total", number(total)},
              {"mesh", number(times.mesh)},
              {"assemble", number(times.assemble)},
              {"factorise", number(times.factorise)},
              {"solve", number(times.solve)},
              {"interface", number(times.interface)},
              {"bem", number(times.bem)},
              {"estimate", number(times.estimate)},
              {"adapt", number(times.adapt)},
              {"reference", number(times.reference)},
              {"output", number(times.output)}};
    }

    double peak_memory_mb()
    {
      rusage usage;
      getrusage(RUSAGE_SELF, &usage);
      return static_cast<double>(usage.ru_maxrss) / 1024.; // KiB on Linux
    }

    Json counter_summary(const Results &results)
    {
      Json bodies = Json::object();
      for (const BodyResult &result : results.bodies)
      {
        const BodyCounters &counters = result.counters;
        bodies[result.body->name()] = {{"meshes", counters.meshes},
                                       {"assemblies", counters.assemblies},
                                       {"factorisations", counters.factorisations},
                                       {"solves", counters.solves},
                                       {"mortars", counters.mortars},
                                       {"iterations", counters.iterations}};
      }
      return {{"bodies", bodies},
              {"mpi_initialised", mpi_is_initialised()},
              {"p4est_initialised", p4est_is_initialised()}};
    }

    Json version_summary()
    {
      const auto dotted = [](const int major, const int minor, const int patch) {
        return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
      };
      int cholmod[3];
      cholmod_version(cholmod);
      return {{"abut", ABUT_VERSION},
              {"deal.II", DEAL_II_PACKAGE_VERSION},
              {"Eigen", dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
              {"CHOLMOD", dotted(cholmod[0], cholmod[1], cholmod[2])},
              {"BLAS", blas_name()}};
    }
  } // namespace

  std::string to_string(const StoppedBy reason)
  {
    switch (reason)
    {
    case StoppedBy::bound:
      return "bound";
    case StoppedBy::residual:
      return "residual";
    case StoppedBy::increment:
      return "increment";
    case StoppedBy::maximum_steps:
      return "maximum steps";
    case StoppedBy::stalled:
      return "stalled";
    }
    return "unknown";
  }

  nlohmann::ordered_json summary(const Results &results, const double total_seconds)
  {
    Json bodies = Json::array(), contacts = Json::array();
    for (const BodyResult &body : results.bodies)
      bodies.push_back(body_summary(body));
    for (const PairResult &pair : results.pairs)
      contacts.push_back(contact_summary(pair));

    const SchemeResult &iteration = results.iteration;
    Json json;
    json["status"] = results.converged() ? "converged" : "not converged";
    json["stopped_by"] =
        results.adaptation_end ? results.adaptation_end->stopped_by : to_string(iteration.stopped_by);
    json["message"] = results.message();
    json["warnings"] = Json::array();
    for (const Warning &warning : results.warnings)
      json["warnings"].push_back({{"code", to_string(warning.code)}, {"message", warning.text}});
    json["processes"] = results.n_processes;
    json["passes"] = results.passes.size();
    json["steps"] = results.steps();
    json["relaxation"] = number(iteration.relaxation);
    json["bodies"] = bodies;
    json["contacts"] = contacts;
    json["points"] = points_summary(results.points);
    json["error"] = error_summary(results);
    json["goal"] = goal_summary(results);
    json["true_error"] = true_error_summary(results.true_errors);
    json["pass_table"] = Json::array();
    for (const PassRecord &pass : results.passes)
      json["pass_table"].push_back(pass_summary(pass));
    json["iteration"] = iteration_summary(results);
    json["time_s"] = time_summary(results.times, total_seconds);
    json["peak_memory_mb"] = peak_memory_mb();
    json["counters"] = counter_summary(results);
    json["versions"] = version_summary();
    json["left_out"] = results.left_out;
    return json;
  }
} // namespace abut
