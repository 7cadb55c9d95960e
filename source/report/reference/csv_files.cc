// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/report/reference/csv_files.h>

#include <deal.II/base/exceptions.h>

namespace abut
{
  namespace
  {
    CsvDescription history_file()
    {
      return {
          "history.csv",
          "A row for every step of the decomposition, those of a pass one after the other. Columns with (p) "
          "are what the pass has found: they stand in its last row alone. Cells are empty where nothing was "
          "estimated or is known; errors are relative",
          {{"pass", "", "number of the mesh, from 0"},
           {"step", "", "of the decomposition in this pass, as the scheme counts them"},
           {"dofs", "", "unknowns of all bodies, those that supports hold included"},
           {"boundary_dofs", "", "those of them at nodes on the boundaries"},
           {"cells", "", "of all bodies"},
           {"eta_max", "relative", "(p) largest eta of a cell, see Adaptation/Limit"},
           {"increment", "relative",
            "change of the normal contact displacement in this step, the largest of a body; empty with the "
            "scheme conjugate"},
           {"error_discretisation", "relative",
            "(p) estimated, energy norm: `error.discretisation` of summary.json"},
           {"error_penalty", "relative", "(p) what the penalty changes, energy norm"},
           {"error_iteration", "relative",
            "of the interface problem, energy norm: with neumann a guaranteed bound for the state that the "
            "step began with, with newton an algebraic error of the state reached, empty with conjugate"},
           {"error_total", "relative", "(p) the bound of the error, else its estimate, energy norm"},
           {"true_error_energy", "relative",
            "(p) against the exact solution that the scene names, energy norm"},
           {"true_error_stress", "relative", "(p) the same in L2 of the stress"},
           {"effectivity", "no unit",
            "(p) estimated by true error of the stress, both for the traction applied"},
           {"effectivity_total", "no unit", "(p) `error_total` by `true_error_energy`"},
           {"normal_force", "force / thickness", "sum of all contacts, of the pressures of this step"},
           {"max_pressure", "stress", "largest load of a part in this step, not the reported pressure"},
           {"wall_time_s", "s", "since the scene was read"},
           {"true_error_pressure", "relative", "(p) first contact, L2 of the reported pressure"},
           {"true_error_force", "relative", "(p) first contact, normal force"},
           {"error_stress", "relative", "(p) estimated, L2 of the stress"},
           {"change", "relative", "(p) of the displacement since the mesh before, energy norm"},
           {"step_discretisation", "relative",
            "`error_discretisation` of this step (Adaptation/Estimate steps)"},
           {"step_bound", "relative", "bound of discretisation and iteration together, of this step"},
           {"step_true_error", "relative", "true error of this step, energy norm"},
           {"step_discretisation_ratio", "no unit",
            "estimated by true error of this step, before each is divided"},
           {"step_bound_ratio", "no unit", "bound by true error of this step"},
           {"error_contact", "relative",
            "(p) what the sides of contacts miss of the contact law, energy norm"},
           {"error_linear_algebra", "relative", "(p) round-off in the bodies' equations, energy norm"},
           {"error_geometry", "relative",
            "(p) edges of cells against the curves that they stand for, energy norm"},
           {"error_bound", "relative",
            "(p) bound of the whole error, energy norm; empty where there is none"},
           {"error_estimate", "relative", "(p) root of the squares of the parts, energy norm"},
           {"error_pressure", "relative", "(p) estimated, of the reported pressures of all contacts, L2"}}};
    }

    CsvDescription contact_file()
    {
      return {
          "contact_<pair>.csv",
          "A row for each part of the interface that belongs to the pair, along the side that is cut into "
          "parts (the slave; the master where other pairs on the same side say so). Parts are undeformed",
          {{"x", "length", "place of the reported pressure in the plane, along x"},
           {"y", "length", "and along y"},
           {"arc_length", "length", "the same place along the side that is cut"},
           {"gap", "length", "mean gap of the part after the bodies have moved; negative: they overlap"},
           {"pressure", "stress", "as reported: the contact pressure at the place, never negative"},
           {"length", "length", "of the part"},
           {"load", "stress",
            "mean pressure of the part, in balance with the bodies; times `length` it is a force per "
            "thickness"},
           {"load_x", "length", "middle of the part, where the load acts, along x"},
           {"load_y", "length", "and along y"}}};
    }

    CsvDescription points_file()
    {
      return {"points.csv",
              "A row for each of Output/Points and each body that has it; there is no file without points",
              {{"body", "", "as in the parameter file"},
               {"number", "", "of the point in the list, from 1"},
               {"x", "length", "place in the plane, on the undeformed body, along x"},
               {"y", "length", "and along y"},
               {"displacement_x", "length", "there, along x"},
               {"displacement_y", "length", "and along y"},
               {"stress_xx", "stress", "mean over the cells that meet there, tension positive"},
               {"stress_yy", "stress", "likewise"},
               {"stress_zz", "stress", "likewise, out of the plane"},
               {"stress_xy", "stress", "likewise"},
               {"von_mises", "stress", "of these components"}}};
    }
  } // namespace

  const std::vector<CsvDescription> &csv_files_of_runs()
  {
    static const std::vector<CsvDescription> files = {history_file(), contact_file(), points_file()};
    return files;
  }

  std::string csv_header(const std::string &file)
  {
    for (const auto *const files : {&csv_files_of_runs(), &csv_files_of_studies()})
      for (const CsvDescription &description : *files)
        if (description.name == file)
        {
          std::string header;
          for (const CsvColumn &column : description.columns)
            header += (header.empty() ? "" : ",") + column.name;
          return header + '\n';
        }
    AssertThrow(false, dealii::ExcMessage("a file that the reference does not know"));
    return {};
  }
} // namespace abut
