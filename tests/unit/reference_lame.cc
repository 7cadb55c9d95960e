// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/reference/lame.h>

#include <gtest/gtest.h>

#include <cmath>

namespace abut
{
  namespace
  {
    using Part = ShrinkFit::Part;

    ShrinkFitData ring_in_ring()
    {
      return {{2.1e5, 0.3, 0.4}, {0.7e5, 0.35, 2.5}, 1.3, 1e-3, 2e-6};
    }

    ShrinkFitData disc_in_ring()
    {
      ShrinkFitData data = ring_in_ring();
      data.inner.free_radius = 0.;
      return data;
    }

    // The relative change of the formula under (4th order) central differences with step h.
    template <typename Function> double slope(const Function &f, double r)
    {
      const double h = 1e-3;
      return (8. * (f(r + h) - f(r - h)) - f(r + 2. * h) + f(r - 2. * h)) / (12. * h);
    }

    void expect_lame_field(const ShrinkFit &fit, Part part, const ShrinkFitPart &material, double r)
    {
      const auto radial = [&](double s) { return fit.stress(part, s).radial; };
      const auto moved = [&](double s) { return fit.radial_displacement(part, s); };
      const PolarStress stress = fit.stress(part, r);
      const double nu = material.poisson_ratio;
      const double E = material.young_modulus;
      EXPECT_NEAR((slope(radial, r) + (stress.radial - stress.hoop) / r) / fit.pressure(), 0., 1e-9);
      EXPECT_NEAR(slope(moved, r), (stress.radial - nu * (stress.hoop + stress.axial)) / E,
                  1e-9 * fit.pressure() / E);
      EXPECT_NEAR(moved(r) / r, (stress.hoop - nu * (stress.radial + stress.axial)) / E,
                  1e-13 * fit.pressure() / E);
      EXPECT_NEAR(0., (stress.axial - nu * (stress.radial + stress.hoop)) / E, 1e-13 * fit.pressure() / E);
    }
  } // namespace

  TEST(ShrinkFit, parts_meet_up_to_the_penetration_of_the_penalty)
  {
    for (const ShrinkFitData &data : {ring_in_ring(), disc_in_ring()})
    {
      const ShrinkFit fit(data);
      const double jump = fit.radial_displacement(Part::outer, data.radius) -
                          fit.radial_displacement(Part::inner, data.radius);
      EXPECT_NEAR((jump + data.penalty * fit.pressure()) / data.interference, 1., 1e-14);
      EXPECT_GT(fit.pressure(), 0.);
      EXPECT_NEAR(jump / (fit.compliance() * fit.pressure()), 1., 1e-14);
    }
  }

  TEST(ShrinkFit, tractions_are_the_pressure_at_the_fit_and_zero_at_the_free_radii)
  {
    const ShrinkFitData data = ring_in_ring();
    const ShrinkFit fit(data);
    EXPECT_NEAR(fit.stress(Part::inner, data.radius).radial / fit.pressure(), -1., 1e-14);
    EXPECT_NEAR(fit.stress(Part::outer, data.radius).radial / fit.pressure(), -1., 1e-14);
    EXPECT_NEAR(fit.stress(Part::inner, data.inner.free_radius).radial / fit.pressure(), 0., 1e-14);
    EXPECT_NEAR(fit.stress(Part::outer, data.outer.free_radius).radial / fit.pressure(), 0., 1e-14);
  }

  TEST(ShrinkFit, fields_obey_equilibrium_and_hooke_in_plane_strain)
  {
    for (const ShrinkFitData &data : {ring_in_ring(), disc_in_ring()})
    {
      const ShrinkFit fit(data);
      expect_lame_field(fit, Part::inner, data.inner, 0.7);
      expect_lame_field(fit, Part::inner, data.inner, 1.1);
      expect_lame_field(fit, Part::outer, data.outer, 1.5);
      expect_lame_field(fit, Part::outer, data.outer, 2.3);
    }
  }

  TEST(ShrinkFit, solid_disc_is_stressed_uniformly_and_rests_at_its_centre)
  {
    const ShrinkFit fit(disc_in_ring());
    for (const double r : {0., 0.5, 1.3})
    {
      EXPECT_DOUBLE_EQ(fit.stress(Part::inner, r).radial, -fit.pressure());
      EXPECT_DOUBLE_EQ(fit.stress(Part::inner, r).hoop, -fit.pressure());
    }
    EXPECT_EQ(fit.radial_displacement(Part::inner, 0.), 0.);
  }

  TEST(ShrinkFit, refuses_what_is_no_fit)
  {
    const auto with = [](auto change) {
      ShrinkFitData data = ring_in_ring();
      change(data);
      return data;
    };
    for (const ShrinkFitData &wrong :
         {with([](auto &d) { d.inner.free_radius = 1.3; }), with([](auto &d) { d.inner.free_radius = -0.1; }),
          with([](auto &d) { d.outer.free_radius = 1.2; }), with([](auto &d) { d.interference = -1e-3; }),
          with([](auto &d) { d.penalty = -1.; }), with([](auto &d) { d.inner.young_modulus = 0.; }),
          with([](auto &d) { d.outer.poisson_ratio = 0.5; })})
      EXPECT_THROW(ShrinkFit{wrong}, UserError);
  }
} // namespace abut
