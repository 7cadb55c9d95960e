// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/condition.h>
#include <abut/scene/placement.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace abut
{
  enum class Shape
  {
    rectangle,            ///< Size = width, height; corner at the origin. Sides left, right, bottom, top
    rectangle_curved_top, ///< Size = width, height; the top is y = Top(x). Sides as above
    disc,                 ///< Size = radius; centre at the origin. Side outer
    half_disc,            ///< Size = radius; y >= 0. Sides outer, bottom
    quarter_disc,         ///< Size = radius; x, y >= 0. Sides outer, left, bottom
    ring,                 ///< Size = inner, outer radius. Sides inner, outer
    l_shape, ///< Size = a: [-a, a]^2 without x > 0, y < 0. Sides left, right, bottom, top, corner (the notch)
    quarter_ring, ///< Size = inner, outer radius; x, y >= 0. Sides inner, outer, left, bottom
    mesh_file     ///< a Gmsh file; sides are its physical ids
  };

  /// Whether some sides of a shape are curves (those of mesh files are polygons).
  inline bool has_curves(const Shape shape)
  {
    return shape != Shape::rectangle && shape != Shape::l_shape && shape != Shape::mesh_file;
  }

  enum class CellType
  {
    quadrilaterals,
    triangles
  };

  /**
   * What the section `Body <name>` says. Points, lengths and vectors are in the body's own frame; `placement`
   * moves it into the plane. Units are the user's, consistent.
   */
  struct BodyDescription
  {
    std::string name;
    Shape shape = Shape::rectangle;
    std::vector<double> size;                  ///< see Shape
    std::array<unsigned int, 2> cells{{1, 1}}; ///< rectangle: along x, y. Disc and ring: along a quarter arc,
                                               ///< radially. L-shape: of each of its squares along x, y
    std::array<double, 2> grading{
        {1., 1.}};                 ///< rectangle: size of the last cell over that of the first, along x, y
    std::optional<Expression> top; ///< rectangle with curved top: the top's height y at x
    std::string mesh_file;         ///< as the user wrote it, relative to the parameter file
    std::string mesh_path;         ///< where it lies
    CellType cell_type = CellType::quadrilaterals;
    unsigned int degree = 1;
    bool adapt = false; ///< the mesh follows the error
    Placement placement;

    double young_modulus = 1.;
    double poisson_ratio = 0.;
    bool allow_locking = false; ///< nearly incompressible elements that are known to fail are not refused
    std::vector<Expression> body_force; ///< empty or two: force per volume, own frame, not scaled
    std::vector<Condition> conditions;
    std::optional<double>
        contact_depth; ///< H_a of the penalty and of the elastic layer, own frame; empty: from the shape

    static void declare(dealii::ParameterHandler &prm);
    /// Reads the section the handler stands in. Throws UserError. `directory` is that of the parameter file.
    static BodyDescription parse(dealii::ParameterHandler &prm, const std::string &name,
                                 unsigned int default_degree, const Constants &constants,
                                 const std::string &directory);
  };
} // namespace abut
