// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/gathered.h>
#include <abut/base/text.h>
#include <abut/base/user_error.h>
#include <abut/mesh/body_mesh.h>
#include <abut/mesh/jacobians.h>
#include <abut/mesh/mesh_checks.h>
#include <abut/mesh/raw_mesh.h>
#include <abut/mesh/shared_mesh.h>
#include <abut/scene/shape_entry.h>

#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/mapping_fe.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <sstream>

namespace abut
{
  namespace
  {
    RawMesh own_mesh(const ShapeEntry &shape, const BodyDescription &body)
    {
      if (shape.makes_cells)
        return shape.make(body);
      if (body.cells[0] == 0 || body.cells[1] == 0)
        throw UserError(body.section() + "/Cells: " + std::to_string(body.cells[0]) + ", " +
                        std::to_string(body.cells[1]) + "; both numbers must be at least 1");
      RawMesh mesh = shape.make(body);
      if (body.cell_type == CellType::triangles)
        mesh = split_into_triangles(mesh);
      check_cells(mesh, body.section());
      return mesh;
    }

    void place(RawMesh &mesh, const Placement &placement)
    {
      for (Vector2 &vertex : mesh.vertices)
        vertex = placement.point_to_world(vertex);
      for (auto *const edges : {&mesh.boundary_edges, &mesh.inner_edges})
        for (auto &edge : *edges)
          for (Vector2 &point : edge.curve)
            point = placement.point_to_world(point);
      for (auto &[side, facets] : mesh.facets)
        facets.height = placement.length_to_world(facets.height);
      if (placement.is_mirrored())
        turn_cells_over(mesh);
    }

    void create_triangulation(dealii::Triangulation<2> &triangulation, const RawMesh &mesh)
    {
      std::vector<dealii::Point<2>> vertices;
      for (const Vector2 &vertex : mesh.vertices)
        vertices.emplace_back(vertex.x(), vertex.y());

      std::vector<dealii::CellData<2>> cells;
      cells.reserve(mesh.cells.size());
      for (const auto &cell : mesh.cells)
      {
        cells.emplace_back(static_cast<unsigned int>(cell.size()));
        cells.back().vertices = cell;
        if (!mesh.cell_materials.empty())
          cells.back().material_id = mesh.cell_materials[cells.size() - 1];
      }
      if (mesh.cell_type == CellType::quadrilaterals && !mesh.is_one_block)
        dealii::GridTools::consistently_order_cells(cells);

      dealii::SubCellData edges;
      for (const auto &[ends, side, curve, material] : mesh.boundary_edges)
      {
        edges.boundary_lines.emplace_back(2);
        edges.boundary_lines.back().vertices.assign(ends.begin(), ends.end());
        edges.boundary_lines.back().boundary_id = side;
      }
      triangulation.create_triangulation(vertices, cells, edges);
    }

    void check_degree(const BodyDescription &body, const CellType cell_type)
    {
      if (cell_type == CellType::triangles && body.degree > 2)
        throw UserError(body.section() + "/Degree: degree " + std::to_string(body.degree) +
                        " refused for triangles, allowed are 1 and 2");
    }

    bool has_curves(const RawMesh &mesh)
    {
      return !mesh.inner_edges.empty() || std::any_of(mesh.boundary_edges.begin(), mesh.boundary_edges.end(),
                                                      [](const auto &edge) { return !edge.curve.empty(); });
    }

    /// Lets refined meshes follow the curves of the edges.
    void attach_charts(BodyMesh &mesh, const RawMesh &raw)
    {
      std::vector<RawMesh::BoundaryEdge> edges = raw.boundary_edges;
      edges.insert(edges.end(), raw.inner_edges.begin(), raw.inner_edges.end());
      mesh.charts = std::make_unique<CellCharts>(mesh.triangulation, edges);
      mesh.triangulation.signals.post_refinement.connect(
          [&mesh]() { mesh.charts->place_vertices(mesh.triangulation); });
    }
  } // namespace

  std::unique_ptr<dealii::Mapping<2, 2>> BodyMesh::mapping(const unsigned int degree) const
  {
    if (charts)
      return charts->mapping(cell_type == CellType::triangles, degree);
    if (cell_type == CellType::triangles)
      return std::make_unique<dealii::MappingFE<2>>(dealii::FE_SimplexP<2>(1));
    return std::make_unique<dealii::MappingQ<2>>(curved ? degree : 1);
  }

  std::function<Vector2(const BodyMesh::Cell &, const dealii::Point<2> &)>
  BodyMesh::geometry(const unsigned int degree) const
  {
    if (charts)
      return [this](const Cell &cell, const dealii::Point<2> &unit) {
        const dealii::Point<2> p = charts->points(cell, {unit}).front();
        return Vector2(p[0], p[1]);
      };
    return [shared = std::shared_ptr<dealii::Mapping<2>>(mapping(degree))](const Cell &cell,
                                                                           const dealii::Point<2> &unit) {
      const dealii::Point<2> p = shared->transform_unit_to_real_cell(cell, unit);
      return Vector2(p[0], p[1]);
    };
  }

  BodyMesh::BodyMesh(std::shared_ptr<Processes> sharing,
                     const dealii::Triangulation<2>::MeshSmoothing smoothing)
      : processes(std::move(sharing)),
        owned_(processes ? shared_triangulation(*processes, smoothing)
                         : std::make_unique<dealii::Triangulation<2>>(smoothing)),
        triangulation(*owned_)
  {}

  std::unique_ptr<BodyMesh> make_mesh(const BodyDescription &body, std::shared_ptr<Processes> processes)
  {
    const ShapeEntry &shape = shape_of(body);
    const unsigned int first_level = processes ? n_first_splits(body) : 0;
    RawMesh raw = own_mesh(shape, with_larger_cells(body, first_level));
    Assert(!raw.cells.empty() && !raw.boundary_edges.empty() && !raw.sides.empty(),
           dealii::ExcMessage("a mesh has cells and sides"));
    Assert(shape.has_curves == (shape.attach_curves != nullptr),
           dealii::ExcMessage("a shape with curves attaches them"));
    place(raw, body.placement);

    auto mesh = std::make_unique<BodyMesh>(std::move(processes), smoothing_of(body));
    mesh->name = body.name;
    mesh->first_level = first_level;
    mesh->cell_type = raw.cell_type;
    mesh->boundaries.insert(raw.sides.begin(), raw.sides.end());
    mesh->warnings = raw.warnings;
    mesh->facets = raw.facets;
    create_triangulation(mesh->triangulation, raw);
    const bool has_manifold = shape.has_curves && raw.cell_type == CellType::quadrilaterals;
    mesh->curved = has_manifold || has_curves(raw);
    if (has_manifold)
      shape.attach_curves(mesh->triangulation, body);
    else if (mesh->curved)
      attach_charts(*mesh, raw);
    check_degree(body, mesh->cell_type);
    if (mesh->curved)
      check_jacobians(*mesh, body.degree, body.section());
    return mesh;
  }

  void split_to_size(BodyMesh &mesh)
  {
    if (mesh.processes)
      split_all(mesh.triangulation, mesh.first_level);
  }

  void check_jacobians(const BodyMesh &mesh, const unsigned int degree, const std::string &where)
  {
    constexpr std::uint64_t jacobians = 12; // a meeting
    const auto check = [&]() { check_jacobians(mesh.triangulation, *mesh.mapping(degree), degree, where); };
    if (!mesh.processes)
      return check();
    mesh.processes->collect(jacobians, [&]() {
      check();
      return 0; // all is well
    });
  }

  namespace
  {
    /// ` from (0, 1) to (2, 1)`; where a side closes on itself, a place on it.
    std::string place_of(const dealii::types::boundary_id side, const BodyMesh &mesh)
    {
      std::map<unsigned int, unsigned int> n_edges_at;
      for (const auto &face : mesh.triangulation.active_face_iterators())
        if (face->at_boundary() && face->boundary_id() == side)
          for (const unsigned int v : {0, 1})
            ++n_edges_at[face->vertex_index(v)];
      std::vector<unsigned int> ends;
      for (const auto &[vertex, n] : n_edges_at)
        if (n == 1)
          ends.push_back(vertex);
      std::ostringstream text;
      const auto tell = [&](const std::string &word, const unsigned int vertex) {
        const dealii::Point<2> &point = mesh.triangulation.get_vertices()[vertex];
        const auto rounded = [&](const double x) { return std::abs(x) < 1e-12 * point.norm() ? 0. : x; };
        text << ' ' << word << " (" << rounded(point[0]) << ", " << rounded(point[1]) << ')';
      };
      if (ends.empty() && !n_edges_at.empty())
        tell("through", n_edges_at.begin()->first);
      for (std::size_t i = 0; i < ends.size(); ++i)
        tell(i == 0 ? "from" : i % 2 == 1 ? "to" : "and from", ends[i]);
      return text.str();
    }
  } // namespace

  dealii::types::boundary_id boundary_id(const BodyMesh &mesh, const std::string &side)
  {
    const auto found = mesh.boundaries.find(side);
    if (found != mesh.boundaries.end())
      return found->second;

    std::map<dealii::types::boundary_id, std::string> names; // 7 (bore)
    for (const auto &[name, id] : mesh.boundaries)
      names[id] += names[id].empty() ? name : " (" + name + ")";
    std::string all;
    for (const auto &[id, name] : names)
      all += (all.empty() ? "" : ", ") + name + (mesh.facets.empty() ? "" : place_of(id, mesh));
    throw UserError("Body " + mesh.name + " has no side '" + side + "'; its sides are " + all);
  }

  namespace
  {
    SideFacets together(const SideFacets &a, const SideFacets &b)
    {
      SideFacets both = a;
      both.n_edges += b.n_edges;
      both.largest_kink = std::max(a.largest_kink, b.largest_kink);
      both.height = std::max(a.height, b.height);
      both.n_blunt_corners += b.n_blunt_corners;
      return both;
    }

    void rename(BodyMesh &mesh, const dealii::types::boundary_id from, const dealii::types::boundary_id to)
    {
      for (auto face = mesh.triangulation.begin_face(); face != mesh.triangulation.end_face(); ++face)
        if (face->at_boundary() && face->boundary_id() == from)
          face->set_boundary_id(to);
      for (auto name = mesh.boundaries.begin(); name != mesh.boundaries.end();)
        name = name->second == from ? mesh.boundaries.erase(name) : std::next(name);
      if (const auto facets = mesh.facets.find(from); facets != mesh.facets.end() && from != to)
      {
        mesh.facets[to] = together(mesh.facets[to], facets->second);
        mesh.facets.erase(facets);
      }
    }
  } // namespace

  void unite_sides(BodyMesh &mesh, const std::string &name)
  {
    if (mesh.boundaries.count(name) > 0)
      return;
    const std::vector<std::string> parts = split_outside_parentheses(name, '+');
    if (parts.size() == 1)
      return;
    std::set<dealii::types::boundary_id> ids;
    for (const std::string &part : parts)
      if (!ids.insert(boundary_id(mesh, part)).second)
        throw UserError("Body " + mesh.name + ": the side `" + name + "` has `" + part + "` twice");
    for (const auto id : ids)
      rename(mesh, id, *ids.begin());
    mesh.boundaries[name] = *ids.begin();
  }

  void unite_named_sides(BodyMesh &mesh, const BodyDescription &body)
  {
    for (const Condition &condition : body.conditions)
      if (!condition.point)
        unite_sides(mesh, condition.boundary);
    for (const auto &[slave, master] : body.joints.glue.pairs)
      for (const std::string &side : {slave, master})
        unite_sides(mesh, side);
  }
} // namespace abut
