// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/mesh/raw_mesh.h>

#include <deal.II/base/exceptions.h>

#include <utility>

namespace abut
{
  void RawMesh::add_block(const std::array<unsigned int, 2> &n,
                          const std::function<unsigned int(unsigned int, unsigned int)> &index)
  {
    for (unsigned int j = 0; j < n[1]; ++j)
      for (unsigned int i = 0; i < n[0]; ++i)
        cells.push_back({index(i, j), index(i + 1, j), index(i, j + 1), index(i + 1, j + 1)});
  }

  void RawMesh::add_side(const std::string &name, const unsigned int n,
                         const std::function<unsigned int(unsigned int)> &index)
  {
    const unsigned int side = sides.emplace(name, static_cast<unsigned int>(sides.size())).first->second;
    for (unsigned int i = 0; i < n; ++i)
      boundary_edges.push_back({{{index(i), index(i + 1)}}, side});
  }

  void turn_cells_over(RawMesh &mesh)
  {
    for (auto &cell : mesh.cells)
      std::swap(cell[1], cell[2]);
  }

  RawMesh reflect(const RawMesh &mesh, const int component, const std::string &seam)
  {
    Assert(mesh.sides.count(seam) == 1, dealii::ExcMessage("the seam is a side of the mesh"));
    RawMesh image = mesh;
    turn_cells_over(image);

    RawMesh result = mesh;
    result.is_one_block = false;
    std::vector<unsigned int> image_index(mesh.vertices.size());
    for (unsigned int v = 0; v < mesh.vertices.size(); ++v)
      if (mesh.vertices[v][component] == 0.)
        image_index[v] = v;
      else
      {
        image_index[v] = static_cast<unsigned int>(result.vertices.size());
        result.vertices.push_back(mesh.vertices[v]);
        result.vertices.back()[component] *= -1.;
      }

    for (auto &cell : image.cells)
    {
      for (auto &v : cell)
        v = image_index[v];
      result.cells.push_back(cell);
    }

    const unsigned int seam_id = mesh.sides.at(seam);
    result.sides.erase(seam);
    result.boundary_edges.clear();
    for (const RawMesh::BoundaryEdge &edge : mesh.boundary_edges)
      if (edge.side != seam_id)
      {
        Assert(edge.curve.empty(), dealii::ExcMessage("built-in shapes have their curves by manifolds"));
        result.boundary_edges.push_back(edge);
        result.boundary_edges.push_back(
            {{{image_index[edge.vertices[0]], image_index[edge.vertices[1]]}}, edge.side});
      }
    return result;
  }

  RawMesh split_into_triangles(const RawMesh &quadrilaterals)
  {
    Assert(quadrilaterals.cell_type == CellType::quadrilaterals,
           dealii::ExcMessage("only quadrilaterals can be cut in two"));
    RawMesh result = quadrilaterals;
    result.cell_type = CellType::triangles;
    result.cells.clear();
    for (const auto &cell : quadrilaterals.cells)
    {
      result.cells.push_back({cell[0], cell[1], cell[3]});
      result.cells.push_back({cell[0], cell[3], cell[2]});
    }
    return result;
  }
} // namespace abut
