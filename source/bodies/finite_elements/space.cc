// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/bodies/finite_elements/carried_fields.h>
#include <abut/bodies/finite_elements/level_element.h>
#include <abut/bodies/finite_elements/seams.h>
#include <abut/bodies/finite_elements/space.h>
#include <abut/trace/make_trace.h>
#include <abut/trace/mortar.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/affine_constraints.h>

#include <map>

namespace abut
{
  namespace
  {
    constexpr unsigned int curve_degree = 4;
    constexpr double all_of_a_side = 1. - 1e-6;
    constexpr unsigned int most_levels = 24; // of a mesh with free vertices

    std::unique_ptr<dealii::FiniteElement<2>> scalar_element(const CellType type, const unsigned int degree)
    {
      if (type == CellType::triangles)
        return std::make_unique<dealii::FE_SimplexP<2>>(degree);
      return std::make_unique<dealii::FE_Q<2>>(degree);
    }

    bool has_flags(const dealii::Triangulation<2> &triangulation)
    {
      for (const auto &cell : own_cells(triangulation))
        if (cell->refine_flag_set() || cell->coarsen_flag_set())
          return true;
      return false;
    }

    /// H of Space::expansion.
    Eigen::SparseMatrix<double> expansion(const dealii::AffineConstraints<double> &constraints,
                                          const Eigen::Index n)
    {
      Eigen::SparseMatrix<double> matrix(n, n);
      if (constraints.n_constraints() == 0)
      {
        matrix.setIdentity();
        return matrix;
      }
      std::vector<Eigen::Triplet<double>> entries;
      for (Eigen::Index i = 0; i < n; ++i)
      {
        const auto dof = static_cast<dealii::types::global_dof_index>(i);
        if (!constraints.is_constrained(dof))
          entries.emplace_back(static_cast<int>(i), static_cast<int>(i), 1.);
        else
          for (const auto &[other, factor] : *constraints.get_constraint_entries(dof))
            entries.emplace_back(static_cast<int>(i), static_cast<int>(other), factor);
      }
      matrix.setFromTriplets(entries.begin(), entries.end());
      return matrix;
    }
  } // namespace

  namespace
  {
    /// The nodes inside the slave follow the others. Adds what is zero then to `rows`.
    void add_mortar(const Trace &slave, const Trace &master, const Mortar &mortar,
                    dealii::AffineConstraints<double> &constraints, std::vector<Eigen::Triplet<double>> &rows)
    {
      for (std::size_t i = 0; i < mortar.slaves.size(); ++i)
        for (const std::size_t component : {0, 1})
        {
          const unsigned int dof = slave.node_dofs()[mortar.slaves[i]][component];
          std::map<unsigned int, double> others; // both sides may share nodes
          const auto add = [&](const Mortar::Matrix &matrix, const Trace &side) {
            for (Mortar::Matrix::InnerIterator entry(matrix, static_cast<Eigen::Index>(i)); entry; ++entry)
              others[side.node_dofs()[static_cast<std::size_t>(entry.col())][component]] += entry.value();
          };
          add(mortar.of_slave_side, slave);
          add(mortar.of_master_side, master);
          constraints.add_line(dof);
          rows.emplace_back(static_cast<int>(dof), static_cast<int>(dof), 1.);
          for (const auto &[other, factor] : others)
          {
            constraints.add_entry(dof, other, factor);
            rows.emplace_back(static_cast<int>(dof), static_cast<int>(other), -factor);
          }
        }
    }
  } // namespace

  Space::Space(std::unique_ptr<BodyMesh> mesh, const unsigned int degree, const JointDescription &joints)
      : mesh_(std::move(mesh)), mapping_(mesh_->mapping(degree)), dof_handler_(mesh_->triangulation),
        joints_(joints)
  {
    Assert(mesh_->cell_type == CellType::quadrilaterals || degree <= 2,
           dealii::ExcMessage("make_mesh refuses triangles of higher degree"));
    quadrature_ = gauss_rule(*this, degree + 1);
    element_ = std::make_unique<dealii::FESystem<2>>(*scalar_element(mesh_->cell_type, degree), 2);
    distribute();
  }

  Space::~Space() = default;

  void Space::distribute()
  {
    ++n_meshes_;
    boundary_ids_.clear();
    traces_.clear();
    if (has_free_vertices())
    {
      if (mesh_->cell_type == CellType::triangles)
        throw UserError("Body " + mesh_->name +
                        ": Mortar/Vertices = free is for quadrilaterals, allowed with triangles is tied");
      if (mesh_->triangulation.n_levels() > most_levels)
        throw UserError("Body " + mesh_->name + ": its cells are split more than " +
                        std::to_string(most_levels - 1) +
                        " times, which Mortar/Vertices = free does not follow; take tied");
      for (const auto &cell : dof_handler_.active_cell_iterators())
        cell->set_active_fe_index(static_cast<unsigned int>(cell->level()));
      dof_handler_.distribute_dofs(elements_of_levels(element_->degree, most_levels));
    }
    else
      dof_handler_.distribute_dofs(*element_);
    if (mesh_->processes)
      share_dofs();
    constrain();
  }

  bool Space::has_free_vertices() const
  {
    return joints_.mortar_edges && joints_.mortar.vertices == MortarVertices::free;
  }

  void Space::glue(std::vector<GluedSides> sides)
  {
    glued_ = std::move(sides);
    constrain();
  }

  void Space::join_seams(dealii::AffineConstraints<double> &constraints)
  {
    constexpr double reach = .1; // of an edge: what both sides make of a curve
    const unsigned int geometry_degree = mesh_->curved ? curve_degree : 1;
    std::vector<Eigen::Triplet<double>> rows;
    for (const Seam &seam :
         find_seams(dof_handler_, mesh_->geometry(geometry_degree), geometry_degree, joints_.mortar.vertices))
    {
      ++n_mortars_;
      // An edge without inner nodes cannot follow.
      const bool coarser_follows =
          joints_.mortar.slave == MortarSlave::coarser && fewest_inner_nodes(seam.coarser) > 0;
      const Trace &slave = coarser_follows ? seam.coarser : seam.finer,
                  &master = coarser_follows ? seam.finer : seam.coarser;
      const double length = slave.length() / static_cast<double>(slave.segments().size());
      add_mortar(slave, master,
                 make_mortar(overlap_of(slave, master, reach * length), joints_.mortar.multipliers),
                 constraints, rows);
    }
  }

  void Space::constrain()
  {
    dealii::AffineConstraints<double> hanging;
    if (joints_.mortar_edges)
      join_seams(hanging);
    else
      hanging = hanging_nodes();
    dealii::AffineConstraints<double> constraints(hanging);
    hanging.close();
    has_hanging_nodes_ = hanging.n_constraints() > 0;
    glue_rows_.clear();
    for (const GluedSides &pair : glued_)
    {
      ++n_mortars_;
      const Trace &slave = trace(pair.slave), &master = trace(pair.master);
      const SideOverlap overlap = overlap_of(slave, master, pair.reach);
      if (!(overlap.share > all_of_a_side))
        throw ComputationError(
            "Body " + mesh_->name + ": the glued side " + pair.slave_name + " has come off " +
            pair.master_name +
            " where cells were split: they are too far apart between the nodes they had; let "
            "both follow one curve, or place them nearer");
      std::vector<Eigen::Triplet<double>> rows;
      add_mortar(slave, master, make_mortar(overlap, joints_.mortar.multipliers), constraints, rows);
      glue_rows_.emplace_back(n_dofs(), n_dofs()).setFromTriplets(rows.begin(), rows.end());
    }
    constraints.close();
    has_constraints_ = constraints.n_constraints() > 0;
    constrained_.assign(dof_handler_.n_dofs(), false);
    for (dealii::types::global_dof_index i = 0; i < dof_handler_.n_dofs(); ++i)
      constrained_[i] = constraints.is_constrained(i);
    expansion_ = abut::expansion(constraints, n_dofs());
    if (!glued_.empty())
      hanging_expansion_ = abut::expansion(hanging, n_dofs());
  }

  std::vector<Eigen::VectorXd> Space::adapt(const CellMarks &marks,
                                            const std::vector<Eigen::VectorXd> &fields)
  {
    dealii::Triangulation<2> &triangulation = mesh_->triangulation;
    set_flags(triangulation, marks, mesh_->first_level);
    const bool curved_borders = mesh_->charts != nullptr; // only files have several materials
    complete_flags(triangulation, curved_borders);
    if (!in_any(mesh_->processes, has_flags(triangulation)))
      return fields;
    CarriedFields carried(dof_handler_, fields);
    triangulation.execute_coarsening_and_refinement();
    grade(triangulation, marks.gradings, curved_borders, mesh_->processes);
    if (mesh_->curved)
      check_jacobians(*mesh_, degree(), "Body " + mesh_->name);
    if (mesh_->processes)
      carried.repartition(triangulation);
    distribute();

    std::vector<Eigen::VectorXd> result = carried.on(dof_handler_);
    for (Eigen::VectorXd &field : result)
      field = expansion_ * (shared_fields_ ? shared_fields_->whole(field) : field);
    return result;
  }

  const std::vector<dealii::types::boundary_id> &Space::boundary_ids() const
  {
    const std::lock_guard<std::mutex> lock(sides_mutex_);
    if (boundary_ids_.empty())
      boundary_ids_ = mesh_->triangulation.get_boundary_ids();
    return boundary_ids_;
  }

  const Trace &Space::trace(const dealii::types::boundary_id boundary) const
  {
    const std::lock_guard<std::mutex> lock(sides_mutex_);
    const auto known = traces_.find(boundary);
    if (known != traces_.end())
      return known->second;
    const unsigned int degree = mesh_->curved ? curve_degree : 1;
    return traces_
        .emplace(boundary,
                 make_trace(dof_handler_, mesh_->geometry(degree), degree, boundary, mesh_->processes))
        .first->second;
  }

  Eigen::Matrix2d gradient_at(const dealii::FEValuesBase<2> &values, const unsigned int point,
                              const std::vector<dealii::types::global_dof_index> &dofs,
                              const Eigen::VectorXd &displacement)
  {
    Eigen::Matrix2d gradient = Eigen::Matrix2d::Zero();
    for (const unsigned int i : values.dof_indices())
    {
      const auto component = values.get_fe().system_to_component_index(i).first;
      const auto shape_gradient = values.shape_grad(i, point);
      gradient.row(component) += displacement[static_cast<Eigen::Index>(dofs[i])] *
                                 Eigen::RowVector2d(shape_gradient[0], shape_gradient[1]);
    }
    return gradient;
  }

  dealii::Quadrature<2> gauss_rule(const Space &space, const unsigned int n_points)
  {
    if (space.mesh().cell_type == CellType::triangles)
      // Symmetric, where the points of QGaussSimplex depend on the order of the vertices.
      return dealii::QWitherdenVincentSimplex<2>(n_points);
    return dealii::QGauss<2>(n_points);
  }

  void visit_gradients(const Space &space, const dealii::Quadrature<2> &quadrature,
                       const Eigen::VectorXd &displacement, const GradientVisitor &visitor)
  {
    dealii::FEValues<2> values(space.mapping(), space.dof_handler().get_fe(), quadrature,
                               dealii::update_values | dealii::update_gradients | dealii::update_JxW_values |
                                   dealii::update_quadrature_points);
    const auto &fe = space.dof_handler().get_fe();
    std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
    for (const auto &cell : space.own_cells())
    {
      values.reinit(cell);
      cell->get_dof_indices(dofs);
      for (const unsigned int q : values.quadrature_point_indices())
      {
        Vector2 u = Vector2::Zero();
        for (const unsigned int i : values.dof_indices())
          u[fe.system_to_component_index(i).first] +=
              displacement[static_cast<Eigen::Index>(dofs[i])] * values.shape_value(i, q);
        const auto p = values.quadrature_point(q);
        visitor(Vector2(p[0], p[1]), values.JxW(q), u, gradient_at(values, q, dofs, displacement));
      }
    }
  }
} // namespace abut
