// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/warning.h>
#include <abut/report/reference/summary_keys.h>

namespace abut
{
  namespace
  {
    using Keys = std::vector<SummaryKey>;

    const std::string force_unit = "force / thickness",
                      energy_unit = "energy / thickness"; // units of plane strain

    std::string warning_codes()
    {
      std::string codes;
      for (const WarningCode code : all_warning_codes())
        codes += (codes.empty() ? "one of: " : " | ") + to_string(code);
      return codes;
    }

    Keys keys_of_the_run()
    {
      return {{"status", "one of: converged | not converged", "",
               "whether the run reached what it was asked for"},
              {"stopped_by",
               "one of: bound | residual | increment | maximum steps | stalled | limit | tolerance | maximum "
               "passes | maximum unknowns | no cell to split | no body adapts | goal",
               "",
               "what ended it: the rule of the interface problem (bound, residual: an algebraic error where "
               "there is no bound, increment, maximum steps, stalled), or of the meshes where they adapt "
               "(the others)"},
              {"message", "text", "", "cause and way out where it is not converged; else empty"},
              {"processes", "count", "", "that shared the run ([processes](../processes.md))"},
              {"passes", "count", "", "meshes that were solved on"},
              {"steps", "count", "", "of the decomposition, all passes together"},
              {"relaxation", "number or null", "no unit",
               "gamma of the scheme neumann; 0 with the other schemes"},
              {"peak_memory_mb", "number", "MiB", "most memory that the (first) process has held"},
              {"left_out", "texts", "", "what the run did without, and why"},
              {"warnings", "list", "",
               "what the user should know of input and results ([warnings](../warnings.md))"},
              {"warnings[].code", warning_codes(), "", "its name, which does not change"},
              {"warnings[].message", "text", "", "one sentence: what, with the numbers, and the way out"}};
    }

    Keys keys_of_bodies()
    {
      return {
          {"bodies", "list", "", "in the order of the list Bodies; the last pass"},
          {"bodies[].name", "text", "", "as in the parameter file"},
          {"bodies[].processes", "count", "",
           "in which it lives ([a body in several processes](../processes.md#a-body-in-several-processes))"},
          {"bodies[].mesh_processes", "count", "",
           "that have its mesh, or a part of it, at the end of the run; of a rigid body all"},
          {"bodies[].cells", "count", "", "of its mesh; 0 of a rigid body"},
          {"bodies[].dofs", "count", "", "unknowns, those that supports hold included"},
          {"bodies[].boundary_dofs", "count", "", "those of them at nodes on the boundary"},
          {"bodies[].cells_at_glue", "count", "", "cells with a glued edge"},
          {"bodies[].condition", "number or null", "no unit",
           "condition number of the stiffness matrix, within some per cent (Output/Condition numbers)"},
          {"bodies[].energy", "number", energy_unit, "strain energy"},
          {"bodies[].max_von_mises", "number", "stress",
           "largest von Mises stress, over the points of the VTU file"},
          {"bodies[].max_strain", "number", "no unit",
           "largest principal strain by its size, over the Gauss points"},
          {"bodies[].max_displacement", "number", "length",
           "longest displacement, over the points of the VTU file"},
          {"bodies[].rigid_displacement", "number or null", "length",
           "of the side that carries a given resultant, along it"},
          {"bodies[].min_level", "count or null", "", "how often the largest cells were split"},
          {"bodies[].max_level", "count or null", "", "how often the smallest cells were split"},
          {"bodies[].h_max", "number or null", "length",
           "largest diameter of the circle through three corners of a cell"},
          {"bodies[].h_boundary", "number or null", "length", "longest edge on the boundary"},
          {"bodies[].h_ratio", "number or null", "no unit", "`h_boundary` by `h_max`"},
          {"bodies[].regularity", "number or null", "no unit",
           "largest ratio, in a cell, of that diameter to the inscribed circle's: 2.414 for squares, 2 for "
           "equilateral triangles"},
          {"bodies[].reactions", "object", "", "forces of the supports on the body, by side or point"},
          {"bodies[].reactions.<side>", "vector", force_unit, "their resultant, along x and y of the plane"},
          {"bodies[].equilibrium_residual", "number", "relative",
           "sum of all forces by the sum of their sizes"},
          {"bodies[].moment_residual", "number", "relative",
           "sum of all moments by the sum of the forces' sizes times the diagonal of the body's box"}};
    }

    Keys keys_of_contacts()
    {
      return {
          {"contacts", "list", "", "in the order of the list Contacts; the last pass"},
          {"contacts[].name", "text", "", "as in the parameter file, or as found (Contacts = automatic)"},
          {"contacts[].force", "vector", force_unit,
           "resultant on the slave side, along x and y of the plane"},
          {"contacts[].normal_force", "number", force_unit, "integral of the pressure, never negative"},
          {"contacts[].max_pressure", "number", "stress",
           "largest reported pressure (`pressure` of the csv file)"},
          {"contacts[].contact_length", "number", "length",
           "of the parts that press; without a penalty up to ends found by force and moment of the last "
           "ones, else good "
           "to a part at each end"},
          {"contacts[].max_penetration", "number", "length", "largest mean overlap of a part; 0 without"},
          {"contacts[].min_gap", "number or null", "length",
           "smallest mean gap of a part, negative: overlap; null where the sides face each other nowhere"},
          {"contacts[].max_sliding", "number", "length",
           "largest tangential displacement of the sides relative to each other, mean of a part that "
           "presses"},
          {"contacts[].penalty", "number", "length / stress", "theta; 0: exact contact"},
          {"contacts[].coverage", "number", "no unit",
           "share of the slave side that the master faces, 0 to 1"},
          {"contacts[].missed_contact", "count", "", "pieces that overlap where no part presses"}};
    }

    Keys keys_of_points()
    {
      return {
          {"points", "list", "", "the solution at Output/Points: of each, every body that has it"},
          {"points[].body", "text", "", "as in the parameter file"},
          {"points[].number", "count", "", "of the point in the list, from 1"},
          {"points[].place", "vector", "length", "on the undeformed body"},
          {"points[].displacement", "vector", "length", "there"},
          {"points[].stress_xx", "number", "stress", "mean over the cells that meet there, tension positive"},
          {"points[].stress_yy", "number", "stress", "likewise"},
          {"points[].stress_zz", "number", "stress", "likewise, out of the plane"},
          {"points[].stress_xy", "number", "stress", "likewise"},
          {"points[].von_mises", "number", "stress", "of these components"}};
    }

    Keys keys_of_errors()
    {
      return {
          {"error", "object", "",
           "what the error of the last pass is estimated to be, and of what it is made "
           "([tolerance](../tolerance.md)); relative to the solution, in the energy norm of all bodies "
           "together"},
          {"error.norm", "one of: energy", "", "the norm of all that follows but `stress` and `effectivity`"},
          {"error.discretisation", "number or null", "relative",
           "of the finite elements under their own traction"},
          {"error.contact", "number or null", "relative",
           "what the sides of contacts miss of the contact law"},
          {"error.penalty", "number or null", "relative", "what the penalty changes against exact contact"},
          {"error.iteration", "number or null", "relative",
           "of the interface problem: a bound or an algebraic error, see `iteration.error_is_bound`"},
          {"error.linear_algebra", "number or null", "relative", "round-off in the bodies' equations"},
          {"error.geometry", "number or null", "relative",
           "edges of cells against the curves they stand for"},
          {"error.bound", "number or null", "relative", "bound of the whole error; null where there is none"},
          {"error.estimate", "number or null", "relative", "root of the squares of the parts"},
          {"error.dominant",
           "one of: discretisation | contact | iteration | penalty | linear_algebra | geometry or null", "",
           "the largest part"},
          {"error.total", "number or null", "relative",
           "the bound where `error_is_bound`, else the estimate; with a Tolerance raised to what the change "
           "from the mesh before shows"},
          {"error.error_is_bound", "true or false", "", "whether `total` is a bound"},
          {"error.estimate_reason", "text", "",
           "why it is none; empty where it is one, or nothing was estimated"},
          {"error.stress", "number or null", "relative",
           "estimated, L2 of the stress over xx, yy, zz and twice xy"},
          {"error.pressure", "number or null", "relative",
           "estimated, of the reported pressures of all contacts, L2, from these alone; null with a penalty, "
           "and "
           "where the pressure is infinite at an edge"},
          {"error.eta_max", "number or null", "relative",
           "largest eta of a cell of the bodies that adapt: its stress error by the mean stress of its body"},
          {"error.effectivity", "number or null", "no unit",
           "estimated by true error of the stress, both for the traction applied"},
          {"error.effectivity_total", "number or null", "no unit", "`total` by `true_error.energy`"},
          {"goal", "object or null", "", "what a Tolerance was asked for; null without one"},
          {"goal.name", "text", "", "energy, force, peak pressure, or stress at (x, y)"},
          {"goal.tolerance", "number", "relative", "the error asked for"},
          {"goal.value", "number or null", "force / thickness, or stress",
           "the goal itself; null for the energy norm"},
          {"goal.error", "number or null", "relative", "its estimated error; null before the third mesh"},
          {"goal.discretisation", "number or null", "relative", "the part of the meshes"},
          {"goal.penalty", "number or null", "relative", "the part of the penalty; null for stresses"},
          {"true_error", "object", "",
           "against the exact solution that the scene names, last pass; null where it does not know"},
          {"true_error.energy", "number or null", "relative", "energy norm, all bodies"},
          {"true_error.stress", "number or null", "relative",
           "L2 of the stress over xx, yy, zz and twice xy"},
          {"true_error.pressure", "number or null", "relative", "L2 of the reported pressure, first contact"},
          {"true_error.force", "number or null", "relative", "normal force, first contact"},
          {"true_error.norms", "object", "", "the same for readers of the file"},
          {"true_error.norms.energy", "text", "", "norm of `energy`"},
          {"true_error.norms.stress", "text", "", "norm of `stress`"},
          {"true_error.norms.pressure", "text", "", "norm of `pressure`"},
          {"true_error.norms.force", "text", "", "what `force` is of"}};
    }

    Keys keys_of_the_iteration()
    {
      return {{"iteration", "object", "", "of the interface problem, last pass"},
              {"iteration.increment", "number or null", "relative",
               "change of the normal contact displacement in the last step, the largest of a body; null with "
               "the scheme conjugate"},
              {"iteration.error_is_bound", "true or false", "",
               "whether `error.iteration` is a guaranteed bound; false where it is null"},
              {"iteration.limit_distance", "object or null", "",
               "how far the reported state is from the limit of the iteration; with the stopping rule "
               "increment, where the interface compliance is a matrix"},
              {"iteration.limit_distance.displacement", "number or null", "relative",
               "normal contact displacement, the largest of a body"},
              {"iteration.limit_distance.energy", "number or null", "relative", "energy norm"},
              {"iteration.limit_distance.peak_pressure", "number or null", "stress",
               "largest load of a part in the limit"},
              {"iteration.rigid_displacement", "number or null", "length",
               "`bodies[].rigid_displacement` of the first body that has one"},
              {"iteration.dense_compliance", "true or false", "",
               "whether the interface compliance was made as a matrix"}};
    }

    Keys keys_of_costs()
    {
      return {
          {"time_s", "object", "",
           "seconds of wall clock by task; bodies are prepared side by side, of which the one that takes "
           "longest counts"},
          {"time_s.total", "number", "s", "since the scene was read, to the last file but this one"},
          {"time_s.mesh", "number", "s", "meshes, sides, contacts"},
          {"time_s.assemble", "number", "s", "stiffness matrix of the body that takes longest to prepare"},
          {"time_s.factorise", "number", "s", "its factor"},
          {"time_s.solve", "number", "s", "fields of the bodies from the contact forces"},
          {"time_s.interface", "number", "s", "the scheme, its solves included"},
          {"time_s.bem", "number", "s",
           "boundary elements, added up over bodies that are solved side by side; takes place within "
           "`estimate`"},
          {"time_s.estimate", "number", "s", "estimates of errors"},
          {"time_s.adapt", "number", "s", "marking, splitting, carrying over"},
          {"time_s.reference", "number", "s", "comparing with the exact solution"},
          {"time_s.output", "number", "s", "files and pictures"},
          {"counters", "object", "", "how often the expensive things were done"},
          {"counters.bodies", "object", "", "by body"},
          {"counters.bodies.<body>", "object", "", "of one body, all passes"},
          {"counters.bodies.<body>.meshes", "count", "", "meshes made"},
          {"counters.bodies.<body>.assemblies", "count", "", "stiffness matrices"},
          {"counters.bodies.<body>.factorisations", "count", "", "factors"},
          {"counters.bodies.<body>.solves", "count", "", "right sides solved for"},
          {"counters.bodies.<body>.mortars", "count", "", "couplings of two sides inside the body"},
          {"counters.bodies.<body>.iterations", "count", "",
           "of the last right side where the body lives in several processes; 0 with a factor"},
          {"counters.mpi_initialised", "true or false", "", "whether MPI was started"},
          {"counters.p4est_initialised", "true or false", "", "whether p4est was started"},
          {"versions", "object", "", "of the program and of the libraries that numbers depend on"},
          {"versions.<name>", "text", "",
           "abut, deal.II, Eigen, CHOLMOD; BLAS: name, version and kernels of OpenBLAS"}};
    }
  } // namespace

  const std::vector<SummaryKey> &summary_keys()
  {
    static const Keys all = [] {
      Keys keys;
      for (const Keys &more : {keys_of_the_run(), keys_of_bodies(), keys_of_contacts(), keys_of_points(),
                               keys_of_errors(), pass_keys(), keys_of_the_iteration(), keys_of_costs()})
        keys.insert(keys.end(), more.begin(), more.end());
      return keys;
    }();
    return all;
  }
} // namespace abut
