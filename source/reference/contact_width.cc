// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/reference/contact_width.h>

#include <deal.II/base/exceptions.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace abut
{
  namespace
  {
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

  double find_half_width(const LayersContactData &data, const std::function<double(double)> &approach_of)
  {
    const auto excess = [&](double a) { return approach_of(a) / data.approach - 1.; };
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

  double find_half_width_near(const double guess, const LayersContactData &data,
                              const std::function<double(double)> &approach_of)
  {
    Assert(guess > 0., dealii::ExcMessage("a contact has a width"));
    const auto excess = [&](double a) { return approach_of(a) / data.approach - 1.; };
    constexpr double step = 1.001;
    std::uintmax_t n_iterations = 100;
    const auto bracket = boost::math::tools::bracket_and_solve_root(
        excess, guess, step, true, boost::math::tools::eps_tolerance<double>(40), n_iterations);
    return 0.5 * (bracket.first + bracket.second);
  }

  double half_plane_compliance(const LayersContactData &data)
  {
    return data.layers[0].half_plane_compliance() + data.layers[1].half_plane_compliance();
  }

  double uniform_compliance(const LayersContactData &data)
  {
    return data.layers[0].uniform_compliance(data.ends) + data.layers[1].uniform_compliance(data.ends);
  }
} // namespace abut
