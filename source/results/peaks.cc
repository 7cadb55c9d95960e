// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bodies/finite_elements/stress_field.h>
#include <abut/results/peaks.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_simplex_p.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace abut
{
  namespace
  {
    constexpr double near_share = .01; // of the body's diagonal

    /// The principal strain of the largest size, of a displacement gradient.
    double largest_strain(const Eigen::Matrix2d &gradient)
    {
      const double mean = .5 * gradient.trace();
      const double radius =
          std::hypot(.5 * (gradient(0, 0) - gradient(1, 1)), .5 * (gradient(0, 1) + gradient(1, 0)));
      return std::abs(mean) + radius;
    }

    /// Keeps the largest values of points that are visited cell by cell.
    class PeakFinder
    {
    public:
      explicit PeakFinder(const std::size_t points_per_cell) : points_per_cell_(points_per_cell) {}

      void next(const Vector2 &place)
      {
        place_ = place;
        cell_ = static_cast<unsigned int>(visited_++ / points_per_cell_);
      }
      void restart() { visited_ = 0; }
      void raise(Peak &peak, const double value) const
      {
        if (!(value <= peak.value)) // NaN is raised too
          peak = {value, place_, cell_};
      }

    private:
      std::size_t points_per_cell_, visited_ = 0;
      Vector2 place_ = Vector2::Zero();
      unsigned int cell_ = 0;
    };
  } // namespace

  dealii::Quadrature<2> output_points(const Space &space)
  {
    if (space.mesh().cell_type == CellType::triangles)
      return dealii::Quadrature<2>(dealii::FE_SimplexP<2>(space.degree()).get_unit_support_points());
    return dealii::QIterated<2>(dealii::QTrapezoid<1>(), space.degree());
  }

  BodyPeaks find_peaks(const Body &body, const Eigen::VectorXd &displacement,
                       const Eigen::VectorXd &deformation, const std::vector<Vector2> &singular_vertices)
  {
    const Space &space = body.space();
    BodyPeaks peaks;
    PeakFinder at_output_points(output_points(space).size()), at_gauss_points(space.quadrature().size());
    Vector2 low = Vector2::Constant(std::numeric_limits<double>::infinity()), high = -low;
    visit_gradients(space, output_points(space), displacement,
                    [&](const Vector2 &place, double, const Vector2 &u, const Eigen::Matrix2d &) {
                      at_output_points.next(place);
                      at_output_points.raise(peaks.displacement, u.norm());
                      low = low.cwiseMin(place);
                      high = high.cwiseMax(place);
                    });
    const double near = near_share * (high - low).norm();
    const auto is_regular = [&](const Vector2 &place) {
      return std::none_of(singular_vertices.begin(), singular_vertices.end(),
                          [&](const Vector2 &vertex) { return (place - vertex).norm() < near; });
    };
    at_output_points.restart();
    StressField(body, deformation)
        .visit(output_points(space), [&](const Vector2 &place, double, const Stress &stress) {
          at_output_points.next(place);
          at_output_points.raise(peaks.von_mises, stress.von_mises());
          if (is_regular(place))
            at_output_points.raise(peaks.regular_von_mises, stress.von_mises());
        });
    visit_gradients(space, space.quadrature(), deformation,
                    [&](const Vector2 &place, double, const Vector2 &, const Eigen::Matrix2d &gradient) {
                      const double strain = largest_strain(gradient);
                      at_gauss_points.next(place);
                      at_gauss_points.raise(peaks.strain, strain);
                      if (is_regular(place))
                        at_gauss_points.raise(peaks.regular_strain, strain);
                    });
    return peaks;
  }
} // namespace abut
