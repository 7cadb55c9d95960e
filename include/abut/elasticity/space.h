// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/elasticity/material.h>
#include <abut/mesh/body_mesh.h>
#include <abut/scene/body_description.h>
#include <abut/trace/trace.h>

#include <deal.II/base/quadrature.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping.h>

#include <functional>
#include <memory>

namespace abut
{
  /**
   * The finite-element space of one body: vector-valued Lagrange elements of degree p on its mesh,
   * isoparametric on curved bodies. Owns the mesh.
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

    /// Gauss rule for the cells, exact for polynomials of degree 2 p + 1 (per direction on quadrilaterals).
    const dealii::Quadrature<2> &quadrature() const { return quadrature_; }

    /**
     * A side as a curve. On curved bodies its geometry is a polynomial of degree 4 on each edge whatever the
     * degree of the space, so that gaps are those of the bodies and not of their chords.
     */
    Trace trace(dealii::types::boundary_id boundary) const;

  private:
    std::unique_ptr<BodyMesh> mesh_;
    std::unique_ptr<dealii::Mapping<2>> mapping_;
    dealii::DoFHandler<2> dof_handler_;
    dealii::Quadrature<2> quadrature_;
  };

  /// Receives a quadrature point, its weight (area) and grad u there.
  using GradientVisitor = std::function<void(const Vector2 &point, double weight, const Vector2 &displacement,
                                             const Eigen::Matrix2d &gradient)>;

  /// Visits the quadrature points of all cells, in their order, with the displacement's value and gradient.
  void visit_gradients(const Space &space, const dealii::Quadrature<2> &quadrature,
                       const Eigen::VectorXd &displacement, const GradientVisitor &visitor);
} // namespace abut
