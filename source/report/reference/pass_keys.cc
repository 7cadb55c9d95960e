// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/report/reference/summary_keys.h>

namespace abut
{
  namespace
  {
    /// Of the estimator, over some cells.
    std::vector<SummaryKey> quality_keys(const std::string &part, const std::string &cells)
    {
      const std::string path = "pass_table[].estimator." + part;
      return {{path, "object or null", "",
               "over " + cells + "; null where there are none, or their error is zero"},
              {path + ".effectivity", "number", "no unit", "estimated by true error of the stress, L2"},
              {path + ".better_ratio", "number or null", "no unit",
               "error of the estimator's better stress by that of the finite elements; null for kelly, which "
               "has none"},
              {path + ".computed_error", "number", "relative",
               "error of the finite elements' stress, L2, by the norm of the stress in all cells"},
              {path + ".better_error", "number or null", "relative", "the same of the better stress"}};
    }

    void add_keys(std::vector<SummaryKey> &keys, const std::vector<SummaryKey> &more)
    {
      keys.insert(keys.end(), more.begin(), more.end());
    }
  } // namespace

  std::vector<SummaryKey> pass_keys()
  {
    const std::string at = "pass_table[].";
    std::vector<SummaryKey> keys = {
        {"pass_table", "list", "",
         "what every pass found, all bodies together; errors are relative and in the energy norm where "
         "nothing else is said"},
        {at + "pass", "count", "", "number of the mesh, from 0"},
        {at + "cells", "count", "", "of all bodies"},
        {at + "dofs", "count", "", "unknowns of all bodies, those that supports hold included"},
        {at + "boundary_dofs", "count", "", "those of them at nodes on the boundaries"},
        {at + "steps", "count", "", "of the decomposition in this pass"},
        {at + "increment", "number or null", "relative", "as `iteration.increment`"},
        {at + "eta_max", "number or null", "relative", "as `error.eta_max`"},
        {at + "error_discretisation", "number or null", "relative", "as `error.discretisation`"},
        {at + "error_contact", "number or null", "relative", "as `error.contact`"},
        {at + "error_penalty", "number or null", "relative", "as `error.penalty`"},
        {at + "error_iteration", "number or null", "relative", "as `error.iteration`"},
        {at + "error_linear_algebra", "number or null", "relative", "as `error.linear_algebra`"},
        {at + "error_geometry", "number or null", "relative", "as `error.geometry`"},
        {at + "error_bound", "number or null", "relative", "as `error.bound`"},
        {at + "error_estimate", "number or null", "relative", "as `error.estimate`"},
        {at + "estimate_reason", "text", "", "as `error.estimate_reason`"},
        {at + "error_total", "number or null", "relative", "as `error.total`"},
        {at + "error_is_bound", "true or false", "", "as `error.error_is_bound`"},
        {at + "goal", "number or null", "force / thickness, or stress", "as `goal.value`"},
        {at + "goal_error", "number or null", "relative", "as `goal.error`; null for the energy norm"},
        {at + "estimated_by", "text", "",
         "the estimator: fe-be, kelly, ...; several where bodies differ (fe-be, kelly); empty where "
         "nothing was estimated"},
        {at + "error_stress", "number or null", "relative", "as `error.stress`"},
        {at + "error_pressure", "number or null", "relative", "as `error.pressure`"},
        {at + "true_error_energy", "number or null", "relative", "as `true_error.energy`"},
        {at + "true_error_stress", "number or null", "relative", "as `true_error.stress`"},
        {at + "true_error_pressure", "number or null", "relative", "as `true_error.pressure`"},
        {at + "true_error_force", "number or null", "relative", "as `true_error.force`"},
        {at + "effectivity", "number or null", "no unit", "as `error.effectivity`"},
        {at + "effectivity_total", "number or null", "no unit", "as `error.effectivity_total`"},
        {at + "estimator", "object or null", "",
         "what the estimator is worth ([estimator](../estimator.md)); where the exact response to the "
         "traction applied is known"}};
    add_keys(keys, quality_keys("whole", "all cells"));
    add_keys(keys, quality_keys("boundary_cells", "cells with an edge on the boundary"));
    add_keys(keys,
             quality_keys("contact_end_cells", "cells within one and a half diameters of an end of contact"));
    add_keys(keys, quality_keys("interior_cells", "cells without an edge on the boundary"));
    add_keys(keys,
             {{at + "estimator.pearson", "number or null", "no unit",
               "correlation of estimated and true errors of cells"},
              {at + "estimator.spearman", "number or null", "no unit", "correlation of their ranks"},
              {at + "change", "number or null", "relative", "of the displacement since the mesh before"},
              {at + "normal_force", "number", "force / thickness", "sum of all contacts"},
              {at + "max_pressure", "number", "stress", "largest reported pressure of all contacts"},
              {at + "missed_contact", "count", "", "pieces that overlap where no part presses, all contacts"},
              {at + "meshes", "list", "", "in the order of the list Bodies"},
              {at + "meshes[].h_max", "number or null", "length", "as `bodies[].h_max`"},
              {at + "meshes[].h_boundary", "number or null", "length", "as `bodies[].h_boundary`"},
              {at + "meshes[].h_ratio", "number or null", "no unit", "as `bodies[].h_ratio`"},
              {at + "meshes[].regularity", "number or null", "no unit", "as `bodies[].regularity`"},
              {at + "cost", "object", "", "of this pass, all bodies"},
              {at + "cost.fe_assemble_s", "number", "s",
               "stiffness matrix of the body that takes longest to prepare"},
              {at + "cost.fe_factorise_s", "number", "s", "its factor"},
              {at + "cost.fe_solve_s", "number", "s", "fields of the bodies"},
              {at + "cost.bem_elements", "count", "", "boundary elements"},
              {at + "cost.bem_unknowns", "count", "", "their unknowns"},
              {at + "cost.bem_models", "count", "", "operators made anew for a mesh"},
              {at + "cost.bem_assemble_s", "number", "s", "operators and factors of the boundary elements"},
              {at + "cost.bem_solve_s", "number", "s", "their solutions"},
              {at + "cost.bem_evaluate_s", "number", "s", "their stresses inside the bodies"},
              {at + "wall_time_s", "number", "s",
               "since the run began, without comparing with the exact solution and without pictures"}});
    return keys;
  }
} // namespace abut
