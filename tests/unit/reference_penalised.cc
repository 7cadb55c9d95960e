// SPDX-License-Identifier: LGPL-2.1-or-later
// Two layers with a penalty: the contact law between the nodes, energy, and the limits of a small and a large
// penalty.
#include <abut/base/user_error.h>
#include <abut/reference/layers_contact.h>
#include <abut/reference/penalised_layers_contact.h>

#include <gtest/gtest.h>

#include "reference_layers_data.h"
#include <cmath>
#include <limits>

namespace abut
{
  namespace
  {
    /// c H/E of equal_layers().
    double steel_penalty(const double c)
    {
      return c / 2.1e5;
    }

    LayersContactData equal_bonded_layers()
    {
      LayersContactData data = equal_layers();
      for (Layer &layer : data.layers)
        layer.base = Layer::Base::bonded;
      return data;
    }

    /// What pressing stores: the layers' energy and that of the penalty.
    double stored_energy(const PressedLayers &layers, const double penalty)
    {
      const double norm = layers.pressure_l2_norm();
      return layers.strain_energy(0) + layers.strain_energy(1) + 0.5 * penalty * norm * norm;
    }

    double gap_at(const PressedLayers &layers, const double x)
    {
      const LayersContactData &data = layers.data();
      return data.gap_curvature * x * x - data.approach + layers.displacement(0, x) +
             layers.displacement(1, x);
    }
  } // namespace

  // 97 points that are no nodes, dense at the edge.
  TEST(PenalisedLayersContact, pressure_is_the_overlap_divided_by_the_penalty)
  {
    LayersContactData infinite = bonded_and_sliding_layers();
    infinite.ends = Layer::Ends::infinite;
    for (const LayersContactData &data :
         {equal_layers(), equal_bonded_layers(), different_layers(), infinite})
      for (const double c : {5e-4, 0.05, 0.1})
      {
        const PenalisedLayersContact layers(data, steel_penalty(c));
        const double a = layers.half_width();
        for (int i = 0; i < 97; ++i)
        {
          const double rest = 1. - double(i) / 97.;
          const double x = a * (1. - rest * rest);
          const double law = layers.penalty() * layers.pressure(x) + gap_at(layers, x);
          EXPECT_NEAR(law / data.approach, 0., 1e-6) << "c = " << c << ", x/a = " << x / a;
          EXPECT_GT(layers.pressure(x), 0.) << "c = " << c << ", x/a = " << x / a;
        }
        EXPECT_NEAR(layers.pressure(a * (1. - 1e-12)), 0., 1e-9 * layers.pressure(0.));
        for (const double t : {0.01, 0.2, 0.6, 1.})
        {
          const double x = a + t * (layers.data().length - a);
          EXPECT_GT(gap_at(layers, x), 0.) << "c = " << c << ", x = " << x;
          EXPECT_EQ(layers.pressure(x), 0.);
        }
      }
  }

  TEST(PenalisedLayersContact, force_is_the_derivative_of_the_energy_by_the_approach)
  {
    const double penalty = steel_penalty(0.05);
    const auto energy = [&](double factor) {
      LayersContactData moved = different_layers();
      moved.approach *= factor;
      return stored_energy(PenalisedLayersContact(moved, penalty), penalty);
    };
    const double h = 1e-2;
    const double derivative =
        (8. * (energy(1. + h) - energy(1. - h)) - energy(1. + 2. * h) + energy(1. - 2. * h)) /
        (12. * h * different_layers().approach);
    const PenalisedLayersContact layers(different_layers(), penalty);
    EXPECT_NEAR(derivative / layers.force(), 1., 1e-7);
  }

  // The work of the pressure on the gap: int p (w_1 + w_2) + theta int p^2 = Delta force - r0 int p x^2.
  TEST(PenalisedLayersContact, work_of_the_approach_is_stored)
  {
    for (const LayersContactData &data : {equal_layers(), equal_bonded_layers(), different_layers()})
    {
      const double penalty = steel_penalty(5e-3);
      const PenalisedLayersContact layers(data, penalty);
      const double work = layers.response(0).pressure().integrate_against(
          [&](double x) { return data.approach - data.gap_curvature * x * x; });
      EXPECT_NEAR(2. * stored_energy(layers, penalty) / work, 1., 1e-10);
    }
  }

  // By the minimum property theta/2 |p_theta|^2 <= E_0 - E_theta <= theta/2 |p_0|^2 for the energies E.
  TEST(PenalisedLayersContact, exact_contact_is_the_limit_of_small_penalties)
  {
    for (const LayersContactData &data : {equal_layers(), equal_bonded_layers(), different_layers()})
    {
      const LayersContact exact(data);
      double previous_force = 0.;
      for (const double c : {1e-3, 1e-4})
      {
        const double penalty = steel_penalty(c);
        const PenalisedLayersContact layers(data, penalty);
        const double drop = stored_energy(exact, 0.) - stored_energy(layers, penalty);
        const double upper = 0.5 * penalty * std::pow(exact.pressure_l2_norm(), 2);
        const double lower = 0.5 * penalty * std::pow(layers.pressure_l2_norm(), 2);
        EXPECT_LT(drop, upper) << c;
        EXPECT_GT(drop, lower) << c;
        EXPECT_LT(upper - lower, 5. * c * upper);
        const double force = exact.force() - layers.force();
        if (previous_force > 0.)
        {
          EXPECT_NEAR(previous_force / force, 10., 0.2);
        }
        previous_force = force;
      }
    }
  }

  TEST(PenalisedLayersContact, independent_springs_are_the_limit_of_large_penalties)
  {
    const LayersContactData data = equal_layers();
    const double layers_give = 2. * data.layers[0].thickness / data.layers[0].young_modulus;
    for (const double factor : {1e3, 1e5})
    {
      const double penalty = factor * layers_give;
      const PenalisedLayersContact layers(data, penalty);
      EXPECT_NEAR(layers.half_width() / std::sqrt(data.approach / data.gap_curvature), 1., 1. / factor);
      for (const double x : {0., 0.3, 0.7, 1.})
      {
        const double overlap = data.approach - data.gap_curvature * x * x;
        EXPECT_NEAR(penalty * layers.pressure(x) / overlap, 1., 2. / factor) << x;
        EXPECT_LT(penalty * layers.pressure(x), overlap);
      }
    }
  }

  // As for exact contact, with the penalty as a third spring.
  TEST(PenalisedLayersContact, thin_layers_are_elastic_foundations)
  {
    LayersContactData data = equal_layers();
    for (Layer &layer : data.layers)
      layer.thickness = 0.05;
    const Layer &layer = data.layers[0];
    const double spring = layer.thickness / 2. * layer.half_plane_compliance();
    const PenalisedLayersContact layers(data, 0.5 * spring);
    const double mean = layers.force() / data.length;
    for (const double x : {0., 0.1, 0.3})
    {
      const double p = layers.pressure(x);
      const double sum = 2. * (layer.uniform_compliance(Layer::Ends::rollers) * mean + spring * (p - mean)) +
                         0.5 * spring * p;
      EXPECT_NEAR(sum / (data.approach - data.gap_curvature * x * x), 1., 1e-6) << "x = " << x;
    }
  }

  TEST(PenalisedLayersContact, presses_the_layers_with_its_pressure)
  {
    const PenalisedLayersContact layers(different_layers(), steel_penalty(0.05));
    for (const unsigned int body : {0U, 1U})
      for (const double x : {0.1, 0.6, 1., 2.})
      {
        const ExactStress s = layers.stress(body, Vector2(x, layers.data().layers[body].thickness));
        EXPECT_NEAR(s.yy, -layers.pressure(x), 1e-11 * layers.pressure(0.)) << x;
        EXPECT_NEAR(s.xy, 0., 1e-11 * layers.pressure(0.)) << x;
      }
  }

  TEST(PenalisedLayersContact, refuses_penalties_that_are_not_positive)
  {
    for (const double penalty :
         {0., -1e-7, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
      EXPECT_THROW(PenalisedLayersContact(equal_layers(), penalty), UserError);
    LayersContactData data = equal_layers();
    data.approach = 0.;
    EXPECT_THROW(PenalisedLayersContact(data, steel_penalty(0.05)), UserError);
  }
} // namespace abut
