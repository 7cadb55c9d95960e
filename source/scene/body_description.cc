// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/text.h>
#include <abut/scene/body_description.h>
#include <abut/scene/shape_entry.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <filesystem>
#include <functional>

namespace abut
{
  namespace
  {
    using dealii::ParameterHandler;
    namespace Patterns = dealii::Patterns;

    const Choices<CellType> cell_types{{"quadrilaterals", CellType::quadrilaterals},
                                       {"triangles", CellType::triangles}};

    std::string sizes_of_shapes()
    {
      std::string text;
      for (const ShapeEntry &shape : Registry<ShapeEntry>::get().entries())
        if (!shape.reads_file)
          text += (text.empty() ? "" : "; ") + shape.name + ": " + shape.size;
      return text + ".";
    }

    void declare_shape(ParameterHandler &prm)
    {
      prm.declare_entry("Shape", "rectangle", Patterns::Anything(),
                        "In the body's own frame. Not used with a mesh file. " +
                            Vocabulary::of("Shape").documentation());
      prm.declare_entry("Size", "1, 1", Patterns::List(Patterns::Double(0.), 1),
                        "Lengths, before Scale. " + sizes_of_shapes());
      prm.declare_entry("Top", "", Patterns::Anything(),
                        "Rectangle with curved top: height y of the top at x, a formula. Length.");
      prm.declare_entry("Cells", "8, 8", Patterns::List(Patterns::Integer(1, 100000), 2, 2),
                        "Number of cells along two directions, see Shape.");
      prm.declare_entry("Grading", "1, 1", Patterns::List(Patterns::Double(0.), 2, 2),
                        "Rectangles: size of the last cell over that of the first, along x and y. No unit.");
      prm.declare_entry("Cell type", "quadrilaterals", Patterns::Selection(words_of(cell_types)),
                        "Shape of the cells.");
      prm.declare_entry("Mesh file", "", Patterns::FileName(),
                        "Gmsh file to use in place of a built-in shape, relative to the parameter file. Its "
                        "physical ids name the sides. Coordinates are lengths, before Scale.");
    }

    void declare_placement(ParameterHandler &prm)
    {
      prm.declare_entry("Scale", "1", Patterns::Double(0.),
                        "Factor, above 0, on every length of the own frame. No unit.");
      prm.declare_entry("Mirror", "false", Patterns::Bool(),
                        "Whether the body is mirrored, x to -x, before it is turned.");
      prm.declare_entry("Rotation angle", "0", Patterns::Double(),
                        "Counter-clockwise, about the origin of the own frame. Degrees.");
      prm.declare_entry("Shift", "0, 0", Patterns::List(Patterns::Double(), 2, 2),
                        "Where the origin of the own frame lies in the plane. Length.");
    }

    void declare_discretisation(ParameterHandler &prm)
    {
      prm.declare_entry("Method", "finite elements", Patterns::Selection("finite elements"),
                        "How the body is solved.");
      prm.declare_entry(
          "Degree", "0", Patterns::Integer(0, 3),
          "Polynomial degree, 1 to 3 (triangles: 1 or 2). 0: that of the section Discretisation.");
      prm.declare_entry("Adapt", "false", Patterns::Bool(),
                        "Whether the mesh follows the error that Adaptation/Estimator tells.");
      prm.declare_entry("Nonconforming edges", "hanging nodes", Patterns::Selection("hanging nodes"),
                        "How edges between a cell and finer ones are joined.");
    }

    void declare_physics(ParameterHandler &prm)
    {
      prm.declare_entry("Young modulus", "1", Patterns::Double(0.), "E, above 0. Stress.");
      prm.declare_entry("Poisson ratio", "0.3", Patterns::Double(-1., 0.5),
                        "nu, between -1 and 0.5, both excluded. No unit.");
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
          "shape, a physical id of the mesh file, or a point (x, y). Kinds, with the number of "
          "formulas: displacement (2), displacement x, displacement y, normal displacement, "
          "tangential displacement (1), traction (2), pressure (1, positive presses), resultant (1 "
          "along the outward normal, or 2: a rigid side that carries this force). Displacements "
          "are lengths before Scale; tractions and pressures stresses; resultants forces per "
          "thickness. Displacements (also x, y) may be `exact`: those of Reference/Exact solution. A point "
          "takes displacement, displacement x, displacement y. Sides without a "
          "condition are free.");
    }

    std::vector<double> doubles(const ParameterHandler &prm, const std::string &entry)
    {
      return dealii::Utilities::string_to_double(dealii::Utilities::split_string_list(prm.get(entry)));
    }

    /// The value of an entry whose lower bound is not allowed itself.
    double positive(const ParameterHandler &prm, const std::string &entry, const std::string &where)
    {
      const double value = prm.get_double(entry);
      if (!(value > 0.))
        throw UserError(where + entry + ": received `" + prm.get(entry) + "`, allowed are numbers above 0");
      return value;
    }

    void check_size(const ParameterHandler &prm, const BodyDescription &body, const ShapeEntry &shape,
                    const std::string &where)
    {
      const auto &size = body.size;
      const auto count = 1 + std::count(shape.size.begin(), shape.size.end(), ',');
      const bool positive_lengths = std::all_of(size.begin(), size.end(), [](double s) { return s > 0.; });
      const bool unordered =
          std::adjacent_find(size.begin(), size.end(), std::greater_equal<>()) != size.end();
      if (static_cast<std::ptrdiff_t>(size.size()) != count || !positive_lengths ||
          (!shape.order.empty() && unordered))
        throw UserError(where + "Size: received `" + prm.get("Size") + "`, the shape " + shape.name +
                        " needs " + shape.size + ", above 0" +
                        (shape.order.empty() ? "" : ", " + shape.order));
    }

    void parse_grading(const ParameterHandler &prm, BodyDescription &body, const ShapeEntry &shape,
                       const std::string &where)
    {
      const auto grading = doubles(prm, "Grading");
      for (std::size_t d = 0; d < 2; ++d)
      {
        body.grading[d] = grading[d];
        if (!(grading[d] > 0.) || (!shape.takes_grading && grading[d] != 1.))
          throw UserError(
              where + "Grading: received `" + prm.get("Grading") + "`, allowed are " +
              (shape.takes_grading ? "numbers above 0" : "1, 1 where the shape is not a rectangle"));
      }
    }

    void parse_top(const ParameterHandler &prm, BodyDescription &body, const ShapeEntry &shape,
                   const Constants &constants, const std::string &where)
    {
      const std::string top = prm.get("Top");
      if (shape.takes_top)
        body.top.emplace(top, constants, where + "Top");
      else if (!top.empty())
        throw UserError(
            where + "Top: received `" + top + "`, only the shape " +
            Registry<ShapeEntry>::get().names_with([](const ShapeEntry &entry) { return entry.takes_top; }) +
            " has one");
    }

    void parse_shape(const ParameterHandler &prm, BodyDescription &body, const Constants &constants,
                     const std::string &where, const std::string &directory)
    {
      body.mesh_file = prm.get("Mesh file");
      body.shape = body.mesh_file.empty() ? Vocabulary::of("Shape").check(prm.get("Shape"), where + "Shape")
                                          : "mesh file";
      const ShapeEntry &shape = shape_of(body);
      if (shape.reads_file && body.mesh_file.empty())
        throw UserError(where + "Mesh file: received ``, the shape " + shape.name + " needs its name");
      if (!body.mesh_file.empty())
        body.mesh_path = (std::filesystem::path(directory) / body.mesh_file).string();
      body.size = doubles(prm, "Size");
      if (!shape.reads_file)
        check_size(prm, body, shape, where);
      const auto cells =
          dealii::Utilities::string_to_int(dealii::Utilities::split_string_list(prm.get("Cells")));
      body.cells = {{static_cast<unsigned int>(cells[0]), static_cast<unsigned int>(cells[1])}};
      body.cell_type = choose(cell_types, prm.get("Cell type"), where + "Cell type");
      parse_grading(prm, body, shape, where);
      parse_top(prm, body, shape, constants, where);
    }

    Placement parse_placement(const ParameterHandler &prm, const std::string &where)
    {
      const auto shift = doubles(prm, "Shift");
      return {positive(prm, "Scale", where),
              prm.get_bool("Mirror"),
              prm.get_double("Rotation angle"),
              {shift[0], shift[1]}};
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

    double parse_poisson_ratio(const ParameterHandler &prm, const std::string &where)
    {
      const double nu = prm.get_double("Poisson ratio");
      if (!(nu > -1. && nu < 0.5))
        throw UserError(where + "Poisson ratio: received `" + prm.get("Poisson ratio") +
                        "`, allowed are numbers between -1 and 0.5, both excluded");
      return nu;
    }
  } // namespace

  void BodyDescription::declare(ParameterHandler &prm)
  {
    declare_shape(prm);
    declare_placement(prm);
    declare_discretisation(prm);
    declare_physics(prm);
  }

  BodyDescription BodyDescription::parse(ParameterHandler &prm, const std::string &name,
                                         const unsigned int default_degree, const Constants &constants,
                                         const std::string &directory)
  {
    const std::string where = "Body " + name + "/";
    BodyDescription body;
    body.name = name;
    parse_shape(prm, body, constants, where, directory);
    body.placement = parse_placement(prm, where);
    body.degree = parse_degree(prm, default_degree, body.cell_type, where);
    body.adapt = prm.get_bool("Adapt");
    body.young_modulus = positive(prm, "Young modulus", where);
    body.poisson_ratio = parse_poisson_ratio(prm, where);
    body.allow_locking = prm.get_bool("Allow locking");
    body.body_force = parse_body_force(prm.get("Body force"), constants, where + "Body force");
    body.conditions = parse_conditions(prm.get("Conditions"), constants, where + "Conditions");
    if (const double depth = prm.get_double("Contact depth"); depth > 0.)
      body.contact_depth = depth;
    return body;
  }
} // namespace abut
