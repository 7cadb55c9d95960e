// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/reference/layers_contact.h>
#include <abut/reference/layers_contact_solve.h>
#include <abut/user_error.h>

#include <Eigen/LU>
#include <boost/math/constants/constants.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace abut
{
  namespace
  {
    constexpr double layers_solve_pi = boost::math::constants::pi<double>();
    constexpr double narrowest_contact = 1e-4; // half-width by length
    constexpr double widest_contact = 0.99;
    constexpr double thinnest_layer = 1. / 400.; // thickness by length

    constexpr double infinite_length = 25.; // beyond the contact, by thickness

    void check_layers_data(const LayersContactData &data)
    {
      data.layers[0].check("The first layer");
      data.layers[1].check("The second layer");
      std::ostringstream message;
      if (data.ends == Layer::Ends::rollers && !(data.length > 0.))
        message << "The layers have the length " << data.length << ", which must be positive.";
      else if (!(data.gap_curvature > 0.))
        message << "The gap between the layers has the curvature " << data.gap_curvature
                << ", which must be positive.";
      else if (!(data.approach > 0.))
        message << "The layers are pressed together by the approach " << data.approach
                << ", which must be positive.";
      if (!message.str().empty())
        throw UserError(message.str());
    }

    void check_thickness(const LayersContactData &data)
    {
      for (const Layer &layer : data.layers)
        if (layer.thickness < thinnest_layer * data.length)
        {
          std::ostringstream message;
          message << "A layer has the thickness " << layer.thickness << ", which must be at least "
                  << thinnest_layer << " of the length " << data.length << " for the exact solution.";
          throw UserError(message.str());
        }
    }

    struct ContactForWidth
    {
      Eigen::VectorXd coefficients; // of the pressure that vanishes at the edge
      double approach;              // at which the contact is that wide
    };

    // The unknowns are the coefficients and the approach without its uniform part, which would spoil the
    // condition of the system in thick layers.
    ContactForWidth solve_for_width(const LayersContactData &data, const SineBasis &basis)
    {
      const Eigen::Index n = basis.size();
      const double a = basis.half_width();
      const auto point = [&](Eigen::Index i) {
        return a * std::cos(double(2 * i + 1) * layers_solve_pi / double(4 * (n + 1)));
      };
      const Eigen::VectorXd x = Eigen::VectorXd::NullaryExpr(n + 1, point);
      Eigen::MatrixXd potential(n + 1, n);
      for (Eigen::Index i = 0; i <= n; ++i)
        potential.row(i) = basis.potential(x(i));

      Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n + 1, n + 1);
      double compliance = 0.;
      double uniform_compliance = 0.;
      for (const Layer &layer : data.layers)
      {
        compliance += layer.half_plane_compliance();
        uniform_compliance += layer.uniform_compliance(data.ends);
        const Eigen::MatrixXd modes = basis.modes(layer.n_thin_modes(data.length));
        matrix.leftCols(n) += layer.wave_displacement(data.length, x, modes, potential);
      }
      matrix.leftCols(n) /= a * compliance; // free of units
      matrix.col(n).setConstant(-1.);
      const Eigen::VectorXd gap = data.gap_curvature / a * x.array().square();
      const Eigen::VectorXd solution = matrix.partialPivLu().solve(-gap);
      const Eigen::VectorXd coefficients = solution.head(n) / compliance;
      const double mean_pressure = (basis.modes(0) * coefficients)(0);
      return {coefficients, solution(n) * a + uniform_compliance * mean_pressure};
    }

    double find_half_width(const LayersContactData &data, const Eigen::Index n)
    {
      const auto excess = [&](double a) {
        return solve_for_width(data, SineBasis(a, data.length, n)).approach / data.approach - 1.;
      };
      const double low = narrowest_contact * data.length;
      const double high = widest_contact * data.length;
      const double at_low = excess(low);
      const double at_high = excess(high);
      if (!(at_low < 0. && at_high > 0.))
      {
        std::ostringstream message;
        message << "The layers are pressed together by the approach " << data.approach
                << ", which must lie between " << (1. + at_low) * data.approach << " and "
                << (1. + at_high) * data.approach << " for a contact on " << narrowest_contact << " to "
                << widest_contact << " of their length " << data.length << ".";
        throw UserError(message.str());
      }
      std::uintmax_t n_iterations = 100;
      const auto bracket = boost::math::tools::toms748_solve(
          excess, low, high, at_low, at_high, boost::math::tools::eps_tolerance<double>(51), n_iterations);
      return 0.5 * (bracket.first + bracket.second);
    }
  } // namespace

  // No contact is wider than that of thin incompressible layers, whose volume under it is kept:
  // Delta - r0 a^2/3 = 0.
  LayersContactData with_finite_length(const LayersContactData &data)
  {
    check_layers_data(data);
    LayersContactData result = data;
    if (data.ends == Layer::Ends::infinite)
      result.length = std::sqrt(3. * data.approach / data.gap_curvature) +
                      infinite_length * std::max(data.layers[0].thickness, data.layers[1].thickness);
    check_thickness(result);
    return result;
  }

  ContactPressure solve_layers_contact(const LayersContactData &data)
  {
    for (Eigen::Index n = 16; n <= 256; n *= 2)
    {
      const SineBasis basis(find_half_width(data, n), data.length, n);
      const Eigen::VectorXd c = solve_for_width(data, basis).coefficients;
      if (c.tail(3).cwiseAbs().maxCoeff() <= 1e-13 * c.cwiseAbs().maxCoeff())
        return ContactPressure(basis, c);
    }
    throw ComputationError(
        "The exact contact pressure of the two layers is not resolved by 256 coefficients; "
        "take thicker layers or a narrower contact.");
  }
} // namespace abut
