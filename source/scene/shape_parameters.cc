// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/text.h>
#include <abut/scene/shape_entry.h>
#include <abut/scene/shape_parameters.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <utility>

namespace abut
{
  namespace
  {
    using dealii::ParameterHandler;
    namespace Patterns = dealii::Patterns;

    const Choices<CellType> cell_types{{"quadrilaterals", CellType::quadrilaterals},
                                       {"triangles", CellType::triangles}};

    const Choices<BoundaryCurve> boundary_curves{{"smooth", BoundaryCurve::smooth},
                                                 {"as meshed", BoundaryCurve::as_meshed}};

    std::string sizes_of_shapes()
    {
      std::string text;
      for (const ShapeEntry &shape : Registry<ShapeEntry>::get().entries())
        if (!shape.size.empty())
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
    }

    void declare_mesh_file(ParameterHandler &prm)
    {
      prm.declare_entry(
          "Mesh file", "", Patterns::FileName(),
          "File to use in place of a built-in shape, relative to the parameter file: a mesh (Gmsh's "
          ".msh of any version) or a geometry (.geo, STEP, BREP), which is meshed with Cell type and "
          "Mesh size. The names or numbers of its physical lines are the sides; of a geometry "
          "without physical lines, the numbers of its curves. Coordinates are lengths, before Scale.");
      prm.declare_entry(
          "Outline", "", Patterns::Anything(),
          "Shapes outline and rigid outline: closed curves separated by semicolons, the outer one first, "
          "then holes: a "
          "point and pieces from there on, (0, 0) -> base: (10, 0) -> arc (12, 5) (10, 10) -> "
          "centre (5, 10) (0, 10) -> spline (1, 7) (-1, 3) (0, 0). A piece is a line to a point; an "
          "arc through a point to another; an arc about a centre to a point, less than half a "
          "circle; a spline through points; y = 5 - x^2/20 to (-10, 0): the graph of a formula in x as far "
          "as a "
          "point; close: the line back. circle (0, 0) 5 is a whole curve. "
          "A name before a piece makes it a side. Lengths, before Scale.");
      prm.declare_entry(
          "Mesh size", "0", Patterns::Anything(),
          "Geometry files and outlines: largest size of the cells, then local sizes on sides or at "
          "points: 2; bore: 0.5; (10, 0): 0.1. They grow by a quarter of the distance. Lengths, "
          "before Scale. 0: what the file says, or a tenth of the diagonal.");
      prm.declare_entry(
          "Boundary curve", "smooth", Patterns::Selection(words_of(boundary_curves)),
          "Mesh files: what their edges stand for. smooth: the curve of the geometry file, of the "
          "second-order nodes, or the smooth curve through the vertices (arcs come out as arcs); "
          "refinement and gaps follow it. as meshed: the edges themselves.");
      prm.declare_entry(
          "Corner angle", "20", Patterns::Double(0., 180.),
          "Mesh files: where the edges of a side turn by this much or more the smooth curve has a "
          "corner, as it has at the ends of sides. Degrees.");
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
      const auto grading = numbers_of(prm, "Grading");
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

    void parse_outline_of(const ParameterHandler &prm, BodyDescription &body, const ShapeEntry &shape,
                          const Constants &constants, const std::string &where)
    {
      const std::string outline = prm.get("Outline");
      if (shape.takes_outline)
        body.outline = parse_outline(outline, constants, where + "Outline");
      else if (!outline.empty())
        throw UserError(where + "Outline: received `" + outline + "`, only the shapes " +
                        Registry<ShapeEntry>::get().names_with(
                            [](const ShapeEntry &entry) { return entry.takes_outline; }) +
                        " have one");
    }

    void parse_meshing(const ParameterHandler &prm, BodyDescription &body, const ShapeEntry &shape,
                       const Constants &constants, const std::string &where)
    {
      for (const auto &[entry, unused] :
           {std::pair("Mesh size", "0"), {"Boundary curve", "smooth"}, {"Corner angle", "20"}})
        if (!shape.makes_cells && prm.get(entry) != unused)
          throw UserError(where + entry + ": received `" + prm.get(entry) +
                          "`, but nothing of the body is meshed from a file or an outline; allowed is " +
                          unused);
      body.mesh_size = parse_mesh_size(prm.get("Mesh size"), constants, where + "Mesh size");
      body.boundary_curve = choose(boundary_curves, prm.get("Boundary curve"), where + "Boundary curve");
      body.corner_angle = prm.get_double("Corner angle");
    }
  } // namespace

  std::vector<double> numbers_of(const ParameterHandler &prm, const std::string &entry)
  {
    return dealii::Utilities::string_to_double(dealii::Utilities::split_string_list(prm.get(entry)));
  }

  void declare_shape_parameters(ParameterHandler &prm)
  {
    declare_shape(prm);
    declare_mesh_file(prm);
  }

  void parse_shape_parameters(const ParameterHandler &prm, BodyDescription &body, const Constants &constants,
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
    body.is_rigid = shape.is_rigid;
    body.size = numbers_of(prm, "Size");
    if (!shape.size.empty())
      check_size(prm, body, shape, where);
    const auto cells =
        dealii::Utilities::string_to_int(dealii::Utilities::split_string_list(prm.get("Cells")));
    body.cells = {{static_cast<unsigned int>(cells[0]), static_cast<unsigned int>(cells[1])}};
    body.cell_type = choose(cell_types, prm.get("Cell type"), where + "Cell type");
    parse_outline_of(prm, body, shape, constants, where);
    parse_meshing(prm, body, shape, constants, where);
    parse_grading(prm, body, shape, where);
    parse_top(prm, body, shape, constants, where);
  }
} // namespace abut
