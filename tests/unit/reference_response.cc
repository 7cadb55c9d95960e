// SPDX-License-Identifier: LGPL-2.1-or-later
// The response of one layer to a pressure with jumps: boundary conditions, reciprocity, superposition, and
// the contact pressure of LayersContact approximated by pieces.
#include <abut/base/user_error.h>

#include <boost/math/quadrature/gauss.hpp>
#include <gtest/gtest.h>

#include "reference_layers_data.h"
#include "reference_pieces_data.h"
#include <cmath>
#include <memory>

namespace abut
{
  namespace
  {
    using ResponseGauss = boost::math::quadrature::gauss<double, 30>;

    std::shared_ptr<const PiecewisePressure> make_pressure(const std::vector<PressurePiece> &pieces)
    {
      return std::make_shared<const PiecewisePressure>(rough_length, pieces);
    }

    Layer response_layer(Layer::Base base)
    {
      return {2.1e5, 0.3, 1.2, base};
    }

    double plane_strain(const Layer &layer, double along, double across)
    {
      const double nu = layer.poisson_ratio;
      return ((1. - nu * nu) * along - nu * (1. + nu) * across) / layer.young_modulus;
    }

    // Cubics through four values of p on parts that grow from the edge a like the fourth power.
    std::vector<PressurePiece> interpolate_contact(const LayersContact &exact, int n)
    {
      const double a = exact.half_width();
      const auto knot = [&](int i) { return a * (1. - std::pow(1. - double(i) / n, 4)); };
      std::vector<PressurePiece> pieces;
      for (int i = 0; i < n; ++i)
      {
        const auto p = [&](double t) { return exact.pressure(knot(i) + t * (knot(i + 1) - knot(i))); };
        const double p0 = p(0.), p1 = p(1. / 3.), p2 = p(2. / 3.), p3 = p(1.);
        pieces.push_back(
            {knot(i),
             knot(i + 1),
             {{p0, -5.5 * p0 + 9. * p1 - 4.5 * p2 + p3, 9. * p0 - 22.5 * p1 + 18. * p2 - 4.5 * p3,
               4.5 * (-p0 + 3. * p1 - 3. * p2 + p3)}}});
      }
      return pieces;
    }
  } // namespace

  struct LayerResponseOf : testing::TestWithParam<Layer::Base>
  {
    const Layer layer = response_layer(GetParam());
    const LayerResponse response{layer, make_pressure(rough_pieces())};

    ExactStress at(double x, double y) const { return response.stress(Vector2(x, y)); }
  };

  TEST_P(LayerResponseOf, meets_the_boundary_conditions)
  {
    for (const double x : {0., 0.1, 0.4000002, 0.7, 1.3, 1.70003, 2.6, 3.2, rough_length})
    {
      const double p = response.pressure().value(x);
      EXPECT_NEAR(at(x, layer.thickness).yy, -p, 1e-13) << x;
      EXPECT_NEAR(at(x, layer.thickness - 1e-10).yy, -p, 1e-3) << x;
      EXPECT_NEAR(at(x, layer.thickness).xy, 0., 1e-13) << x;
      const ExactStress base = at(x, 0.);
      const double held = layer.base == Layer::Base::sliding
                              ? base.xy
                              : layer.young_modulus * plane_strain(layer, base.xx, base.yy);
      EXPECT_NEAR(held, 0., 1e-13) << x;
      EXPECT_NEAR(at(0., 0.3 * x).xy, 0., 1e-13);
      EXPECT_NEAR(at(rough_length, 0.3 * x).xy, 0., 1e-13);
    }
  }

  // The rigid face does not move: all that the surface gives way is the shortening of the layer.
  TEST_P(LayerResponseOf, shortens_by_the_displacement_of_its_surface)
  {
    for (const double x : {0., 0.2, 0.7, 1.3, 2.6, rough_length})
    {
      const auto shortening = [&](double s) {
        const double depth = layer.thickness * s * s;
        const ExactStress stress = at(x, layer.thickness - depth);
        return -plane_strain(layer, stress.yy, stress.xx) * 2. * layer.thickness * s;
      };
      double sum = 0.;
      for (int i = 0; i < 30; ++i)
        sum += ResponseGauss::integrate(shortening, i / 30., (i + 1) / 30.);
      EXPECT_NEAR(sum / response.displacement(x), 1., 1e-11) << x;
    }
  }

  TEST_P(LayerResponseOf, is_in_equilibrium)
  {
    const double h = 1e-3;
    const auto slope = [&](auto f) { return (8. * (f(h) - f(-h)) - f(2. * h) + f(-2. * h)) / (12. * h); };
    for (const Vector2 &point : {Vector2(0.4, 1.1), Vector2(0.9, 0.9), Vector2(1.7, 0.1), Vector2(3.1, 0.6)})
    {
      const double x = point.x(), y = point.y();
      EXPECT_NEAR(slope([&](double t) { return at(x + t, y).xx; }) +
                      slope([&](double t) { return at(x, y + t).xy; }),
                  0., 1e-6);
      EXPECT_NEAR(slope([&](double t) { return at(x + t, y).xy; }) +
                      slope([&](double t) { return at(x, y + t).yy; }),
                  0., 1e-6);
    }
  }

  // Betti: the pressures p and q do the same work on the displacements of each other.
  TEST_P(LayerResponseOf, is_reciprocal_and_linear)
  {
    const std::vector<PressurePiece> rough = rough_pieces();
    const auto left = make_pressure({rough.begin(), rough.begin() + 3});
    const auto right = make_pressure({rough.begin() + 3, rough.end()});
    const LayerResponse first(layer, left), second(layer, right);
    const double mixed = left->integrate_against([&](double x) { return second.displacement(x); });
    EXPECT_NEAR(right->integrate_against([&](double x) { return first.displacement(x); }) / mixed, 1., 1e-11);
    EXPECT_NEAR(response.strain_energy() / (first.strain_energy() + second.strain_energy() + mixed), 1.,
                1e-11);
    for (const Vector2 &point : {Vector2(0.4, 1.2), Vector2(0.9, 1.19), Vector2(1.7, 0.1)})
    {
      EXPECT_NEAR(response.stress(point).xx, first.stress(point).xx + second.stress(point).xx, 1e-13);
      EXPECT_NEAR(response.stress(point).xy, first.stress(point).xy + second.stress(point).xy, 1e-13);
    }
  }

  INSTANTIATE_TEST_SUITE_P(both_bases, LayerResponseOf,
                           testing::Values(Layer::Base::sliding, Layer::Base::bonded));

  TEST(LayerResponse, to_pieces_of_a_contact_pressure_is_that_of_the_contact)
  {
    const LayersContact exact(bonded_and_sliding_layers());
    const auto pieces =
        std::make_shared<const PiecewisePressure>(exact.data().length, interpolate_contact(exact, 100));
    EXPECT_NEAR(pieces->force() / exact.force(), 1., 1e-7);
    for (const unsigned int body : {0U, 1U})
    {
      const Layer &layer = exact.data().layers[body];
      const LayerResponse response(layer, pieces);
      EXPECT_NEAR(response.strain_energy() / exact.strain_energy(body), 1., 1e-7);
      EXPECT_NEAR(response.stress_l2_norm() / exact.stress_l2_norm(body), 1., 1e-7);
      for (const double x : {0., 0.3, 0.7, 1.1, 2.})
      {
        EXPECT_NEAR(response.displacement(x) / exact.displacement(body, 0.),
                    exact.displacement(body, x) / exact.displacement(body, 0.), 1e-7);
        for (const double height : {0., 0.5, 0.97, 1.})
        {
          const Vector2 point(x, height * layer.thickness);
          const ExactStress a = response.stress(point), b = exact.stress(body, point);
          const double scale = exact.pressure(0.);
          EXPECT_NEAR((a.xx - b.xx) / scale, 0., 1e-6) << point.transpose();
          EXPECT_NEAR((a.yy - b.yy) / scale, 0., 1e-6) << point.transpose();
          EXPECT_NEAR((a.xy - b.xy) / scale, 0., 1e-6) << point.transpose();
          EXPECT_NEAR((a.zz - b.zz) / scale, 0., 1e-6) << point.transpose();
        }
      }
    }
  }

  TEST(LayerResponse, refuses_a_layer_that_makes_no_sense)
  {
    const auto pressure = make_pressure(rough_pieces());
    EXPECT_THROW(LayerResponse({-1., 0.3, 1.}, pressure), UserError);
    EXPECT_THROW(LayerResponse({1., 0.5, 1.}, pressure), UserError);
    EXPECT_THROW(LayerResponse({1., 0.3, 0.}, pressure), UserError);
  }
} // namespace abut
