// SPDX-License-Identifier: LGPL-2.1-or-later
// Discs and rings, which boundary elements see as polygons.
#include <abut/reference/lame.h>

#include <gtest/gtest.h>

#include "bem_orders.h"

using namespace abut;

namespace
{
  constexpr double inner = .4, outer = 1.;

  std::vector<Complex> ring_points()
  {
    return {std::polar(.7, .3), std::polar(.6, 2.), std::polar(.75, 4.1)};
  }

  std::vector<Curve> ring_curves(const unsigned int n)
  {
    return {regular_polygon(4 * n, outer), regular_polygon(2 * n, inner, true)};
  }

  /// A field known on the polygon itself; clamped where x < 0, also in the hole of the ring.
  BoundaryCase polygon_case(const std::vector<Curve> &curves, const std::vector<Complex> &points,
                            const Degrees &degrees)
  {
    BoundaryCase problem;
    problem.field = smooth_field(problem.material);
    problem.curves = curves;
    problem.supported = [](const Complex z, const Vector2 &) -> std::vector<Vector2> {
      if (z.real() > 0.)
        return {};
      return {Vector2::UnitX(), Vector2::UnitY()};
    };
    problem.points = points;
    problem.displacement_degree = degrees.displacement;
    problem.traction_degree = degrees.traction;
    return problem;
  }

  /// The outer ring of a shrink fit: pressure in the hole, the outside free.
  PlaneField lame_field(const Material &material)
  {
    // The other part is as good as rigid.
    const ShrinkFit fit({{1e6, .3, 0.}, {material.young_modulus, material.poisson_ratio, outer}, inner, .1});
    PlaneField field;
    field.displacement = [=](const Complex z) {
      return fit.radial_displacement(ShrinkFit::Part::outer, std::max(std::abs(z), inner)) * z / std::abs(z);
    };
    field.stress = [=](const Complex z) -> Stress {
      const PolarStress s = fit.stress(ShrinkFit::Part::outer, std::abs(z));
      const double mean = .5 * (s.radial + s.hoop), c = .5 * (s.radial - s.hoop);
      const Complex turn = z * z / std::norm(z);
      return {mean + c * turn.real(), mean - c * turn.real(), c * turn.imag(), s.axial};
    };
    field.traction = [=](const Complex z, const Complex normal) {
      return std::abs(z) < .5 * (inner + outer) ? -fit.pressure() * normal : Complex(0.);
    };
    return field;
  }

  /// s_rr = cos 2 theta and no shear on the unit circle: phi = z^3/6, psi = -z.
  PlaneField squeezed_disc(const Material &material)
  {
    PlaneField field = from_potentials(material, [](const Complex z) -> Potentials {
      return {z * z * z / 6., .5 * z * z, z, -z, -1.};
    });
    field.traction = [](const Complex z, const Complex normal) {
      return std::cos(2. * std::arg(z)) * normal;
    };
    return field;
  }

  PlaneField pressed_disc(const Material &material)
  {
    return from_potentials(material, [](const Complex z) -> Potentials {
      return {-.5 * z, -.5, 0., 0., 0.};
    });
  }

  const auto unsupported = [](const Complex, const Vector2 &) { return std::vector<Vector2>(); };
} // namespace

TEST(BemRound, FieldsKnownOnPolygons)
{
  for (const Degrees &degrees : all_degrees)
  {
    expect_orders(study(
                      "Disc" + name_of(degrees),
                      [&](const unsigned int n) {
                        return polygon_case({regular_polygon(4 * n, outer)},
                                            {{.2, .3}, {-.4, .1}, {.5, -.2}, {-.3, -.4}}, degrees);
                      },
                      2, 5),
                  degrees);
    for (const bool free_hole : {false, true})
      expect_orders(study((free_hole ? "Ring, its hole free" : "Ring") + name_of(degrees),
                          [&](const unsigned int n) {
                            BoundaryCase problem = polygon_case(ring_curves(n), ring_points(), degrees);
                            const auto supported = problem.supported;
                            if (free_hole)
                              problem.supported = [=](const Complex z, const Vector2 &normal) {
                                return std::abs(z) < .5 * (inner + outer) ? std::vector<Vector2>()
                                                                          : supported(z, normal);
                              };
                            return problem;
                          },
                          2, 5),
                    degrees);
  }
}

// Of a true circle polygons are an approximation of the second order, whatever the degree.
TEST(BemRound, RingUnderPressure)
{
  for (const bool rollers : {false, true})
    for (const Degrees degrees : {Degrees{1, 1}, Degrees{2, 1}})
    {
      const ConvergenceTable table = study(
          "Lame's ring" + name_of(degrees) + (rollers ? ", on rollers" : ""),
          [&](const unsigned int n) {
            BoundaryCase problem = polygon_case(ring_curves(n), ring_points(), degrees);
            problem.field = lame_field(problem.material);
            problem.supported = [=](const Complex z, const Vector2 &normal) -> std::vector<Vector2> {
              if (!rollers || std::abs(z) > .5 * (inner + outer))
                return {};
              return {normal};
            };
            EXPECT_EQ(solve(problem).n_free_rigid_motions, rollers ? 1 : 3);
            return problem;
          },
          6); // an octagon has corners
      EXPECT_NEAR(table.last_rate(displacement), 2., .1);
      EXPECT_NEAR(table.last_rate(stress), 2., .1);
    }
}

TEST(BemRound, DiscUnderPressure)
{
  for (const Degrees degrees : {Degrees{1, 1}, Degrees{2, 1}})
  {
    const auto disc = [&](const unsigned int n, const bool uniform) {
      BoundaryCase problem =
          polygon_case({regular_polygon(4 * n, outer)}, {{.2, .3}, {-.4, .1}, {.5, -.2}}, degrees);
      problem.field = uniform ? pressed_disc(problem.material) : squeezed_disc(problem.material);
      problem.supported = unsupported;
      return problem;
    };
    const ConvergenceTable table = study(
        "Disc, pressure cos(2 theta)" + name_of(degrees),
        [&](const unsigned int n) { return disc(n, false); }, 2, 5);
    EXPECT_NEAR(table.last_rate(displacement), 2., .1);
    EXPECT_NEAR(table.last_rate(stress), 2., .1);
    // A uniform pressure leaves the same stress in any shape.
    EXPECT_LT(solve(disc(2, true)).stress, 1e-12);
    EXPECT_LT(solve(disc(8, true)).stress, 1e-12);
  }
}
