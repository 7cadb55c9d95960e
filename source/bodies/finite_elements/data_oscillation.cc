// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/plane_geometry.h>
#include <abut/bodies/finite_elements/body_force.h>
#include <abut/bodies/finite_elements/cell_materials.h>
#include <abut/bodies/finite_elements/data_oscillation.h>
#include <abut/bodies/prescribed.h>
#include <abut/bodies/side_load.h>

#include <Eigen/Cholesky>

#include <cmath>
#include <vector>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    /// Squared energy norm of a half-plane, for a unit of the integral of squares, under a traction or a
    /// displacement of its side in waves of a given length.
    double energy_of_waves(const Condition &condition, const Material &material, const double length)
    {
      const double compliance =
          length / (2. * M_PI) * 2. * (1. - std::pow(material.poisson_ratio, 2)) / material.young_modulus;
      return is_support(condition.kind) ? 1. / compliance : compliance;
    }

    /// Midpoints of 2^k intervals of a segment: 2048 on the side, 16 on the segment at least.
    Eigen::VectorXd sampled_places(const Trace &side, const Segment &segment)
    {
      Index n = 16;
      while (static_cast<double>(n) * side.length() < 2048. * segment.length)
        n *= 2;
      const double size = 1. / static_cast<double>(n);
      return Eigen::VectorXd::LinSpaced(n, .5 * size, 1. - .5 * size);
    }

    Eigen::MatrixX2d values_at(const Condition &condition, const Placement &placement, const Trace &side,
                               const Segment &segment, const Eigen::VectorXd &places)
    {
      Eigen::MatrixX2d values(places.size(), 2);
      for (Index i = 0; i < places.size(); ++i)
      {
        const Vector2 point = side.point(segment, places[i]),
                      normal = outward_normal(side.tangent(segment, places[i]));
        values.row(i) = is_support(condition.kind)
                            ? prescribed_displacement(condition, placement, point, normal).transpose()
                            : prescribed_traction(condition, placement, point, normal).transpose();
      }
      return values;
    }

    /// What is left of the values at `places` of a segment: of displacements without what the nodes
    /// interpolate, of tractions without the projection on polynomials.
    Eigen::MatrixX2d remainder(const Condition &condition, const Placement &placement, const Trace &side,
                               const Segment &segment, const Eigen::VectorXd &places)
    {
      const Eigen::MatrixX2d values = values_at(condition, placement, side, segment, places);
      const LagrangeBasis &polynomials = side.basis();
      Eigen::MatrixXd basis(places.size(), polynomials.nodes().size());
      for (Index i = 0; i < places.size(); ++i)
        basis.row(i) = polynomials.values(places[i]).transpose();
      if (is_support(condition.kind))
        return values - basis * values_at(condition, placement, side, segment, polynomials.nodes());
      return values - basis * (basis.transpose() * basis).llt().solve(basis.transpose() * values);
    }

    /// By Haar's basis: the difference between the means of two halves is a wave as long as both together.
    double energy_of_remainder(const Condition &condition, const Material &material, Eigen::MatrixX2d means,
                               const double length)
    {
      double energy = 0.;
      while (means.rows() > 1)
      {
        const Index n = means.rows() / 2;
        const double wave = length / static_cast<double>(n);
        Eigen::MatrixX2d of_both(n, 2);
        double square = 0.;
        for (Index i = 0; i < n; ++i)
        {
          square += wave * (.5 * (means.row(2 * i) - means.row(2 * i + 1))).squaredNorm();
          of_both.row(i) = .5 * (means.row(2 * i) + means.row(2 * i + 1));
        }
        energy += energy_of_waves(condition, material, wave) * square;
        means = of_both;
      }
      return energy + energy_of_waves(condition, material, length) * length * means.squaredNorm();
    }

    /// Squared energy norm of a plane under forces in shear waves twice as long as a cell, for a unit of the
    /// integral of squares.
    double energy_of_cell_waves(const Material &material, const double diameter)
    {
      const double size = std::sqrt(.5) * diameter;
      return std::pow(size / M_PI, 2) / material.mu();
    }

    std::vector<Material> materials_of_cells(const Space &space, const CellMaterials &materials)
    {
      std::vector<Material> by_index;
      for (const auto &cell : space.own_cells())
        by_index.push_back(materials(cell));
      return space.gathered(std::move(by_index));
    }

    std::vector<double> diameters_of_cells(const Space &space)
    {
      std::vector<double> diameters;
      for (const auto &cell : space.own_cells())
        diameters.push_back(cell->diameter());
      return space.gathered(std::move(diameters));
    }
  } // namespace

  Eigen::VectorXd data_oscillation(const FiniteElementBody &body, const Sides &sides)
  {
    const Space &space = body.space();
    const std::vector<Material> materials = materials_of_cells(space, CellMaterials(body.description()));
    Eigen::VectorXd squares = Eigen::VectorXd::Zero(static_cast<Index>(materials.size()));
    for (const Condition &condition : body.description().conditions)
    {
      if (condition.point || condition.kind == ConditionKind::resultant || !varies(condition))
        continue;
      const Trace &side = sides.at(condition.boundary);
      for (const Segment &segment : side.segments())
        squares[segment.cell] += energy_of_remainder(
            condition, materials[segment.cell],
            remainder(condition, body.description().placement, side, segment, sampled_places(side, segment)),
            segment.length);
    }
    if (const Eigen::VectorXd force = body_force_oscillation(space, body.description()); force.size() > 0)
    {
      const std::vector<double> diameters = diameters_of_cells(space);
      for (std::size_t cell = 0; cell < diameters.size(); ++cell)
        squares[static_cast<Index>(cell)] +=
            energy_of_cell_waves(materials[cell], diameters[cell]) * force[static_cast<Index>(cell)];
    }
    return squares.cwiseSqrt();
  }
} // namespace abut
