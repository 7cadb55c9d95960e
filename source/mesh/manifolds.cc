// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/mesh/manifolds.h>

#include <deal.II/grid/manifold.h>
#include <deal.II/grid/manifold_lib.h>

namespace abut
{
  namespace
  {
    dealii::Point<2> to_dealii(const Vector2 &point)
    {
      return dealii::Point<2>(point.x(), point.y());
    }

    /// The chart (X, t) -> world image of the own-frame point (X, t Top(X)).
    class CurvedTopManifold : public dealii::ChartManifold<2, 2>
    {
    public:
      CurvedTopManifold(const Expression &top, const Placement &placement) : top_(top), placement_(placement)
      {}

      std::unique_ptr<dealii::Manifold<2, 2>> clone() const override
      {
        return std::make_unique<CurvedTopManifold>(top_, placement_);
      }

      dealii::Point<2> pull_back(const dealii::Point<2> &space_point) const override
      {
        const Vector2 own = placement_.point_to_own(Vector2(space_point[0], space_point[1]));
        return dealii::Point<2>(own.x(), own.y() / height(own.x()));
      }

      dealii::Point<2> push_forward(const dealii::Point<2> &chart_point) const override
      {
        const Vector2 own(chart_point[0], chart_point[1] * height(chart_point[0]));
        return to_dealii(placement_.point_to_world(own));
      }

    private:
      double height(const double x) const { return top_(Vector2(x, 0.)); }

      Expression top_;
      Placement placement_;
    };
  } // namespace

  void attach_manifolds(dealii::Triangulation<2> &triangulation, const BodyDescription &body)
  {
    constexpr dealii::types::manifold_id id = 0;
    const dealii::SphericalManifold<2> circle(to_dealii(body.placement.point_to_world(Vector2::Zero())));
    switch (body.shape)
    {
    case Shape::rectangle:
    case Shape::l_shape:
    case Shape::mesh_file:
      return;
    case Shape::rectangle_curved_top:
      triangulation.set_all_manifold_ids(id);
      triangulation.set_manifold(id, CurvedTopManifold(*body.top, body.placement));
      return;
    case Shape::ring:
    case Shape::quarter_ring:
      triangulation.set_all_manifold_ids(id);
      triangulation.set_manifold(id, circle);
      return;
    case Shape::disc:
    case Shape::half_disc:
    case Shape::quarter_disc:
      constexpr dealii::types::boundary_id outer = 0; // the first side of these shapes
      triangulation.set_all_manifold_ids_on_boundary(outer, id);
      triangulation.set_manifold(id, circle);
    }
  }
} // namespace abut
