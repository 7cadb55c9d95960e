// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/text.h>
#include <abut/scene/body_description.h>
#include <abut/scene/part_description.h>
#include <abut/scene/shape_parameters.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    using dealii::ParameterHandler;
    namespace Patterns = dealii::Patterns;

    void declare_discretisation(ParameterHandler &prm)
    {
      prm.declare_entry("Method", "finite elements", Patterns::Selection("finite elements"),
                        "How the body is solved.");
      prm.declare_entry(
          "Degree", "0", Patterns::Integer(0, 3),
          "Polynomial degree, 1 to 3 (triangles: 1 or 2). 0: that of the section Discretisation.");
      prm.declare_entry("Adapt", "false", Patterns::Bool(),
                        "Whether the mesh follows the error that Adaptation/Estimator tells.");
      prm.declare_entry(
          "Processes", "0", Patterns::Integer(0),
          "Of those that mpirun starts, how many share the body's stiffness. 0: one, or all where the "
          "factor does not fit into one's memory. A run without mpirun does not ask.");
      prm.declare_entry(
          "Distributed mesh", "false", Patterns::Bool(),
          "Whether all processes that mpirun starts share the body's mesh too (p4est), each with its own "
          "cells: for meshes that do not fit into one's memory. Cells that touch differ by one level at "
          "most then, also without mpirun.");
      prm.declare_entry(
          "Nonconforming edges", "hanging nodes", Patterns::Selection("hanging nodes|mortar"),
          "How edges between a cell and finer ones are joined: the nodes that hang there follow "
          "the others, or both sides have their own displacements, equal in the mean (section "
          "Mortar).");
    }

    void declare_physics(ParameterHandler &prm)
    {
      declare_material(prm);
      declare_glued_parts(prm);
      prm.declare_entry(
          "Allow locking", "false", Patterns::Bool(),
          "Whether elements that fail for nu above 0.45 are used all the same: triangles, which "
          "lock, and degree 1 where supports hold all sides in both directions. Quadrilaterals "
          "need it for nothing else: from nu = 0.4 on they take the divergence projected onto "
          "polynomials of one degree less.");
      prm.declare_entry(
          "Body force", "", Patterns::Anything(),
          "Empty, or two formulas in x, y of the own frame separated by a comma. Force per volume "
          "along the own frame's axes, not scaled.");
      prm.declare_entry(
          "Contact depth", "0", Patterns::Double(0.),
          "H, the depth of the body along the contact normal, of which the penalty and the elastic "
          "layer are made. Length, before Scale. 0: from the shape.");
      prm.declare_entry(
          "Conditions", "", Patterns::Anything(),
          "id: kind: formulas; id: kind: formulas; ... in x, y of the own frame. id: a side of the "
          "shape, a physical line of the mesh file (name or number), several of these as a + b, or a point "
          "(x, y). Kinds, with the number of formulas: displacement (2), displacement x, displacement y, "
          "normal displacement, "
          "tangential displacement (1), traction (2), pressure (1, positive presses), resultant (1 "
          "along the outward normal, or 2: a rigid side that carries this force). Displacements "
          "are lengths before Scale; tractions and pressures stresses; resultants forces per "
          "thickness. Displacements (also x, y) may be `exact`: those of Reference/Exact solution. A point "
          "takes displacement, displacement x, displacement y. Sides without a "
          "condition are free.");
    }

    unsigned int parse_degree(const ParameterHandler &prm, const unsigned int default_degree,
                              const CellType cell_type, const std::string &where)
    {
      const long own_degree = prm.get_integer("Degree");
      const auto degree = own_degree == 0 ? default_degree : static_cast<unsigned int>(own_degree);
      if (cell_type == CellType::triangles && degree == 3)
        throw UserError(where + "Degree: degree 3 refused for triangles, allowed are 1 and 2");
      return degree;
    }

    std::vector<Expression> parse_body_force(const std::string &text, const Constants &constants,
                                             const std::string &where)
    {
      std::vector<Expression> force;
      if (text.empty())
        return force;
      for (const auto &piece : split_outside_parentheses(text, ','))
        force.emplace_back(piece, constants, where);
      if (force.size() != 2)
        throw UserError(where + ": received `" + text + "`, allowed are nothing or two formulas");
      return force;
    }
  } // namespace

  void BodyDescription::declare(ParameterHandler &prm)
  {
    declare_shape_parameters(prm);
    declare_placement(prm);
    declare_discretisation(prm);
    declare_physics(prm);
  }

  BodyDescription BodyDescription::parse(ParameterHandler &prm, const std::string &name,
                                         const BodyContext &context)
  {
    const std::string where = "Body " + name + "/";
    const Constants &constants = context.constants;
    BodyDescription body;
    body.name = name;
    parse_shape_parameters(prm, body, constants, where, context.directory);
    body.joints.mortar_edges = prm.get("Nonconforming edges") == "mortar";
    body.joints.mortar = context.mortar;
    body.placement = parse_placement(prm, where);
    body.degree = parse_degree(prm, context.default_degree, body.cell_type, where);
    body.adapt = prm.get_bool("Adapt");
    body.n_processes = static_cast<unsigned int>(prm.get_integer("Processes"));
    body.shares_mesh = prm.get_bool("Distributed mesh");
    parse_material(prm, body, context.materials, where);
    parse_glued_parts(prm, body, context.parts, where);
    body.allow_locking = prm.get_bool("Allow locking");
    body.body_force = parse_body_force(prm.get("Body force"), constants, where + "Body force");
    body.conditions = parse_conditions(prm.get("Conditions"), constants, where + "Conditions");
    if (const double depth = prm.get_double("Contact depth"); depth > 0.)
      body.contact_depth = depth;
    return body;
  }
} // namespace abut
