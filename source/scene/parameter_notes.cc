// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/scene/parameter_notes.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    // Pages that explain several parameters.
    const std::string first_scene = "../README.md#a-first-scene";
    const std::string shapes_page = "your-own-geometry.md#built-in-shapes";
    const std::string frames = "reference/parameters.md#frames-and-units";
    const std::string outline_page = "your-own-geometry.md#from-an-outline";
    const std::string contacts_page = "your-own-geometry.md#contacts";
    const std::string materials_page = "your-own-geometry.md#several-materials";
    const std::string curves_page = "your-own-geometry.md#straight-edges-and-the-curve-behind-them";
    const std::string elements_page = "method.md#the-bodies-bodiesfinite_elements";
    const std::string contact_law_page = "method.md#gap-penalty-and-traction-trace-contact";
    const std::string neumann_page = "method.md#the-decomposition-decomposition";
    const std::string schemes_page = "method.md#schemes-that-do-not-slow-down";
    const std::string adaptation_page = "method.md#adaptation-adaptation";
    const std::string bem_page = "method.md#finite-against-boundary-elements-bem-adaptation";
    const std::string glue_page = "mortar.md#glued-parts";
    const std::string edges_page = "mortar.md#edges-between-cells-and-finer-ones";
    const std::string study_page = "studies.md#what-is-run";
    const std::string fine_page = "studies.md#what-errors-are-against";

    const std::string positive_number = "a number above 0";
    const std::string constant_formula = "a formula of constants, above 0 where the solution needs it";
    const std::string override_list = "Section/Name=value | Section/Name=value | ...";
    const std::string variant_list = "name: overrides; name: overrides; ...";

    std::vector<ParameterNote> notes_outside()
    {
      return {{"", "Bodies", "", "names of letters, digits, `_`, `-` and `.`, at least one", first_scene},
              {"", "Contacts", "", "names as in Bodies, or automatic", contacts_page},
              {"", "Contact distance", "length", "", contacts_page},
              {"", "Materials", "", "names as in Bodies", materials_page},
              {"", "Tolerance", "no unit", "0, or a number from 1e-10 to below 1", "tolerance.md"},
              {"", "Goal", "lengths", "energy, force, peak pressure, or stress at (x, y)",
               "tolerance.md#one-quantity-in-place-of-the-energy"},
              {"Constants", "Names", "",
               "names of letters, digits and `_` that begin with a letter; not x, y, pi", frames},
              {"Constants", "Values", "the user's units", "", frames},
              {"Output", "Directory", "", "", first_scene},
              {"Output", "Condition numbers", "", "", edges_page},
              {"Output", "Checkpoint", "", "", "long-runs.md"},
              {"Output", "Report", "", "", first_scene},
              {"Output", "Points", "lengths", "(x, y); body: (x, y); ..., or nothing", first_scene},
              {"Discretisation", "Degree", "", "", elements_page}};
    }

    std::vector<ParameterNote> notes_of_shapes()
    {
      const std::string body = "Body <name>";
      return {{body, "Shape", "", "", shapes_page},
              {body, "Size", "lengths", "as many numbers above 0 as the shape needs", shapes_page},
              {body, "Top", "length", "a formula in x of the own frame", shapes_page},
              {body, "Cells", "", "", shapes_page},
              {body, "Grading", "no unit", "2 numbers above 0", shapes_page},
              {body, "Cell type", "", "", elements_page},
              {body, "Mesh file", "lengths", "", "your-own-geometry.md#from-gmsh"},
              {body, "Outline", "lengths", "curves; curves; ...", outline_page},
              {body, "Mesh size", "lengths", "a size; side: size; (x, y): size; ...", outline_page},
              {body, "Boundary curve", "", "", curves_page},
              {body, "Corner angle", "degrees", "", curves_page},
              {body, "Scale", "no unit", positive_number, frames},
              {body, "Mirror", "", "", frames},
              {body, "Rotation angle", "degrees", "", frames},
              {body, "Shift", "length", "", frames}};
    }

    std::vector<ParameterNote> notes_of_bodies()
    {
      const std::string body = "Body <name>", material = "Material <name>", contact = "Contact <name>";
      return {{body, "Method", "", "", elements_page},
              {body, "Degree", "", "", elements_page},
              {body, "Adapt", "", "", "../README.md#adaptive-meshes"},
              {body, "Processes", "", "", "processes.md#a-body-in-several-processes"},
              {body, "Distributed mesh", "", "", "processes.md#a-distributed-mesh"},
              {body, "Nonconforming edges", "", "", edges_page},
              {body, "Young modulus", "stress", positive_number, "method.md#the-problem"},
              {body, "Poisson ratio", "no unit", "a number above -1 and below 0.5", elements_page},
              {body, "Regions", "", "region: material; region: material; ...", materials_page},
              {body, "Parts", "", "names of sections `Part <name>`", glue_page},
              {body, "Glue", "", "automatic, none, or side - side; side - side; ...", glue_page},
              {body, "Allow locking", "", "", elements_page},
              {body, "Body force", "force per volume", "nothing, or two formulas in x, y of the own frame",
               "method.md#the-problem"},
              {body, "Contact depth", "length", "", contact_law_page},
              {body, "Conditions", "lengths, stresses, forces per thickness",
               "id: kind: formulas; id: kind: formulas; ...", "your-own-geometry.md#conditions"},
              {material, "Young modulus", "stress", positive_number, materials_page},
              {material, "Poisson ratio", "no unit", "a number above -1 and below 0.5", materials_page},
              {contact, "Slave", "", "body:id", contacts_page},
              {contact, "Master", "", "body:id", contacts_page},
              {contact, "Multipliers", "", "", contact_law_page},
              {contact, "Gap", "length", "geometry, or a formula in x, y of the slave's own frame",
               contact_law_page},
              {contact, "Penalty coefficient", "no unit", "", contact_law_page},
              {contact, "Penalty", "length per stress", "", contact_law_page}};
    }

    std::vector<ParameterNote> notes_of_solvers()
    {
      const std::string decomposition = "Decomposition", adaptation = "Adaptation";
      return {{decomposition, "Scheme", "", "", schemes_page},
              {decomposition, "Initial guess", "", "", neumann_page},
              {decomposition, "Relaxation", "no unit", "automatic, or a number above 0", neumann_page},
              {decomposition, "Stopping rule", "", "", neumann_page},
              {decomposition, "Tolerance", "no unit", "a number above 0 and below 1", neumann_page},
              {decomposition, "Maximum steps", "", "", neumann_page},
              {decomposition, "Interface compliance", "", "", schemes_page},
              {"Mortar", "Multipliers", "", "", "mortar.md#how"},
              {"Mortar", "Slave", "", "", "mortar.md#how"},
              {"Mortar", "Vertices", "", "", edges_page},
              {"Mortar", "Neighbour rule", "", "", "mortar.md#the-papers-undesirable-refinements"},
              {adaptation, "Estimator", "", "", "estimator.md#which-to-choose"},
              {adaptation, "Boundary solution", "", "", bem_page},
              {adaptation, "Boundary accuracy", "no unit", "", "estimator.md#what-it-costs"},
              {adaptation, "Normalisation", "", "", adaptation_page},
              {adaptation, "Limit", "no unit", "", adaptation_page},
              {adaptation, "Marking", "", "", adaptation_page},
              {adaptation, "Fraction", "no unit", "a number above 0, at most 1", adaptation_page},
              {adaptation, "Coarsening", "no unit", "a number from 0 to below 1", adaptation_page},
              {adaptation, "Maximum passes", "", "", adaptation_page},
              {adaptation, "Maximum unknowns", "", "", adaptation_page},
              {adaptation, "Iteration fraction", "no unit", "a number from 0 to below 1", adaptation_page},
              {adaptation, "Estimate steps", "", "", "estimator.md#discretisation-and-iteration-in-one"},
              {adaptation, "Combined", "", "", adaptation_page}};
    }

    std::vector<ParameterNote> notes_of_comparisons()
    {
      const std::string reference = "Reference", study = "Study";
      const std::string layers = "method.md#two-layers-between-rollers-exactly-reference";
      const std::string punch = "estimator.md#infinite-stress";
      return {
          {reference, "Exact solution", "", "", layers},
          {reference, "Contact", "", "", layers},
          {reference, "Amplitude", "force / area length^(alpha - 1)", constant_formula, punch},
          {reference, "Approach", "length", constant_formula, layers},
          {reference, "Force", "force / thickness", constant_formula, "results.md#hertz"},
          {reference, "Gap curvature", "1 / length", constant_formula, layers},
          {reference, "Half width", "length", constant_formula, punch},
          {reference, "Radius", "length", constant_formula, "results.md#hertz"},
          {study, "Common", "", override_list, study_page},
          {study, "Variants", "", variant_list, study_page},
          {study, "Crossed with", "", variant_list, study_page},
          {study, "Load cases", "", variant_list, study_page},
          {study, "Sweep", "", "Section/Name = value | value | ...; Section/Name = value | ...", study_page},
          {study, "Reference", "", "", fine_page},
          {study, "Reference run", "", override_list, fine_page},
          {study, "Peers", "", "a file name", "studies.md#studyhtml"}};
    }

    std::vector<ParameterNote> all_notes()
    {
      std::vector<ParameterNote> notes;
      for (const std::vector<ParameterNote> &more : {notes_outside(), notes_of_shapes(), notes_of_bodies(),
                                                     notes_of_solvers(), notes_of_comparisons()})
        notes.insert(notes.end(), more.begin(), more.end());
      return notes;
    }
  } // namespace

  const std::vector<SectionNote> &section_notes()
  {
    static const std::vector<SectionNote> notes = {
        {"", "Stand before or between the sections."},
        {"Constants", "Numbers with names, for all formulas of the file."},
        {"Body <name>",
         "One section for each name of the list Bodies: shape, place, mesh, material, conditions."},
        {"Part <name>",
         "One section for each name of a body's list Parts, of a body of the shape glued parts."},
        {"Material <name>", "One section for each name of the list Materials, for Regions of bodies."},
        {"Contact <name>", "One section for each name of the list Contacts: two sides that may touch."},
        {"Discretisation", "What bodies have that say nothing else."},
        {"Decomposition", "How the problem on the interfaces of the bodies is solved."},
        {"Mortar", "How displacements are made equal inside a body where meshes do not match."},
        {"Adaptation", "How errors are estimated and meshes follow them."},
        {"Reference", "The exact solution that results are compared with."},
        {"Study", "What `abut study` and `abut reproduce` run; runs of single scenes pass over it."},
        {"Output", "What is written, and where."}};
    return notes;
  }

  const std::vector<ParameterNote> &parameter_notes()
  {
    static const std::vector<ParameterNote> notes = all_notes();
    return notes;
  }

  const ParameterNote *find_note(const std::string &section, const std::string &entry)
  {
    const auto &notes = parameter_notes();
    const auto found = std::find_if(notes.begin(), notes.end(), [&](const ParameterNote &note) {
      return note.section == section && note.entry == entry;
    });
    return found == notes.end() ? nullptr : &*found;
  }
} // namespace abut
