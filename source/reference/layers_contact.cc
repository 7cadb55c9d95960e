// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/reference/contact_pressure.h>
#include <abut/reference/contact_width.h>
#include <abut/reference/layers_contact.h>

#include <Eigen/LU>
#include <boost/math/constants/constants.hpp>

#include <cmath>

namespace abut
{
  namespace
  {
    constexpr double layers_contact_pi = boost::math::constants::pi<double>();

    // The unknowns are the coefficients and the approach without its uniform part, which would spoil the
    // condition of the system in thick layers.
    ContactForWidth collocate(const LayersContactData &data, const SineBasis &basis)
    {
      const Eigen::Index n = basis.size();
      const double a = basis.half_width();
      const auto point = [&](Eigen::Index i) {
        return a * std::cos(double(2 * i + 1) * layers_contact_pi / double(4 * (n + 1)));
      };
      const Eigen::VectorXd x = Eigen::VectorXd::NullaryExpr(n + 1, point);
      const double compliance = half_plane_compliance(data);
      Eigen::MatrixXd matrix(n + 1, n + 1);
      matrix.leftCols(n) = wave_displacement(data, basis, x) / (a * compliance); // free of units
      matrix.col(n).setConstant(-1.);
      const Eigen::VectorXd gap = data.gap_curvature / a * x.array().square();
      const Eigen::VectorXd solution = matrix.partialPivLu().solve(-gap);
      const Eigen::VectorXd coefficients = solution.head(n) / compliance;
      const double mean_pressure = (basis.modes(0) * coefficients)(0);
      return {coefficients, solution(n) * a + uniform_compliance(data) * mean_pressure};
    }

    PressureBetween solve_layers_contact(const LayersContactData &data)
    {
      for (Eigen::Index n = 16; n <= 256; n *= 2)
      {
        const auto approach_of = [&](double a) {
          return collocate(data, SineBasis(a, data.length, n)).approach;
        };
        const SineBasis basis(find_half_width(data, approach_of), data.length, n);
        const Eigen::VectorXd c = collocate(data, basis).coefficients;
        if (c.tail(3).cwiseAbs().maxCoeff() <= 1e-13 * c.cwiseAbs().maxCoeff())
          return {data, basis.half_width(), std::make_shared<const ContactPressure>(basis, c)};
      }
      throw ComputationError(
          "The exact contact pressure of the two layers is not resolved by 256 coefficients; "
          "take thicker layers or a narrower contact.");
    }
  } // namespace

  LayersContact::LayersContact(const LayersContactData &data)
      : PressedLayers(solve_layers_contact(with_finite_length(data)))
  {}
} // namespace abut
