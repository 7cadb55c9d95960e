// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/mesh/body_mesh.h>
#include <abut/mesh/raw_mesh.h>
#include <abut/scene/shape_entry.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    constexpr unsigned int curve_degree_of_parts = 4;
    constexpr double straightness = 1e-12; // of an edge

    /// Points on an edge from its first vertex to its last; none where it is straight.
    std::vector<Vector2> curve_of(const BodyMesh &mesh, const BodyMesh::Cell &cell, const unsigned int face)
    {
      const dealii::ReferenceCell reference = cell->reference_cell();
      const auto unit = [&](const unsigned int end) {
        return reference.vertex<2>(reference.face_to_cell_vertices(face, end, 1));
      };
      dealii::Point<2> from = unit(0), to = unit(1);
      if (cell->face(face)->vertex_index(0) !=
          cell->vertex_index(reference.face_to_cell_vertices(face, 0, 1)))
        std::swap(from, to);
      const LagrangeBasis basis(curve_degree_of_parts);
      const auto place = mesh.geometry(curve_degree_of_parts);
      std::vector<Vector2> points;
      for (const double s : basis.nodes())
        points.push_back(place(cell, dealii::Point<2>(from + s * (to - from))));
      const Vector2 chord = points.back() - points.front();
      for (std::size_t i = 0; i < points.size(); ++i)
        if ((points[i] - points.front() - basis.nodes()[static_cast<Eigen::Index>(i)] * chord).norm() >
            straightness * chord.norm())
          return points;
      return {};
    }

    std::array<unsigned int, 2> ends_of(const dealii::Triangulation<2, 2>::face_iterator &face)
    {
      return {{face->vertex_index(0), face->vertex_index(1)}};
    }

    /// Puts meshes side by side into one, which share nothing.
    class Gathering
    {
    public:
      explicit Gathering(const CellType type) { all_.cell_type = type; }

      /// `first_material`: that of cells with the part's own.
      void add(const BodyMesh &mesh, const unsigned int first_material)
      {
        const auto first_vertex = static_cast<unsigned int>(all_.vertices.size());
        for (const dealii::Point<2> &point : mesh.triangulation.get_vertices())
          all_.vertices.emplace_back(point[0], point[1]);
        unsigned int highest = 0;
        for (const auto &[name, id] : mesh.boundaries)
        {
          all_.sides[mesh.name + "." + name] = first_side_ + id;
          highest = std::max(highest, id);
        }
        for (const auto &[id, facets] : mesh.facets)
          all_.facets[first_side_ + id] = facets;
        all_.warnings.insert(all_.warnings.end(), mesh.warnings.begin(), mesh.warnings.end());
        for (const auto &cell : mesh.triangulation.active_cell_iterators())
        {
          all_.cells.emplace_back();
          for (const unsigned int v : cell->vertex_indices())
            all_.cells.back().push_back(first_vertex + cell->vertex_index(v));
          all_.cell_materials.push_back(first_material + cell->material_id());
          for (const unsigned int f : cell->face_indices())
            add_edge(mesh, cell, f, first_vertex, all_.cell_materials.back());
        }
        first_side_ += highest + 1;
      }

      RawMesh &result() { return all_; }

    private:
      void add_edge(const BodyMesh &mesh, const BodyMesh::Cell &cell, const unsigned int f,
                    const unsigned int first_vertex, const unsigned int material)
      {
        if (!cell->at_boundary(f) && (!mesh.curved || cell->neighbor(f)->index() < cell->index()))
          return;
        std::array<unsigned int, 2> ends = ends_of(cell->face(f));
        RawMesh::BoundaryEdge edge{{{first_vertex + ends[0], first_vertex + ends[1]}}, 0, {}, material};
        if (mesh.curved)
          edge.curve = curve_of(mesh, cell, f);
        if (cell->at_boundary(f))
        {
          edge.side = first_side_ + cell->face(f)->boundary_id();
          all_.boundary_edges.push_back(edge);
        }
        else if (!edge.curve.empty())
          all_.inner_edges.push_back(edge);
      }

      RawMesh all_;
      unsigned int first_side_ = 0;
    };

    RawMesh glued_parts(const BodyDescription &body)
    {
      Gathering gathering(body.cell_type);
      unsigned int material = 1;
      for (const BodyDescription &part : body.parts)
      {
        const auto mesh = make_mesh(part);
        if (mesh->cell_type != body.cell_type)
          throw UserError(
              "Part " + part.name +
              ": its file holds other cells than Cell type says, all parts of a body need the same");
        gathering.add(*mesh, material);
        material += 1 + static_cast<unsigned int>(part.regions.size());
      }
      return std::move(gathering.result());
    }

    ShapeEntry glued_parts_entry()
    {
      ShapeEntry entry{"glued parts", "several shapes or mesh files (Parts) with meshes of their own, glued "
                                      "where they meet (Glue), sides part.side"};
      entry.takes_parts = true;
      entry.makes_cells = true;
      entry.make = glued_parts;
      return entry;
    }

    const Registered<ShapeEntry> registered_glued_parts(glued_parts_entry());
  } // namespace
} // namespace abut
