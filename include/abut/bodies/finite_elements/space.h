// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/gathered.h>
#include <abut/base/material.h>
#include <abut/bodies/finite_elements/shared_dofs.h>
#include <abut/mesh/body_mesh.h>
#include <abut/mesh/cell_marks.h>
#include <abut/mesh/own_cells.h>
#include <abut/scene/body_description.h>
#include <abut/trace/trace.h>

#include <deal.II/base/quadrature.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/affine_constraints.h>

#include <Eigen/SparseCore>

#include <functional>
#include <map>
#include <memory>
#include <mutex>

namespace abut
{
  using Cell = dealii::DoFHandler<2>::active_cell_iterator;

  /// Two sides of a body that are glued: the nodes inside the slave follow the master's, see Mortar.
  struct GluedSides
  {
    dealii::types::boundary_id slave, master;
    std::string slave_name, master_name;
    double reach;     ///< how far one lies from the other at most
    bool is_seamless; ///< both end where the other does, and are of one material
  };

  /**
   * The finite-element space of one body: vector-valued Lagrange elements of degree p on its mesh,
   * isoparametric on curved bodies. Owns the mesh. Some unknowns are determined by others: where cells meet
   * finer ones those at hanging nodes, so that fields are continuous there, and those of glued sides.
   */
  class Space
  {
  public:
    /// `joints` say how cells and finer ones are joined; glued sides come with `glue`.
    Space(std::unique_ptr<BodyMesh> mesh, unsigned int degree, const JointDescription &joints = {});
    ~Space();

    const BodyMesh &mesh() const { return *mesh_; }
    const dealii::Mapping<2> &mapping() const { return *mapping_; }
    const dealii::DoFHandler<2> &dof_handler() const { return dof_handler_; }
    /// The active cells that are this process's own: all of them, unless processes share the mesh. These have
    /// numbers that run through the cells of one process after those of another (global_active_cell_index).
    auto own_cells() const { return abut::own_cells(dof_handler_); }
    std::size_t n_cells() const { return mesh_->triangulation.n_global_active_cells(); }
    /// What all processes have of their own cells, in the order of these. Where processes share the mesh all
    /// of them have to ask for it, as for all that the space has to make of its cells.
    template <typename T> std::vector<T> gathered(std::vector<T> of_own_cells) const
    {
      return abut::gathered(mesh_->processes, std::move(of_own_cells));
    }
    /// Hands to `take`, in all processes, what `make` hands out of the own cells of each. One process after
    /// the other, so that nobody has to keep more than what comes from one.
    template <typename T, typename Make, typename Take> void pass_on(const Make &make, const Take &take) const
    {
      constexpr std::uint64_t passing_on = 16; // a meeting
      if (!mesh_->processes)
        return make(take);
      for (unsigned int process = 0; process < mesh_->processes->size(); ++process)
        for (const std::vector<T> &values : mesh_->processes->collect(passing_on, [&]() {
               std::vector<T> own;
               if (process == mesh_->processes->rank())
                 make([&](const T &value) { own.push_back(value); });
               return own;
             }))
          for (const T &value : values)
            take(value);
    }
    /// A field, of what the own cells of every process add at their unknowns.
    Eigen::VectorXd sum(Eigen::VectorXd of_own_cells) const
    {
      return shared_fields_ ? shared_fields_->sum(std::move(of_own_cells)) : of_own_cells;
    }
    /// By cell: the sum of what every process has for its own cells and those around them.
    Eigen::VectorXd sum_by_cell(Eigen::VectorXd of_process) const;
    /// To which of the processes that share the mesh unknowns belong; null where there are none.
    const SharedDofs *shared_dofs() const { return shared_dofs_.get(); }
    bool is_own(const dealii::types::global_dof_index dof) const
    {
      return !shared_dofs_ || shared_dofs_->process_of(dof) == mesh_->processes->rank();
    }

    Eigen::Index n_dofs() const { return static_cast<Eigen::Index>(dof_handler_.n_dofs()); }
    unsigned int degree() const { return dof_handler_.get_fe().degree; }

    /// Glues sides, on this mesh and those to come. Numbers of unknowns stay.
    void glue(std::vector<GluedSides> sides);
    const std::vector<GluedSides> &glued_sides() const { return glued_; }
    /// u_s - D^-1 (M u_m - E u_e) of every slave unknown of each of the glued_sides(), in its own row; the
    /// other rows are empty.
    const std::vector<Eigen::SparseMatrix<double>> &glue_rows() const { return glue_rows_; }

    /// Whether cells and finer ones have displacements of their own where they share vertices.
    bool has_free_vertices() const;
    bool has_hanging_nodes() const { return has_hanging_nodes_; }
    /// Whether some unknowns are determined by others.
    bool has_constraints() const { return has_constraints_; }
    bool is_constrained(const dealii::types::global_dof_index dof) const { return constrained_[dof]; }
    /// H: a vector with any values of constrained unknowns becomes a field, H u. Their columns are zero, so
    /// that H^T moves their forces to the unknowns that determine them.
    const Eigen::SparseMatrix<double> &expansion() const { return expansion_; }
    /// The same for hanging nodes alone: what it makes of stresses is not carried across glued sides.
    const Eigen::SparseMatrix<double> &hanging_node_expansion() const
    {
      return glued_.empty() ? expansion_ : hanging_expansion_;
    }

    /**
     * Splits and merges the marked cells and carries fields (vectors of all unknowns) over to the new mesh:
     * unchanged where cells are split, by their values at the remaining nodes where cells are merged. Where
     * no mark can be followed, nothing changes. Throws UserError where a curved side makes a new cell too
     * distorted.
     */
    std::vector<Eigen::VectorXd> adapt(const CellMarks &marks, const std::vector<Eigen::VectorXd> &fields);

    /// How many couplings of two sides it has made, on all meshes.
    unsigned int n_mortars() const { return n_mortars_; }

    /// How many meshes the space has been on.
    unsigned int n_meshes() const { return n_meshes_; }

    /// Gauss rule for the cells, exact for polynomials of degree 2 p + 1 (per direction on quadrilaterals).
    const dealii::Quadrature<2> &quadrature() const { return quadrature_; }

    /// The ids of all sides. Found when first asked for, and kept until the mesh changes.
    const std::vector<dealii::types::boundary_id> &boundary_ids() const;
    /**
     * A side as a curve. On curved bodies its geometry is a polynomial of degree 4 on each edge whatever the
     * degree of the space, so that gaps are those of the bodies and not of their chords. Made when it is
     * first asked for, and kept until the mesh changes.
     */
    const Trace &trace(dealii::types::boundary_id boundary) const;

  private:
    /// Numbers the unknowns of the present mesh.
    void distribute();
    /// Among the processes of the mesh.
    void share_dofs();
    /// Those of hanging nodes on the others.
    dealii::AffineConstraints<double> hanging_nodes() const;
    /// Finds those that others determine.
    void constrain();
    /// By mortar, in place of hanging nodes.
    void join_seams(dealii::AffineConstraints<double> &constraints);

    std::unique_ptr<BodyMesh> mesh_;
    std::unique_ptr<dealii::Mapping<2>> mapping_;
    std::unique_ptr<dealii::FiniteElement<2>> element_;
    dealii::DoFHandler<2> dof_handler_;
    dealii::Quadrature<2> quadrature_;
    std::unique_ptr<SharedDofs> shared_dofs_;     // where processes share the mesh
    std::unique_ptr<SharedFields> shared_fields_; // there too
    std::vector<GluedSides> glued_;
    JointDescription joints_;
    std::vector<bool> constrained_;
    bool has_hanging_nodes_ = false, has_constraints_ = false;
    unsigned int n_meshes_ = 0, n_mortars_ = 0;
    Eigen::SparseMatrix<double> expansion_;
    Eigen::SparseMatrix<double> hanging_expansion_; // of glued bodies
    std::vector<Eigen::SparseMatrix<double>> glue_rows_;
    mutable std::mutex sides_mutex_; // of what follows
    mutable std::vector<dealii::types::boundary_id> boundary_ids_;
    mutable std::map<dealii::types::boundary_id, Trace> traces_;
  };

  /// Gauss rule with n points in each direction of a quadrilateral; for triangles the one of like accuracy.
  dealii::Quadrature<2> gauss_rule(const Space &space, unsigned int n_points);

  /// grad u at a quadrature point; `values` have to show shape gradients.
  Eigen::Matrix2d gradient_at(const dealii::FEValuesBase<2> &values, unsigned int point,
                              const std::vector<dealii::types::global_dof_index> &dofs,
                              const Eigen::VectorXd &displacement);

  /// Receives a quadrature point, its weight (area) and grad u there.
  using GradientVisitor = std::function<void(const Vector2 &point, double weight, const Vector2 &displacement,
                                             const Eigen::Matrix2d &gradient)>;

  /// Visits the quadrature points of all own cells, in their order, with the displacement's value and
  /// gradient.
  void visit_gradients(const Space &space, const dealii::Quadrature<2> &quadrature,
                       const Eigen::VectorXd &displacement, const GradientVisitor &visitor);
} // namespace abut
