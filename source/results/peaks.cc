// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/results/peaks.h>

#include <deal.II/base/exceptions.h>

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

    void raise(Peak &peak, const double value, const SamplePoint &point)
    {
      if (!(value <= peak.value)) // NaN is raised too
        peak = {value, point.place, point.cell};
    }
  } // namespace

  BodyPeaks find_peaks(const Body &body, const Eigen::VectorXd &displacement,
                       const Eigen::VectorXd &deformation, const std::vector<Vector2> &singular_vertices)
  {
    AssertDimension(displacement.size(), deformation.size());
    BodyPeaks peaks;
    Vector2 low = Vector2::Constant(std::numeric_limits<double>::infinity()), high = -low;
    body.visit_displacement(displacement, SamplePoints::output,
                            [&](const SamplePoint &point, const Vector2 &u, const Eigen::Matrix2d &) {
                              raise(peaks.displacement, u.norm(), point);
                              low = low.cwiseMin(point.place);
                              high = high.cwiseMax(point.place);
                            });
    const double near = near_share * (high - low).norm();
    const auto is_regular = [&](const Vector2 &place) {
      return std::none_of(singular_vertices.begin(), singular_vertices.end(),
                          [&](const Vector2 &vertex) { return (place - vertex).norm() < near; });
    };
    body.visit_stress(deformation, SamplePoints::output, [&](const SamplePoint &point, const Stress &stress) {
      raise(peaks.von_mises, stress.von_mises(), point);
      if (is_regular(point.place))
        raise(peaks.regular_von_mises, stress.von_mises(), point);
    });
    body.visit_displacement(deformation, SamplePoints::energy,
                            [&](const SamplePoint &point, const Vector2 &, const Eigen::Matrix2d &gradient) {
                              const double strain = largest_strain(gradient);
                              raise(peaks.strain, strain, point);
                              if (is_regular(point.place))
                                raise(peaks.regular_strain, strain, point);
                            });
    return peaks;
  }
} // namespace abut
