// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/report/reference/csv_files.h>

namespace abut
{
  namespace
  {
    using Columns = std::vector<CsvColumn>;

    Columns joined(const std::vector<Columns> &groups)
    {
      Columns columns;
      for (const Columns &group : groups)
        columns.insert(columns.end(), group.begin(), group.end());
      return columns;
    }

    Columns error_columns()
    {
      return {
          {"variant", "", "its name; in quotation marks"},
          {"pass", "", "number of the mesh, from 0"},
          {"cells", "", "of all bodies"},
          {"dofs", "", "unknowns of all bodies"},
          {"steps", "", "of the decomposition in this pass"},
          {"wall_time_s", "s", "since the run began, without comparing and without writing"},
          {"true_error_stress", "relative", "against what `reference` names, L2 of the stress"},
          {"true_error_energy", "relative", "the same in the energy norm"},
          {"true_error_pressure", "relative", "first contact, L2 of the reported pressure"},
          {"true_error_force", "relative", "first contact, normal force"},
          {"error_stress", "relative", "estimated, L2 of the stress"},
          {"error_discretisation", "relative", "estimated, energy norm"},
          {"effectivity", "no unit", "estimated by true error of the stress, both for the traction applied"}};
    }

    Columns quality_columns()
    {
      const std::string ratio = "error of the estimator's better stress by that of the finite elements";
      const std::string at_boundary = " in cells with an edge on the boundary",
                        at_ends = " in cells within one and a half diameters of an end of contact",
                        inside = " in cells without an edge on the boundary";
      return {{"better_ratio", "no unit", ratio},
              {"effectivity_boundary_cells", "no unit", "`effectivity`" + at_boundary},
              {"better_ratio_boundary_cells", "no unit", "`better_ratio`" + at_boundary},
              {"effectivity_contact_end_cells", "no unit", "`effectivity`" + at_ends},
              {"better_ratio_contact_end_cells", "no unit", "`better_ratio`" + at_ends},
              {"effectivity_interior_cells", "no unit", "`effectivity`" + inside},
              {"better_ratio_interior_cells", "no unit", "`better_ratio`" + inside},
              {"pearson", "no unit", "correlation of estimated and true errors of cells"},
              {"spearman", "no unit", "correlation of their ranks"}};
    }

    Columns quantity_columns()
    {
      return {{"contact_force", "force / thickness", "normal force, sum of all contacts"},
              {"max_pressure", "stress", "largest reported pressure of all contacts"},
              {"contact_length", "length", "of what presses, sum of all contacts"},
              {"max_von_mises", "stress", "largest of all bodies, at a point"},
              {"strain_energy", "energy / thickness", "of all bodies"}};
    }

    Columns budget_columns()
    {
      const std::string part = "part of the estimated error, energy norm: `error.";
      return {{"budget_discretisation", "relative", part + "discretisation` of summary.json"},
              {"budget_contact", "relative", part + "contact`"},
              {"budget_iteration", "relative", part + "iteration`"},
              {"budget_penalty", "relative", part + "penalty`"},
              {"budget_linear_algebra", "relative", part + "linear_algebra`"},
              {"budget_geometry", "relative", part + "geometry`"},
              {"budget_estimate", "relative", "root of the squares of these parts"},
              {"budget_bound", "relative", "bound of the whole error, energy norm"}};
    }

    Columns last_columns()
    {
      return {{"reference", "", "what true errors are against: exact solution, fine run, or empty"},
              {"reference_error", "relative", "estimated error of the fine run itself, energy norm"},
              {"true_error_peak_pressure", "relative", "largest reported pressure, against a fine run"},
              {"true_error_strain_energy", "relative", "strain energy, against a fine run"},
              {"contact_force_<pair>", "force / thickness", "normal force of one contact"},
              {"max_pressure_<pair>", "stress", "its largest reported pressure"},
              {"contact_length_<pair>", "length", "of what presses there"},
              {"von_mises_<body>_<number>", "stress", "at a point of Output/Points, by body and number"},
              {"displacement_x_<body>_<number>", "length", "there, along x"},
              {"displacement_y_<body>_<number>", "length", "and along y"},
              {"load_case", "", "its name, where the study has load cases"},
              {"<Section/Name>", "as the parameter", "value of a swept parameter, in quotation marks"},
              {"warnings", "", "codes of the variant's run, see doc/warnings.md; separated by blanks"}};
    }

    CsvDescription study_file()
    {
      return {
          "study.csv",
          "`abut study` writes it: a row for each pass of each variant. Cells are empty where nothing was "
          "estimated or is known",
          joined({error_columns(), quality_columns(), quantity_columns(), budget_columns(), last_columns()})};
    }

    CsvDescription schemes_file()
    {
      return {
          "schemes.csv",
          "`abut schemes` writes it: a row for each scheme, on the initial meshes",
          {{"scheme", "", "its word in the parameter file, without quotation marks"},
           {"converged", "", "1 or 0"},
           {"steps", "", "of the scheme; empty where it was not run"},
           {"predicted_steps", "", "of the scheme neumann, where they are known beforehand"},
           {"solves", "", "right sides of the body that was solved most often"},
           {"wall_time_s", "s", "of the interface compliance and the steps"},
           {"error_iteration", "relative", "the scheme's own iteration error, energy norm"},
           {"distance", "relative", "from a solution of the same discrete problem to 1e-13, energy norm"}}};
    }

    CsvDescription passes_file()
    {
      return {"passes.csv",
              "`abut reproduce` writes it for the combined algorithm: a row for each pass of each run. The "
              "body is the last one that adapts",
              {{"run", "", "its name, in quotation marks"},
               {"pass", "", "number of the mesh, from 1"},
               {"cells", "", "of the body"},
               {"fem", "", "unknowns of its finite elements"},
               {"bem", "", "unknowns of its boundary elements"},
               {"finest_level", "", "how often its smallest cells were split"},
               {"eta", "relative", "largest eta of a cell, see Adaptation/Limit"},
               {"increment", "relative", "change of the normal contact displacement in the last step"},
               {"distance", "length", "mean distance of its smallest cells from the contact zone"},
               {"distance_of_all", "length", "mean distance of its points from there"},
               {"true_error_stress", "relative", "against the exact solution, L2 of the stress"},
               {"max_pressure", "stress", "largest reported pressure"},
               {"force", "force / thickness", "normal force of all contacts"},
               {"u_1", "length", "displacement of the monitored point, along x"},
               {"u_2", "length", "and along y"},
               {"seconds", "s", "since the run began, without comparing and without writing"}}};
    }

    CsvDescription errors_file()
    {
      return {"errors.csv",
              "`abut reproduce` writes it for other scenes: a row for each pass of each run",
              {{"run", "", "its name, in quotation marks"},
               {"pass", "", "number of the mesh, from 1"},
               {"fem", "", "unknowns of the finite elements of all bodies"},
               {"fem_and_bem", "", "these and the unknowns of the boundary elements"},
               {"seconds", "s", "since the run began, without comparing and without writing"},
               {"estimate_seconds", "s", "of the estimate in this pass"},
               {"true_error_stress", "relative", "against the exact solution, L2 of the stress"},
               {"true_error_energy", "relative", "the same in the energy norm"}}};
    }

    CsvDescription cells_file(const std::string &name, const std::string &which)
    {
      return {name,
              "`abut reproduce`: a row for each cell of the body, " + which,
              {{"pass", "", "number of the mesh, from 1"},
               {"x", "length", "mean of the cell's corners, undeformed, along x"},
               {"y", "length", "and along y"},
               {"level", "", "how often the cell was split"},
               {"von_mises", "stress", "mean of the cell"}}};
    }

    CsvDescription curves_file(const std::string &name, const CsvColumn &quantity)
    {
      return {name,
              "`abut reproduce`: points of the curves of Fig. 9",
              {{"curve", "", "its name, in quotation marks"}, {"x", "length", "of the point"}, quantity}};
    }

    CsvDescription displacements_file()
    {
      return {"figure08.csv",
              "`abut reproduce`: a row for each limit, from the last pass",
              {{"delta", "relative", "Adaptation/Limit"},
               {"u_1", "length", "displacement of the monitored point, along x"},
               {"u_2", "length", "and along y"}}};
    }

    CsvDescription unknowns_file()
    {
      return {"figure10.csv",
              "`abut reproduce`: a row for each limit, from the last pass; unknowns of the body that adapts",
              {{"delta", "relative", "Adaptation/Limit"},
               {"passes", "", "meshes that it took"},
               {"finest_level", "", "how often the smallest cells were split"},
               {"fem", "", "unknowns of the finite elements"},
               {"bem", "", "unknowns of the boundary elements"},
               {"together", "", "both"},
               {"uniform", "", "both on a mesh of equal cells as small as the smallest"}}};
    }
  } // namespace

  const std::vector<CsvDescription> &csv_files_of_studies()
  {
    static const std::vector<CsvDescription> files = {
        study_file(),
        schemes_file(),
        passes_file(),
        errors_file(),
        cells_file("figure04.csv", "in the last pass"),
        cells_file("figure07.csv", "in every pass"),
        displacements_file(),
        curves_file("figure09_displacement.csv",
                    {"u_n", "length", "displacement of the lower body along its outward normal"}),
        curves_file("figure09_pressure.csv", {"pressure", "stress", "contact pressure"}),
        unknowns_file()};
    return files;
  }
} // namespace abut
