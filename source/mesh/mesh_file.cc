// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/text.h>
#include <abut/base/user_error.h>
#include <abut/mesh/mesh_file.h>
#include <abut/scene/shape_entry.h>

#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace abut
{
  namespace
  {
    // Read into three dimensions: into two, deal.II forgets z without a word.
    using FileMesh = dealii::Triangulation<2, 3>;

    void read_gmsh(FileMesh &mesh, const std::string &path, const std::string &where)
    {
      std::ifstream file(path);
      if (!file)
        throw UserError(where + ": cannot be opened for reading (" + path + ")");
      try
      {
        dealii::GridIn<2, 3> reader(mesh);
        reader.read_msh(file);
      }
      catch (const dealii::ExceptionBase &error)
      {
        throw UserError(where + ": deal.II cannot read it: " + one_line(error));
      }
      catch (const std::exception &error)
      {
        throw UserError(where + ": it is not a valid Gmsh file (" + error.what() + ")");
      }
    }

    /// Cells that can be reached from the first one through edges.
    unsigned int n_connected(const FileMesh &mesh)
    {
      std::vector<bool> reached(mesh.n_active_cells(), false);
      std::vector<FileMesh::active_cell_iterator> waiting{mesh.begin_active()};
      reached[0] = true;
      unsigned int n = 0;
      while (!waiting.empty())
      {
        const auto cell = waiting.back();
        waiting.pop_back();
        ++n;
        for (const unsigned int f : cell->face_indices())
          if (!cell->at_boundary(f) && !reached[cell->neighbor(f)->active_cell_index()])
          {
            reached[cell->neighbor(f)->active_cell_index()] = true;
            waiting.emplace_back(cell->neighbor(f));
          }
      }
      return n;
    }

    void check_usable(const FileMesh &mesh, const std::string &where)
    {
      if (mesh.get_reference_cells().size() != 1)
        throw UserError(where + ": it mixes triangles and quadrilaterals, give it one kind");

      double size = 0., height = 0.;
      for (const auto &vertex : mesh.get_vertices())
      {
        size = std::max({size, std::abs(vertex[0]), std::abs(vertex[1])});
        height = std::max(height, std::abs(vertex[2]));
      }
      if (height > 1e-10 * size)
        throw UserError(where + ": it leaves the plane z = 0 (|z| up to " + std::to_string(height) + ")");
      if (n_connected(mesh) != mesh.n_active_cells())
        throw UserError(where + ": it consists of several parts, a body must be one (parts that only look " +
                        "connected have double nodes)");

      const auto ids = mesh.get_boundary_ids();
      if (ids.empty() || (ids.size() == 1 && ids.front() == 0))
        throw UserError(where +
                        ": no edge of its boundary belongs to a physical line, so that no side can be " +
                        "named");
    }

    void turn_counter_clockwise(RawMesh &mesh)
    {
      for (auto &cell : mesh.cells)
      {
        const Vector2 &corner = mesh.vertices[cell[0]];
        const Vector2 a = mesh.vertices[cell[1]] - corner, b = mesh.vertices[cell[2]] - corner;
        if (a.x() * b.y() < a.y() * b.x())
          std::swap(cell[1], cell[2]);
      }
    }

    RawMesh to_raw_mesh(const FileMesh &file_mesh)
    {
      RawMesh mesh;
      mesh.cell_type =
          file_mesh.all_reference_cells_are_hyper_cube() ? CellType::quadrilaterals : CellType::triangles;
      for (const auto &vertex : file_mesh.get_vertices())
        mesh.vertices.emplace_back(vertex[0], vertex[1]);
      for (const auto &cell : file_mesh.active_cell_iterators())
      {
        mesh.cells.emplace_back();
        for (const unsigned int v : cell->vertex_indices())
          mesh.cells.back().push_back(cell->vertex_index(v));
      }
      for (const auto &face : file_mesh.active_face_iterators())
        if (face->at_boundary())
        {
          mesh.boundary_edges.push_back(
              {{{face->vertex_index(0), face->vertex_index(1)}}, face->boundary_id()});
          mesh.sides[std::to_string(face->boundary_id())] = face->boundary_id();
        }
      turn_counter_clockwise(mesh);
      return mesh;
    }
  } // namespace

  RawMesh read_mesh_file(const BodyDescription &body)
  {
    const std::string where = "Body " + body.name + "/Mesh file " + body.mesh_file;
    FileMesh file_mesh;
    read_gmsh(file_mesh, body.mesh_path, where);
    check_usable(file_mesh, where);
    RawMesh mesh = to_raw_mesh(file_mesh);
    check_cells(mesh, where);
    return mesh;
  }

  namespace
  {
    ShapeEntry mesh_file_entry()
    {
      ShapeEntry entry{"mesh file", "what Mesh file tells, sides by their physical ids"};
      entry.reads_file = true;
      entry.make = read_mesh_file;
      return entry;
    }

    const Registered<ShapeEntry> registered_mesh_file(mesh_file_entry());
  } // namespace
} // namespace abut
