// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/reference/contact_width.h>
#include <abut/reference/penalised_layers_contact.h>
#include <abut/reference/spline_basis.h>

#include <Eigen/LU>

#include <cmath>
#include <limits>
#include <sstream>

namespace abut
{
  namespace
  {
    // The unknowns are the coefficients and the approach without its uniform part, as for LayersContact.
    ContactForWidth minimise_penalised(const LayersContactData &data, const double penalty,
                                       const SplineBasis &basis)
    {
      const Eigen::Index n = basis.size();
      const double a = basis.half_width();
      const double compliance = half_plane_compliance(data) + penalty / a;
      const Eigen::VectorXd &x = basis.nodes();
      const Eigen::MatrixXd test = basis.quadrature().transpose();
      const Eigen::MatrixXd displacement = wave_displacement(data, basis, x) + penalty * basis.node_values();
      Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n + 1, n + 1);
      matrix.topLeftCorner(n, n) = test * displacement / (a * compliance); // free of units but for a length
      matrix.col(n).head(n) = -test.rowwise().sum();
      matrix(n, n - 1) = a; // no pressure at the edge
      Eigen::VectorXd gap = Eigen::VectorXd::Zero(n + 1);
      gap.head(n) = test * (data.gap_curvature / a * x.array().square()).matrix();
      const Eigen::VectorXd solution = matrix.partialPivLu().solve(-gap);
      const Eigen::VectorXd coefficients = solution.head(n) / compliance;
      const double mean_pressure = (basis.modes(0) * coefficients)(0);
      return {coefficients, solution(n) * a + uniform_compliance(data) * mean_pressure};
    }

    // The minimum is -(1/2) int p (Delta - r0 x^2) dx.
    double penalised_minimum(const LayersContactData &data, const SplineBasis &basis,
                             const Eigen::VectorXd &coefficients)
    {
      const Eigen::VectorXd overlap = data.approach - data.gap_curvature * basis.nodes().array().square();
      return -0.5 * overlap.dot(basis.quadrature() * coefficients);
    }

    void check_penalty(const double penalty)
    {
      if (penalty > 0. && std::isfinite(penalty))
        return;
      std::ostringstream message;
      message << "The contact of the layers has the penalty " << penalty << ", which must be positive.";
      throw UserError(message.str());
    }

    PressureBetween solve_penalised_contact(const LayersContactData &data, const double penalty)
    {
      check_penalty(penalty);
      double half_width = 0., previous = std::numeric_limits<double>::infinity();
      for (Eigen::Index n = 8; n <= 128; n *= 2)
      {
        const auto approach_of = [&](double a) {
          return minimise_penalised(data, penalty, SplineBasis(a, data.length, n)).approach;
        };
        half_width =
            n == 8 ? find_half_width(data, approach_of) : find_half_width_near(half_width, data, approach_of);
        const SplineBasis basis(half_width, data.length, n);
        const Eigen::VectorXd c = minimise_penalised(data, penalty, basis).coefficients;
        const double minimum = penalised_minimum(data, basis, c);
        if (std::abs(minimum - previous) <= 1e-11 * std::abs(minimum))
          return {data, half_width, std::make_shared<const PiecewisePressure>(basis.pressure(c))};
        previous = minimum;
      }
      throw ComputationError("The pressure of the two layers with the penalty is not resolved by 128 pieces; "
                             "take thicker layers or a narrower contact.");
    }
  } // namespace

  PenalisedLayersContact::PenalisedLayersContact(const LayersContactData &data, const double penalty)
      : PressedLayers(solve_penalised_contact(with_finite_length(data), penalty)), penalty_(penalty)
  {}
} // namespace abut
