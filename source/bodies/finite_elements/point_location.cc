// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bodies/finite_elements/point_location.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>

namespace abut
{
  namespace
  {
    /// How far a place is known, which is given by coordinates.
    double round_off_of(const dealii::Point<2> &place)
    {
      return 4. * std::numeric_limits<double>::epsilon() * place.norm();
    }

    /// Whether a point may lie in a cell, whose edges bend by half its size at most.
    bool may_contain(const Cell &cell, const dealii::Point<2> &place)
    {
      const dealii::BoundingBox<2> box = cell->bounding_box();
      const auto &[low, high] = box.get_boundary_points();
      return box.center().distance(place) <= low.distance(high);
    }

    /// By Newton's method; nothing where that leads away from the cell.
    std::optional<dealii::Point<2>> unit_point(const Space &space, const Cell &cell,
                                               const dealii::Point<2> &place)
    {
      constexpr int most_steps = 30;
      constexpr double accuracy = 1e-10, far = 3.; // of a cell; the last step makes much less of it
      const double close = accuracy * cell->diameter() + round_off_of(place);
      dealii::Point<2> unit = cell->reference_cell().barycenter<2>();
      for (int step = 0; step < most_steps; ++step)
      {
        dealii::FEValues<2> values(space.mapping(), space.dof_handler().get_fe(), dealii::Quadrature<2>(unit),
                                   dealii::update_quadrature_points | dealii::update_inverse_jacobians);
        values.reinit(cell);
        const dealii::Tensor<1, 2> miss = place - values.quadrature_point(0);
        unit += dealii::apply_transformation(values.inverse_jacobian(0), miss);
        if (miss.norm() <= close)
          return unit;
        if (!(unit.norm() < far))
          return {};
      }
      return {};
    }
  } // namespace

  std::vector<LocatedPoint> locate(const Space &space, const Vector2 &place)
  {
    constexpr double round_off = 1e-8, off_the_curve = .05; // of a cell
    const dealii::Point<2> point(place.x(), place.y());
    std::vector<LocatedPoint> near;
    for (const auto &cell : space.own_cells())
      if (may_contain(cell, point))
        if (const auto unit = unit_point(space, cell, point))
          near.push_back({cell, *unit});
    const auto within = [&](const double tolerance) {
      std::vector<LocatedPoint> found;
      std::copy_if(near.begin(), near.end(), std::back_inserter(found), [&](const LocatedPoint &located) {
        return located.cell->reference_cell().contains_point(
            located.unit, tolerance + round_off_of(point) / located.cell->minimum_vertex_distance());
      });
      return found;
    };
    std::vector<LocatedPoint> found = within(round_off);
    if (space.mesh().curved && !in_any(space.mesh().processes, !found.empty()))
      return within(off_the_curve);
    return found;
  }
} // namespace abut
