// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/mesh/circle.h>

#include <deal.II/grid/manifold_lib.h>

#include <cmath>

namespace abut
{
  Vector2 quarter_circle(const unsigned int k, const unsigned int n)
  {
    Assert(n > 0 && k <= n, dealii::ExcMessage("a point of a quarter circle is one of n + 1"));
    if (2 * k > n)
      return quarter_circle(n - k, n).reverse();
    if (2 * k == n)
      return Vector2::Constant(std::sqrt(0.5));
    const double angle = std::acos(0.) * k / n;
    return Vector2(std::cos(angle), std::sin(angle));
  }

  namespace
  {
    constexpr dealii::types::manifold_id circle_id = 0;

    dealii::SphericalManifold<2> placed_circle(const BodyDescription &body)
    {
      const Vector2 centre = body.placement.point_to_world(Vector2::Zero());
      return dealii::SphericalManifold<2>(dealii::Point<2>(centre.x(), centre.y()));
    }
  } // namespace

  void attach_outer_circle(dealii::Triangulation<2> &triangulation, const BodyDescription &body)
  {
    constexpr dealii::types::boundary_id outer = 0;
    triangulation.set_all_manifold_ids_on_boundary(outer, circle_id);
    triangulation.set_manifold(circle_id, placed_circle(body));
  }

  void attach_polar_coordinates(dealii::Triangulation<2> &triangulation, const BodyDescription &body)
  {
    triangulation.set_all_manifold_ids(circle_id);
    triangulation.set_manifold(circle_id, placed_circle(body));
  }
} // namespace abut
