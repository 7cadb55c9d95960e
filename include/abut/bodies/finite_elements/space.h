// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/material.h>
#include <abut/mesh/body_mesh.h>
#include <abut/mesh/cell_marks.h>
#include <abut/scene/body_description.h>
#include <abut/trace/trace.h>

#include <deal.II/base/quadrature.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping.h>

#include <Eigen/SparseCore>

#include <functional>
#include <memory>

namespace abut
{
  using Cell = dealii::DoFHandler<2>::active_cell_iterator;

  /**
   * The finite-element space of one body: vector-valued Lagrange elements of degree p on its mesh,
   * isoparametric on curved bodies. Owns the mesh. Where cells meet finer ones, the unknowns at hanging nodes
   * are determined by the others, so that fields are continuous.
   */
  class Space
  {
  public:
    Space(std::unique_ptr<BodyMesh> mesh, unsigned int degree);
    ~Space();

    const BodyMesh &mesh() const { return *mesh_; }
    const dealii::Mapping<2> &mapping() const { return *mapping_; }
    const dealii::DoFHandler<2> &dof_handler() const { return dof_handler_; }
    Eigen::Index n_dofs() const { return static_cast<Eigen::Index>(dof_handler_.n_dofs()); }
    unsigned int degree() const { return dof_handler_.get_fe().degree; }

    bool has_hanging_nodes() const { return has_hanging_nodes_; }
    /// Whether an unknown is determined by others.
    bool is_hanging(const dealii::types::global_dof_index dof) const { return hanging_[dof]; }
    /// H: a vector with any values at hanging nodes becomes a field, H u. The columns of hanging nodes are
    /// zero, so that H^T moves their forces to the nodes that determine them.
    const Eigen::SparseMatrix<double> &hanging_node_expansion() const { return expansion_; }

    /**
     * Splits and merges the marked cells and carries fields (vectors of all unknowns) over to the new mesh:
     * unchanged where cells are split, by their values at the remaining nodes where cells are merged. Where
     * no mark can be followed, nothing changes. Throws UserError where a curved side makes a new cell too
     * distorted.
     */
    std::vector<Eigen::VectorXd> adapt(const CellMarks &marks, const std::vector<Eigen::VectorXd> &fields);

    /// How many meshes the space has been on.
    unsigned int n_meshes() const { return n_meshes_; }

    /// Gauss rule for the cells, exact for polynomials of degree 2 p + 1 (per direction on quadrilaterals).
    const dealii::Quadrature<2> &quadrature() const { return quadrature_; }

    /**
     * A side as a curve. On curved bodies its geometry is a polynomial of degree 4 on each edge whatever the
     * degree of the space, so that gaps are those of the bodies and not of their chords.
     */
    Trace trace(dealii::types::boundary_id boundary) const;

  private:
    /// Numbers the unknowns of the present mesh.
    void distribute();

    std::unique_ptr<BodyMesh> mesh_;
    std::unique_ptr<dealii::Mapping<2>> mapping_;
    std::unique_ptr<dealii::FiniteElement<2>> element_;
    dealii::DoFHandler<2> dof_handler_;
    dealii::Quadrature<2> quadrature_;
    std::vector<bool> hanging_;
    bool has_hanging_nodes_ = false;
    unsigned int n_meshes_ = 0;
    Eigen::SparseMatrix<double> expansion_;
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

  /// Visits the quadrature points of all cells, in their order, with the displacement's value and gradient.
  void visit_gradients(const Space &space, const dealii::Quadrature<2> &quadrature,
                       const Eigen::VectorXd &displacement, const GradientVisitor &visitor);
} // namespace abut
