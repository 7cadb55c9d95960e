// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/report/pass_summary.h>

namespace abut
{
  namespace
  {
    Json square_summary(const ErrorSquares &squares, const double stress, const bool has_better)
    {
      if (!(squares.computed > 0.))
        return nullptr;
      const auto relative = [&](const double square) { return Json(std::sqrt(square / stress)); };
      return {{"effectivity", squares.effectivity()},
              {"better_ratio", has_better ? Json(squares.better_ratio()) : Json()},
              {"computed_error", relative(squares.computed)},
              {"better_error", has_better ? relative(squares.better) : Json()}};
    }

    /// What the indicator is worth, where the exact response to the applied traction is known.
    Json quality_summary(const std::optional<EstimatorQuality> &quality)
    {
      if (!quality)
        return nullptr;
      const auto part = [&](const ErrorSquares &squares) {
        return square_summary(squares, quality->stress, quality->has_better);
      };
      return {{"whole", part(quality->whole)},
              {"boundary_cells", part(quality->boundary)},
              {"contact_end_cells", part(quality->contact_end)},
              {"interior_cells", part(quality->interior)},
              {"pearson", number(quality->pearson)},
              {"spearman", number(quality->spearman)}};
    }

    Json mesh_summary(const std::vector<MeshQuality> &meshes)
    {
      Json list = Json::array();
      for (const MeshQuality &mesh : meshes)
        list.push_back({{"h_max", number(mesh.h_max)},
                        {"h_boundary", number(mesh.h_boundary)},
                        {"h_ratio", number(mesh.h_boundary / mesh.h_max)},
                        {"regularity", number(mesh.regularity)}});
      return list;
    }

    Json cost_summary(const PassCost &cost)
    {
      return {{"fe_assemble_s", cost.assemble},
              {"fe_factorise_s", cost.factorise},
              {"fe_solve_s", cost.solve},
              {"bem_elements", cost.boundary.elements},
              {"bem_unknowns", cost.boundary.unknowns},
              {"bem_models", cost.boundary.models},
              {"bem_assemble_s", cost.boundary.assemble},
              {"bem_solve_s", cost.boundary.solve},
              {"bem_evaluate_s", cost.boundary.evaluate}};
    }
  } // namespace

  Json pass_summary(const PassRecord &pass)
  {
    return {{"pass", pass.pass},
            {"cells", pass.counts.cells},
            {"dofs", pass.counts.dofs},
            {"boundary_dofs", pass.counts.boundary_dofs},
            {"steps", pass.steps},
            {"increment", number(pass.increment)},
            {"eta_max", number(pass.eta_max)},
            {"error_discretisation", number(pass.discretisation)},
            {"error_contact", number(pass.budget.contact)},
            {"error_penalty", number(pass.budget.penalty)},
            {"error_iteration", number(pass.iteration)},
            {"error_linear_algebra", number(pass.budget.linear_algebra)},
            {"error_geometry", number(pass.budget.geometry)},
            {"error_bound", number(pass.budget.bound())},
            {"error_estimate", number(pass.budget.estimate())},
            {"estimate_reason", pass.estimate_reason},
            {"error_total", number(pass.total)},
            {"error_is_bound", pass.error_is_bound()},
            {"goal", pass.goal ? number(pass.goal->value) : Json()},
            {"goal_error", pass.goal ? number(pass.goal->total()) : Json()},
            {"estimated_by", pass.estimator},
            {"error_stress", number(pass.stress)},
            {"error_pressure", number(pass.pressure)},
            {"true_error_energy", number(pass.true_errors.energy)},
            {"true_error_stress", number(pass.true_errors.stress)},
            {"true_error_pressure", number(pass.true_errors.pressure)},
            {"true_error_force", number(pass.true_errors.force)},
            {"effectivity", number(pass.effectivity())},
            {"effectivity_total", number(pass.effectivity_total)},
            {"estimator", quality_summary(pass.quality)},
            {"change", number(pass.change)},
            {"normal_force", number(pass.normal_force)},
            {"max_pressure", number(pass.max_pressure)},
            {"missed_contact", pass.n_missed},
            {"meshes", mesh_summary(pass.meshes)},
            {"cost", cost_summary(pass.cost)},
            {"wall_time_s", number(pass.seconds)}};
  }
} // namespace abut
