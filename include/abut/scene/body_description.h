// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/condition.h>
#include <abut/scene/materials.h>
#include <abut/scene/mesh_size.h>
#include <abut/scene/mortar_parameters.h>
#include <abut/scene/outline.h>
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
  enum class CellType
  {
    quadrilaterals,
    triangles
  };

  /// What the edges of a mesh file stand for.
  enum class BoundaryCurve
  {
    smooth,
    as_meshed
  };

  struct BodyDescription;
  using Parts = std::vector<BodyDescription>;

  /// What the section of a body refers to.
  struct BodyContext
  {
    unsigned int default_degree;
    const Constants &constants;
    const Materials &materials;
    const Parts &parts;
    MortarParameters mortar;
    std::string directory; ///< of the parameter file
  };

  /**
   * What the section `Body <name>` says. Points, lengths and vectors are in the body's own frame; `placement`
   * moves it into the plane. Units are the user's, consistent.
   */
  struct BodyDescription
  {
    std::string name;
    bool is_part = false;                      ///< of a body
    std::string shape = "rectangle";           ///< a word with a ShapeEntry
    bool is_rigid = false;                     ///< the shape has no mesh; young_modulus is infinite
    std::vector<double> size;                  ///< see ShapeEntry::size
    std::array<unsigned int, 2> cells{{1, 1}}; ///< rectangle: along x, y. Disc and ring: along a quarter arc,
                                               ///< radially. L-shape: of each of its squares along x, y
    std::array<double, 2> grading{
        {1., 1.}};                 ///< rectangle: size of the last cell over that of the first, along x, y
    std::optional<Expression> top; ///< rectangle with curved top: the top's height y at x
    std::string mesh_file;         ///< as the user wrote it, relative to the parameter file
    std::string mesh_path;         ///< where it lies
    /// Whether its mesh, or that of a part, is made from a file.
    bool reads_files() const;
    std::vector<OutlineLoop> outline; ///< of the shape outline
    MeshSize mesh_size;               ///< of geometry files and outlines
    BoundaryCurve boundary_curve = BoundaryCurve::smooth;
    Parts parts; ///< of the shape glued parts; places in the body's own frame
    JointDescription joints;
    double corner_angle = 20.; ///< degrees: where the edges of a mesh file turn by more is a corner
    CellType cell_type = CellType::quadrilaterals;
    unsigned int degree = 1;
    bool adapt = false;           ///< the mesh follows the error
    unsigned int n_processes = 0; ///< that share its stiffness where there are several; 0: automatic
    bool shares_mesh = false;     ///< among all processes, where there are several
    Placement placement;

    double young_modulus = 1.;
    double poisson_ratio = 0.;
    std::vector<RegionMaterial> regions; ///< of a mesh file that are of another material; parts and theirs
    bool allow_locking = false; ///< nearly incompressible elements that are known to fail are not refused
    std::vector<Expression> body_force; ///< empty or two: force per volume, own frame, not scaled
    std::vector<Condition> conditions;
    std::optional<double>
        contact_depth; ///< H_a of the penalty and of the elastic layer, own frame; empty: from the shape

    /// In messages: `Body <name>` or `Part <name>`.
    std::string section() const { return (is_part ? "Part " : "Body ") + name; }
    /// That of the body, then those of the regions.
    std::vector<Material> materials() const;
    double largest_poisson_ratio() const;
    /// Whether cells of different materials share vertices.
    bool has_inner_interfaces() const;
    bool is_glued() const { return !joints.glue.is_empty(); }

    static void declare(dealii::ParameterHandler &prm);
    /// Reads the section the handler stands in. Throws UserError.
    static BodyDescription parse(dealii::ParameterHandler &prm, const std::string &name,
                                 const BodyContext &context);
  };
} // namespace abut
