// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What a body tells of its mesh and its discretisation.
#include <abut/base/directions.h>
#include <abut/base/user_error.h>
#include <abut/bodies/boundary_elements/boundary_edges.h>
#include <abut/bodies/finite_elements/cell_materials.h>
#include <abut/bodies/finite_elements/glue_partners.h>
#include <abut/bodies/finite_elements/locking.h>
#include <abut/bodies/finite_elements/projected_divergence.h>
#include <abut/bodies/finite_elements/side_conditions.h>
#include <abut/bodies/travelling_body.h>

#include <deal.II/base/index_set.h>
#include <deal.II/dofs/dof_tools.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <ostream>

namespace abut
{
  Counts FiniteElementBody::counts() const
  {
    return {space_->n_cells(), space_->dof_handler().n_dofs(), n_boundary_dofs_};
  }

  std::size_t FiniteElementBody::n_boundary_dofs() const
  {
    const dealii::IndexSet all = dealii::DoFTools::extract_boundary_dofs(space_->dof_handler());
    const dealii::IndexSet own = all & space_->dof_handler().locally_owned_dofs();
    const std::vector<std::size_t> counts = space_->gathered<std::size_t>({own.n_elements()});
    return std::accumulate(counts.begin(), counts.end(), std::size_t(0));
  }

  std::vector<CellInfo> FiniteElementBody::cells() const
  {
    std::vector<CellInfo> cells;
    const CellMaterials materials(description());
    const GluePartners partners(*space_);
    for (const auto &cell : space_->own_cells())
    {
      CellInfo info;
      for (const unsigned int i : cell->vertex_indices())
        info.vertices.emplace_back(cell->vertex(i)[0], cell->vertex(i)[1]);
      info.centre = Vector2(cell->center()[0], cell->center()[1]);
      info.diameter = cell->diameter();
      info.level = static_cast<unsigned int>(cell->level()) - space_->mesh().first_level;
      info.at_boundary = cell->at_boundary();
      info.material = materials(cell);
      for (const unsigned int f : cell->face_indices())
        info.at_glue = info.at_glue || partners.n_opposite(cell, f, 1) > 0;
      cells.push_back(std::move(info));
    }
    return space_->gathered(std::move(cells));
  }

  std::vector<BoundarySide> FiniteElementBody::boundary() const
  {
    std::map<dealii::types::boundary_id, std::vector<std::string>> names;
    for (const dealii::types::boundary_id id : space_->boundary_ids())
      names[id];
    for (const auto &[name, id] : space_->mesh().boundaries)
      if (const auto side = names.find(id); side != names.end())
        side->second.push_back(name);
    std::vector<BoundarySide> sides;
    for (const auto &[id, of_side] : names)
    {
      const auto &glued = space_->glued_sides();
      sides.push_back({of_side, space_->trace(id),
                       std::any_of(glued.begin(), glued.end(), [&, at = id](const GluedSides &pair) {
                         return pair.slave == at || pair.master == at;
                       })});
    }
    return sides;
  }

  MeshQuality FiniteElementBody::mesh_quality() const
  {
    return abut::mesh_quality(space_->mesh());
  }

  std::vector<unsigned int> FiniteElementBody::crowded_cells() const
  {
    constexpr unsigned int most = 2; // the paper's
    std::vector<unsigned int> crowded;
    if (space_->glued_sides().empty())
      return crowded;
    const GluePartners partners(*space_);
    for (const auto &cell : space_->dof_handler().active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (partners.n_opposite(cell, f) > most)
        {
          crowded.push_back(cell->active_cell_index());
          break;
        }
    return crowded;
  }

  std::vector<Material> materials_of_cells(const FiniteElementBody &body)
  {
    const CellMaterials of_cell(body.description());
    std::vector<Material> materials;
    for (const auto &cell : body.space().own_cells())
      materials.push_back(of_cell(cell));
    return body.space().gathered(std::move(materials));
  }

  std::vector<Vector2> FiniteElementBody::singular_vertices() const
  {
    return abut::singular_vertices(*this, SingularVertices::everywhere);
  }

  std::string FiniteElementBody::why_no_bound() const
  {
    if (projects_divergence())
      return "the projected divergence of the nearly incompressible body " + name() +
             " is left out of the theory";
    if (description().allow_locking && description().largest_poisson_ratio() > largest_locking_ratio)
      return "body " + name() + " is allowed to lock";
    if (!space_->glued_sides().empty())
      return "the sides of body " + name() +
             " that are glued are equal in the mean only, which is not part of it";
    if (space_->mesh().curved)
      return "the error of the straight edges that stand for the curved sides of body " + name() +
             " is not part of it";
    return {};
  }

  std::optional<SideFacets> FiniteElementBody::facets(const std::string &side) const
  {
    const BodyMesh &mesh = space_->mesh();
    const auto found = mesh.facets.find(boundary_id(mesh, side));
    return found == mesh.facets.end() ? std::nullopt : std::optional<SideFacets>(found->second);
  }

  Material FiniteElementBody::material_behind(const std::size_t side) const
  {
    const CellMaterials materials(description());
    const auto boundary = contact_boundary(side);
    std::vector<Material> behind;
    for (const auto &cell : own_cells(space_->mesh().triangulation))
      for (const unsigned int f : cell->face_indices())
        if (cell->at_boundary(f) && cell->face(f)->boundary_id() == boundary)
          behind.push_back(materials(cell));
    behind = space_->gathered(std::move(behind));
    Assert(!behind.empty(), dealii::ExcMessage("a side has cells"));
    return *std::min_element(behind.begin(), behind.end(), [](const Material &a, const Material &b) {
      return a.young_modulus < b.young_modulus;
    });
  }

  LostLoad FiniteElementBody::lost_load(const std::string &side) const
  {
    const SideConditions conditions(*this);
    const auto boundary = boundary_id(space_->mesh(), side);
    const Trace &trace = space_->trace(boundary);
    LostLoad load;
    for (const Segment &segment : trace.segments())
    {
      const Vector2 normal = Trace::averaged_normal(segment, .5), place = trace.point(segment, .5);
      const Vector2 traction = conditions.traction(boundary, place, normal);
      const Vector2 free = free_part(conditions.supported(boundary, normal), traction);
      load.lost = std::max(load.lost, (traction - free).norm());
      load.largest = std::max(load.largest, traction.norm());
    }
    return load;
  }

  void FiniteElementBody::describe(std::ostream &out) const
  {
    out << space_->n_cells() << ' '
        << (space_->mesh().cell_type == CellType::triangles ? "triangles" : "quadrilaterals") << " of degree "
        << space_->degree() << ", " << space_->n_dofs() << " unknowns, E = " << description().young_modulus
        << ", nu = " << description().poisson_ratio << '\n';
    for (const GluedSides &pair : space_->glued_sides())
      out << "  glued: " << pair.slave_name << " follows " << pair.master_name << '\n';
    for (const RegionMaterial &region : description().regions)
      out << "  region " << region.region << ": E = " << region.material.young_modulus
          << ", nu = " << region.material.poisson_ratio << '\n';
    if (projects_divergence())
      out << "  volumetric term: divergence projected onto polynomials of degree " << space_->degree() - 1
          << " (quadrilaterals from nu = " << smallest_projected_ratio << " on)\n";
  }

  const FiniteElementBody &as_finite_elements(const Body &body, const std::string &what)
  {
    if (const auto *const found = dynamic_cast<const FiniteElementBody *>(&body))
      return *found;
    if (const auto *const distant = dynamic_cast<const TravellingBody *>(&body))
      return as_finite_elements(distant->whole(), what);
    throw UserError("Body " + body.name() + ": " + what + " is for bodies of finite elements");
  }
} // namespace abut
