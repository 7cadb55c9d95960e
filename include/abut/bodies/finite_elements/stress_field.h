// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/finite_elements/cell_materials.h>
#include <abut/bodies/finite_elements/finite_element_body.h>
#include <abut/bodies/finite_elements/projected_divergence.h>

namespace abut
{
  /// Receives a quadrature point, its weight (area) and the stress there.
  using PointStressVisitor = std::function<void(const Vector2 &point, double weight, const Stress &stress)>;

  /**
   * sigma_F, the stress of a body's finite elements: sigma = lambda d I + 2 mu eps(u) in the plane, where d
   * is div u, or its projection where the stiffness takes that (projects_divergence). So it balances the
   * loads in the sense of the finite elements, int sigma : eps(v) = l(v), either way - but for the
   * checkerboard that Q1/P0 adds to its pressure, for it is not inf-sup stable: that is left out of d (see
   * checkerboard).
   */
  class StressField
  {
  public:
    /// `deformation`: all unknowns, less the rigid motion. It and the body must outlive the object.
    StressField(const FiniteElementBody &body, const Eigen::VectorXd &deformation);

    /// At a point of a cell where grad u is known. World frame: point, gradient and stress.
    Stress at(const Cell &cell, const Vector2 &point, const Eigen::Matrix2d &gradient) const;
    /// At a quadrature point; `values` have to show shape gradients and points, `dofs` are the cell's.
    Stress at(const Cell &cell, const dealii::FEValuesBase<2> &values, unsigned int point,
              const std::vector<dealii::types::global_dof_index> &dofs) const;

    /// grad d at a quadrature point, per length; `values` have to show shape Hessians and points.
    Vector2 divergence_gradient(const Cell &cell, const dealii::FEValuesBase<2> &values, unsigned int point,
                                const std::vector<dealii::types::global_dof_index> &dofs) const;

    /// The quadrature points of all own cells, in their order.
    void visit(const dealii::Quadrature<2> &quadrature, const PointStressVisitor &visitor) const;

  private:
    bool projects() const { return divergence_.size() > 0; }
    CellPolynomials polynomials(const Cell &cell) const { return {cell, space_.degree() - 1}; }
    void project();

    const Space &space_;
    const CellMaterials materials_;
    const Eigen::VectorXd &deformation_;
    Eigen::MatrixXd divergence_; // d, a column for every cell; empty without projection
  };
} // namespace abut
