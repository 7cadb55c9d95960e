// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/mesh/circle.h>

#include <deal.II/grid/manifold_lib.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

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

    /// SphericalManifold takes points nearer than a fixed length for one. Here that length is one of the
    /// body, whatever its units: points are divided by a power of two, which rounds nothing.
    class ScaledCircle : public dealii::SphericalManifold<2>
    {
    public:
      ScaledCircle(const dealii::Point<2> &centre, const double unit)
          : dealii::SphericalManifold<2>(centre), unit_(unit), scaled_(dealii::Point<2>(centre / unit))
      {}

      std::unique_ptr<dealii::Manifold<2>> clone() const override
      {
        return std::make_unique<ScaledCircle>(center, unit_);
      }
      dealii::Point<2> get_intermediate_point(const dealii::Point<2> &first, const dealii::Point<2> &second,
                                              const double share) const override
      {
        return scaled_.get_intermediate_point(first / unit_, second / unit_, share) * unit_;
      }
      dealii::Tensor<1, 2> get_tangent_vector(const dealii::Point<2> &first,
                                              const dealii::Point<2> &second) const override
      {
        return scaled_.get_tangent_vector(first / unit_, second / unit_) * unit_;
      }
      dealii::Point<2> get_new_point(const dealii::ArrayView<const dealii::Point<2>> &points,
                                     const dealii::ArrayView<const double> &weights) const override
      {
        const std::vector<dealii::Point<2>> scaled = scale(points);
        return scaled_.get_new_point(dealii::make_array_view(scaled), weights) * unit_;
      }
      void get_new_points(const dealii::ArrayView<const dealii::Point<2>> &points,
                          const dealii::Table<2, double> &weights,
                          dealii::ArrayView<dealii::Point<2>> new_points) const override
      {
        const std::vector<dealii::Point<2>> scaled = scale(points);
        scaled_.get_new_points(dealii::make_array_view(scaled), weights, new_points);
        for (dealii::Point<2> &point : new_points)
          point *= unit_;
      }

    private:
      std::vector<dealii::Point<2>> scale(const dealii::ArrayView<const dealii::Point<2>> &points) const
      {
        std::vector<dealii::Point<2>> scaled(points.begin(), points.end());
        for (dealii::Point<2> &point : scaled)
          point /= unit_;
        return scaled;
      }

      double unit_;
      dealii::SphericalManifold<2> scaled_;
    };

    ScaledCircle placed_circle(const dealii::Triangulation<2> &triangulation, const BodyDescription &body)
    {
      const Vector2 place = body.placement.point_to_world(Vector2::Zero());
      const dealii::Point<2> centre(place.x(), place.y());
      double radius = 0.;
      for (const dealii::Point<2> &vertex : triangulation.get_vertices())
        radius = std::max(radius, vertex.distance(centre));
      return {centre, std::exp2(std::ilogb(radius))};
    }
  } // namespace

  void attach_outer_circle(dealii::Triangulation<2> &triangulation, const BodyDescription &body)
  {
    constexpr dealii::types::boundary_id outer = 0;
    triangulation.set_all_manifold_ids_on_boundary(outer, circle_id);
    triangulation.set_manifold(circle_id, placed_circle(triangulation, body));
  }

  void attach_polar_coordinates(dealii::Triangulation<2> &triangulation, const BodyDescription &body)
  {
    triangulation.set_all_manifold_ids(circle_id);
    triangulation.set_manifold(circle_id, placed_circle(triangulation, body));
  }
} // namespace abut
