// SPDX-License-Identifier: LGPL-2.1-or-later
// The exact solution of two layers: figures known to 12 digits, the contact condition, energy, limits.
#include <abut/base/user_error.h>

#include <gtest/gtest.h>

#include "reference_layers_data.h"
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace abut
{
  namespace
  {
    void expect_relative(double value, double expected, double tolerance)
    {
      EXPECT_NEAR(value / expected, 1., tolerance);
    }
  } // namespace

  TEST(LayersContact, reproduces_the_known_figures_of_two_equal_layers)
  {
    const LayersContact exact(equal_layers());
    expect_relative(exact.half_width(), 1.0150918916860, 2e-12);
    expect_relative(exact.pressure(0.), 172.0703323845, 1e-12);
    expect_relative(exact.force(), 133.8364523567, 1e-12);
    expect_relative(exact.pressure_l2_norm(), 138.7818063663, 1e-12);
    for (const unsigned int body : {0U, 1U})
    {
      expect_relative(exact.strain_energy(body), 0.03729163236289, 1e-12);
      expect_relative(exact.stress_l2_norm(body), 144.565059861, 1e-11);
    }
  }

  TEST(LayersContact, displacements_close_the_gap_in_contact_and_leave_it_open_beyond)
  {
    for (const LayersContactData &given :
         {equal_layers(), different_layers(), bonded_and_sliding_layers(), bonded_layers(),
          infinite_layers(Layer::Base::sliding), infinite_layers(Layer::Base::bonded)})
    {
      const LayersContact exact(given);
      const LayersContactData &data = exact.data();
      const double a = exact.half_width();
      const auto opening = [&](double x) {
        return exact.displacement(0, x) + exact.displacement(1, x) + data.gap_curvature * x * x -
               data.approach;
      };
      for (const double t : {0., 0.1372, 0.3119, 0.5, 0.7713, 0.9241, 0.9987})
      {
        EXPECT_NEAR(opening(t * a) / data.approach, 0., 1e-12) << "x/a = " << t;
        EXPECT_GT(exact.pressure(t * a), 0.);
      }
      for (const double t : {0.01, 0.2, 0.6, 1.})
      {
        const double x = a + t * (data.length - a);
        EXPECT_GT(opening(x), 0.) << "x = " << x;
        EXPECT_EQ(exact.pressure(x), 0.);
      }
    }
  }

  // The gap is rigid, so the work of the approach is what the layers store: d(U_1 + U_2)/d Delta = force.
  TEST(LayersContact, force_is_the_derivative_of_the_energy_by_the_approach)
  {
    LayersContactData infinite = bonded_and_sliding_layers();
    infinite.ends = Layer::Ends::infinite;
    for (const LayersContactData &data :
         {different_layers(), bonded_and_sliding_layers(), bonded_layers(), infinite})
    {
      const auto energy = [&](double factor) {
        LayersContactData moved = data;
        moved.approach *= factor;
        const LayersContact exact(moved);
        return exact.strain_energy(0) + exact.strain_energy(1);
      };
      const double h = 1e-3;
      const double derivative =
          (8. * (energy(1. + h) - energy(1. - h)) - energy(1. + 2. * h) + energy(1. - 2. * h)) /
          (12. * h * data.approach);
      expect_relative(derivative, LayersContact(data).force(), 1e-9);
    }
  }

  TEST(LayersContact, swapped_layers_swap_their_fields)
  {
    LayersContactData swapped = different_layers();
    std::swap(swapped.layers[0], swapped.layers[1]);
    const LayersContact first(different_layers());
    const LayersContact second(swapped);
    expect_relative(second.half_width(), first.half_width(), 1e-13);
    expect_relative(second.force(), first.force(), 1e-13);
    expect_relative(second.strain_energy(1), first.strain_energy(0), 1e-13);
    expect_relative(second.stress_l2_norm(1), first.stress_l2_norm(0), 1e-13);
    expect_relative(second.displacement(0, 1.3), first.displacement(1, 1.3), 1e-12);
    EXPECT_GT(std::abs(first.strain_energy(0) / first.strain_energy(1) - 1.), 0.1);
  }

  TEST(LayersContact, scales_with_modulus_length_and_load)
  {
    const LayersContactData data = different_layers();
    const LayersContact exact(data);

    LayersContactData stiffer = data;
    for (Layer &layer : stiffer.layers)
      layer.young_modulus *= 2.;
    expect_relative(LayersContact(stiffer).half_width(), exact.half_width(), 1e-13);
    expect_relative(LayersContact(stiffer).pressure(0.3), 2. * exact.pressure(0.3), 1e-12);

    LayersContactData longer = data; // centimetres to micrometres
    longer.length *= 1e4;
    longer.approach *= 1e4;
    longer.gap_curvature /= 1e4;
    for (Layer &layer : longer.layers)
      layer.thickness *= 1e4;
    expect_relative(LayersContact(longer).half_width(), 1e4 * exact.half_width(), 1e-12);
    expect_relative(LayersContact(longer).pressure(0.3e4), exact.pressure(0.3), 1e-12);

    LayersContactData loaded = data; // a gap and an approach twice as large: the same contact
    loaded.approach *= 2.;
    loaded.gap_curvature *= 2.;
    expect_relative(LayersContact(loaded).half_width(), exact.half_width(), 1e-13);
    expect_relative(LayersContact(loaded).force(), 2. * exact.force(), 1e-12);
  }

  TEST(LayersContact, refuses_what_has_no_solution_of_this_kind)
  {
    const auto with = [](auto change) {
      LayersContactData data = equal_layers();
      change(data);
      return data;
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const LayersContactData &wrong : {
             with([](auto &d) { d.approach = 0.; }),
             with([](auto &d) { d.approach = -1e-3; }),
             with([](auto &d) { d.approach = 1.; }),    // contact fills the width
             with([](auto &d) { d.approach = 1e-12; }), // contact narrower than 1e-4 of the length
             with([nan](auto &d) { d.approach = nan; }),
             with([](auto &d) { d.length = 0.; }),
             with([](auto &d) { d.gap_curvature = 0.; }),
             with([](auto &d) { d.layers[1].young_modulus = -1.; }),
             with([](auto &d) { d.layers[1].poisson_ratio = 0.5; }),
             with([](auto &d) { d.layers[0].thickness = 0.; }),
             with([](auto &d) { d.layers[0].thickness = 0.009; }),
         })
      EXPECT_THROW(LayersContact{wrong}, UserError);
  }

  TEST(LayersContact, names_the_approach_and_its_limits)
  {
    LayersContactData data = equal_layers();
    data.approach = 0.5;
    try
    {
      const LayersContact exact(data);
      FAIL() << "an approach that fills the width was accepted";
    }
    catch (const UserError &error)
    {
      const std::string text = error.what();
      EXPECT_NE(text.find("approach 0.5, which must lie between"), std::string::npos) << text;
    }
  }

  // Far from the edge of contact a thin sliding layer gives way like springs, H(1-nu^2)/E each, and by the
  // mean pressure without lateral strain: L(u) = u/2 + O(u^5), a parabola of pressure feels no more of it.
  TEST(LayersContact, thin_layers_are_elastic_foundations)
  {
    LayersContactData data = equal_layers();
    for (Layer &layer : data.layers)
      layer.thickness = 0.05;
    const LayersContact exact(data);
    const Layer &layer = data.layers[0];
    const double spring =
        layer.thickness * (1. - layer.poisson_ratio * layer.poisson_ratio) / layer.young_modulus;
    const double mean = exact.force() / data.length;
    for (const double x : {0., 0.1, 0.3})
    {
      const double expected =
          layer.uniform_compliance(Layer::Ends::rollers) * mean + spring * (exact.pressure(x) - mean);
      EXPECT_NEAR(2. * expected / (data.approach - data.gap_curvature * x * x), 1., 1e-10) << "x = " << x;
    }
  }

  TEST(LayersContact, is_resolved_between_narrow_and_wide_contact)
  {
    for (const double approach : {1e-7, 1e-5, 1e-3, 5e-3, 9e-3})
    {
      LayersContactData data = equal_layers();
      data.approach = approach;
      const LayersContact exact(data);
      const double x = 0.9371 * exact.half_width();
      EXPECT_NEAR(2. * exact.displacement(0, x) / (approach - data.gap_curvature * x * x), 1., 1e-9)
          << approach;
    }
  }
} // namespace abut
