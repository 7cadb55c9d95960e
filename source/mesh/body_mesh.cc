// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/mesh/body_mesh.h>
#include <abut/mesh/jacobians.h>
#include <abut/mesh/manifolds.h>
#include <abut/mesh/mesh_file.h>
#include <abut/mesh/raw_mesh.h>
#include <abut/mesh/shapes.h>

#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/mapping_fe.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_tools.h>

namespace abut
{
  namespace
  {
    RawMesh built_in_shape(const BodyDescription &body)
    {
      if (body.cells[0] == 0 || body.cells[1] == 0)
        throw UserError("Body " + body.name + "/Cells: " + std::to_string(body.cells[0]) + ", " +
                        std::to_string(body.cells[1]) + "; both numbers must be at least 1");
      RawMesh mesh;
      switch (body.shape)
      {
      case Shape::rectangle:
      case Shape::rectangle_curved_top:
        mesh = rectangle(body);
        break;
      case Shape::l_shape:
        mesh = l_shape(body);
        break;
      case Shape::ring:
      case Shape::quarter_ring:
        mesh = ring(body);
        break;
      default:
        mesh = disc(body);
      }
      if (body.cell_type == CellType::triangles)
        mesh = split_into_triangles(mesh);
      check_cells(mesh, "Body " + body.name);
      return mesh;
    }

    bool has_curved_sides(const BodyDescription &body)
    {
      return has_curves(body.shape) && body.cell_type == CellType::quadrilaterals;
    }

    void place(RawMesh &mesh, const Placement &placement)
    {
      for (Vector2 &vertex : mesh.vertices)
        vertex = placement.point_to_world(vertex);
      if (placement.is_mirrored())
        turn_cells_over(mesh);
    }

    void create_triangulation(dealii::Triangulation<2> &triangulation, const RawMesh &mesh)
    {
      std::vector<dealii::Point<2>> vertices;
      for (const Vector2 &vertex : mesh.vertices)
        vertices.emplace_back(vertex.x(), vertex.y());

      std::vector<dealii::CellData<2>> cells;
      for (const auto &cell : mesh.cells)
      {
        cells.emplace_back(static_cast<unsigned int>(cell.size()));
        cells.back().vertices = cell;
      }
      if (mesh.cell_type == CellType::quadrilaterals)
        dealii::GridTools::consistently_order_cells(cells);

      dealii::SubCellData edges;
      for (const auto &[ends, side] : mesh.boundary_edges)
      {
        edges.boundary_lines.emplace_back(2);
        edges.boundary_lines.back().vertices.assign(ends.begin(), ends.end());
        edges.boundary_lines.back().boundary_id = side;
      }
      triangulation.create_triangulation(vertices, cells, edges);
    }
  } // namespace

  std::unique_ptr<dealii::Mapping<2, 2>> BodyMesh::mapping(const unsigned int degree) const
  {
    if (cell_type == CellType::triangles)
      return std::make_unique<dealii::MappingFE<2>>(dealii::FE_SimplexP<2>(1));
    return std::make_unique<dealii::MappingQ<2>>(curved ? degree : 1);
  }

  std::unique_ptr<BodyMesh> make_mesh(const BodyDescription &body)
  {
    RawMesh raw = body.shape == Shape::mesh_file ? read_mesh_file(body) : built_in_shape(body);
    place(raw, body.placement);

    auto mesh = std::make_unique<BodyMesh>();
    mesh->name = body.name;
    mesh->cell_type = raw.cell_type;
    mesh->curved = has_curved_sides(body);
    mesh->boundaries.insert(raw.sides.begin(), raw.sides.end());
    create_triangulation(mesh->triangulation, raw);
    if (mesh->curved)
    {
      attach_manifolds(mesh->triangulation, body);
      check_jacobians(mesh->triangulation, *mesh->mapping(body.degree), body.degree, "Body " + body.name);
    }
    return mesh;
  }

  dealii::types::boundary_id boundary_id(const BodyMesh &mesh, const std::string &side)
  {
    const auto found = mesh.boundaries.find(side);
    if (found != mesh.boundaries.end())
      return found->second;

    std::string message = "Body " + mesh.name + " has no side '" + side + "'; its sides are ";
    for (auto it = mesh.boundaries.begin(); it != mesh.boundaries.end(); ++it)
      message += (it == mesh.boundaries.begin() ? "" : ", ") + it->first;
    throw UserError(message);
  }
} // namespace abut
