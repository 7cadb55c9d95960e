// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/mesh/body_mesh.h>
#include <abut/mesh/jacobians.h>
#include <abut/mesh/raw_mesh.h>
#include <abut/scene/shape_entry.h>

#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/mapping_fe.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_tools.h>

namespace abut
{
  namespace
  {
    RawMesh own_mesh(const ShapeEntry &shape, const BodyDescription &body)
    {
      if (shape.reads_file)
        return shape.make(body);
      if (body.cells[0] == 0 || body.cells[1] == 0)
        throw UserError("Body " + body.name + "/Cells: " + std::to_string(body.cells[0]) + ", " +
                        std::to_string(body.cells[1]) + "; both numbers must be at least 1");
      RawMesh mesh = shape.make(body);
      if (body.cell_type == CellType::triangles)
        mesh = split_into_triangles(mesh);
      check_cells(mesh, "Body " + body.name);
      return mesh;
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
    const ShapeEntry &shape = shape_of(body);
    RawMesh raw = own_mesh(shape, body);
    Assert(!raw.cells.empty() && !raw.boundary_edges.empty() && !raw.sides.empty(),
           dealii::ExcMessage("a mesh has cells and sides"));
    Assert(shape.has_curves == (shape.attach_curves != nullptr),
           dealii::ExcMessage("a shape with curves attaches them"));
    place(raw, body.placement);

    auto mesh = std::make_unique<BodyMesh>();
    mesh->name = body.name;
    mesh->cell_type = raw.cell_type;
    mesh->curved = shape.has_curves && raw.cell_type == CellType::quadrilaterals;
    mesh->boundaries.insert(raw.sides.begin(), raw.sides.end());
    create_triangulation(mesh->triangulation, raw);
    if (mesh->curved)
    {
      shape.attach_curves(mesh->triangulation, body);
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
