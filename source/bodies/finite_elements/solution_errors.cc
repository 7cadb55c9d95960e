// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Errors of a body's solution that no estimator of the discretisation sees.

#include <abut/bodies/finite_elements/data_oscillation.h>
#include <abut/bodies/finite_elements/finite_element_body.h>
#include <abut/bodies/finite_elements/stress_field.h>
#include <abut/scene/shape_entry.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_tools.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace abut
{
  double FiniteElementBody::round_off_energy(const Eigen::VectorXd &deformation,
                                             const Eigen::VectorXd &contact_forces) const
  {
    const Eigen::VectorXd residual =
        -supports_.free_directions.transpose() * missing_forces(deformation, contact_forces);
    return std::abs(residual.dot(solve(residual).col(0)));
  }

  Eigen::VectorXd FiniteElementBody::data_oscillation() const
  {
    return abut::data_oscillation(*this, sides_);
  }

  namespace
  {
    /// Squared energy of a half-plane under the tractions sigma alpha on an edge of length
    /// h, where alpha, the angle between curve and edge, goes through zero in the middle: waves of length h.
    double wave_energy(const double square, const double length, const Material &material)
    {
      return 2. * square * length / (2. * M_PI) * (1. - std::pow(material.poisson_ratio, 2)) /
             material.young_modulus;
    }
  } // namespace

  double FiniteElementBody::lost_area() const
  {
    if (!space_->mesh().curved)
      return 0.;
    const bool triangles = space_->mesh().cell_type == CellType::triangles;
    const auto curve = space_->mesh().mapping(triangles ? 2 : space_->degree() + 2);
    // GridTools adds up what all processes have that share a mesh.
    const double exact = dealii::GridTools::volume(space_->mesh().triangulation, *curve);
    return 1. - dealii::GridTools::volume(space_->mesh().triangulation, space_->mapping()) / exact;
  }

  double FiniteElementBody::geometry_energy(const Eigen::VectorXd &deformation) const
  {
    if (description().has_inner_interfaces())
      return std::numeric_limits<double>::quiet_NaN(); // edges between materials may stand for curves too
    const bool triangles = space_->mesh().cell_type == CellType::triangles;
    if (!space_->mesh().curved)
      return triangles && shape_of(description()).has_curves ? std::numeric_limits<double>::quiet_NaN() : 0.;
    const unsigned int finer = triangles ? 2 : space_->degree() + 2;
    const auto curve = space_->mesh().mapping(finer);
    const dealii::QGauss<1> rule(space_->degree() + 2);
    const auto flags = dealii::update_gradients | dealii::update_JxW_values |
                       dealii::update_quadrature_points | dealii::update_normal_vectors;
    const auto &element = space_->dof_handler().get_fe();
    dealii::FEFaceValues<2> edge(space_->mapping(), element, rule, flags);
    dealii::FEFaceValues<2> exact(*curve, element, rule, dealii::update_normal_vectors);
    const StressField field(*this, deformation);
    const CellMaterials materials(description());
    std::vector<dealii::types::global_dof_index> dofs(element.n_dofs_per_cell());
    double energy = 0.;
    for (const auto &cell : space_->own_cells())
      for (const unsigned int f : cell->face_indices())
      {
        if (!cell->at_boundary(f))
          continue;
        edge.reinit(cell, f);
        exact.reinit(cell, f);
        cell->get_dof_indices(dofs);
        double square = 0.;
        for (const unsigned int q : edge.quadrature_point_indices())
        {
          const Stress stress = field.at(cell, edge, q, dofs);
          const Vector2 normal(edge.normal_vector(q)[0], edge.normal_vector(q)[1]);
          const auto turn = exact.normal_vector(q) - edge.normal_vector(q);
          const double across = stress.xx * normal.x() * normal.x() + stress.yy * normal.y() * normal.y() +
                                2. * stress.xy * normal.x() * normal.y();
          const double along = stress.xx + stress.yy - across;
          square += std::pow(along - across, 2) * turn.norm_square() * edge.JxW(q);
        }
        energy += wave_energy(square, cell->face(f)->measure(), materials(cell));
      }
    const std::vector<double> parts = space_->gathered<double>({energy});
    return std::accumulate(parts.begin(), parts.end(), 0.);
  }
} // namespace abut
