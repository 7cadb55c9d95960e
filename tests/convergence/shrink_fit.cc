// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/reference/lame.h>

#include "convergence_table.h"
#include "solved_scene.h"

namespace
{
  using namespace abut;

  constexpr double radius = 1., overlap = 1e-3, outer_radius = 2.;
  constexpr std::size_t mean_pressure = 0, worst_pressure = 1, ring_stress = 2, disc_stress = 3;

  ShrinkFit reference(const double penalty)
  {
    return ShrinkFit({{1.1e5, .34, 0.}, {2.1e5, .3, outer_radius}, radius, overlap, penalty});
  }

  double mean_pressure_error(const PairResult &pair, const double exact)
  {
    return std::abs(pair.normal_force / (exact * radius * std::acos(0.)) - 1.);
  }

  double worst_pressure_error(const PairResult &pair, const double exact)
  {
    return (pair.pressures.array() / exact - 1.).abs().maxCoeff();
  }

  /// sigma in L2 over xx, yy, zz, 2 xy against a field given in polar coordinates.
  template <typename Field> double stress_error(const BodyResult &result, const Field &exact)
  {
    double error = 0., square = 0.;
    result.body->visit_displacement(
        result.displacement, SamplePoints::energy,
        [&](const SamplePoint &sample, const Vector2 &, const Eigen::Matrix2d &gradient) {
          const Vector2 &point = sample.place;
          const double weight = sample.weight;
          const Stress s = result.body->material().stress(gradient);
          const PolarStress e = exact(point.norm());
          Eigen::Matrix2d computed, turn;
          computed << s.xx, s.xy, s.xy, s.yy;
          const Vector2 r = point.normalized();
          turn << r.x(), -r.y(), r.y(), r.x();
          const Eigen::Matrix2d polar = Eigen::Vector2d(e.radial, e.hoop).asDiagonal();
          error += weight * ((computed - turn * polar * turn.transpose()).squaredNorm() +
                             (s.zz - e.axial) * (s.zz - e.axial));
          square += weight * (polar.squaredNorm() + e.axial * e.axial);
        });
    return std::sqrt(error / square);
  }

  /**
   * Relative errors of `prm/shrink-fit.prm`: of the mean pressure, of the pressure at the worst node, and of
   * the stresses. The pressure belongs to the arc of the slave, the ring: the disc, larger by the overlap D,
   * feels the same forces on a longer arc, p R / (R + D), and that is what its stress is compared with.
   */
  std::vector<double> errors(const unsigned int degree, const unsigned int cells)
  {
    const std::string n = std::to_string(cells);
    const SolvedScene scene("shrink-fit.prm", {"Discretisation/Degree=" + std::to_string(degree),
                                               "Body disc/Cells=" + std::to_string(2 * cells) + ", " + n,
                                               "Body ring/Cells=" + std::to_string(3 * cells) + ", " +
                                                   std::to_string(2 * cells)});
    const PairResult &pair = scene.pair();
    const ShrinkFit exact = reference(pair.pair->penalty());
    const double p = exact.pressure();
    return {mean_pressure_error(pair, p), worst_pressure_error(pair, p),
            stress_error(scene.body("ring"),
                         [&](const double r) { return exact.stress(ShrinkFit::Part::outer, r); }),
            stress_error(scene.body("disc"), [&](double) {
              const PolarStress s = exact.stress(ShrinkFit::Part::inner, .5 * radius);
              const double spread = radius / (radius + overlap);
              return PolarStress{spread * s.radial, spread * s.hoop, spread * s.axial};
            })};
  }

  ConvergenceTable study(const unsigned int degree, const std::vector<unsigned int> &cells)
  {
    ConvergenceTable table("Shrink fit, relative errors, degree " + std::to_string(degree),
                           {"mean pressure", "worst pressure", "ring stress", "disc stress"});
    for (const unsigned int n : cells)
      table.add(1. / n, errors(degree, n));
    table.print();
    return table;
  }

  /**
   * The mean pressure is a quadratic functional of the solution: order 2 p. Stresses and the pressure at the
   * nodes of nonmatching meshes: order p (the disc's uniform stress, which the space contains, has no error
   * but that of the pressure).
   */
  void expect_rates(const ConvergenceTable &table, const unsigned int degree)
  {
    EXPECT_NEAR(table.last_rate(mean_pressure), 2. * degree, .1);
    EXPECT_NEAR(table.last_rate(ring_stress), degree, .1);
    EXPECT_GT(table.last_rate(worst_pressure), degree - .1);
    EXPECT_GT(table.last_rate(disc_stress), degree - .1);
  }

  TEST(ShrinkFitScene, converges_to_lame)
  {
    const ConvergenceTable linear = study(1, {4, 8, 16});
    const ConvergenceTable quadratic = study(2, {4, 8, 16});
    expect_rates(linear, 1);
    expect_rates(quadratic, 2);
    EXPECT_LT(1000. * quadratic.last_error(mean_pressure), linear.last_error(mean_pressure));
    for (const std::size_t column : {worst_pressure, ring_stress, disc_stress})
      EXPECT_LT(3. * quadratic.last_error(column), linear.last_error(column));
  }

  TEST(ShrinkFitScene, overlap_may_be_a_formula)
  {
    for (const std::string c : {"0.04", "0"}) // a penalty smooths the pressure a little
    {
      const SolvedScene scene("shrink-fit.prm",
                              {"Discretisation/Degree=2", "Body disc/Size=1", "Contact fit/Gap=-overlap",
                               "Contact fit/Penalty coefficient=" + c});
      const PairResult &pair = scene.pair();
      const double p = reference(pair.pair->penalty()).pressure();
      std::cout << "Shrink fit with the overlap as a formula, degree 2, c = " << c
                << ": relative error of the mean pressure " << mean_pressure_error(pair, p)
                << ", of the worst " << worst_pressure_error(pair, p) << '\n';
      EXPECT_LT(mean_pressure_error(pair, p), 1e-6);
      EXPECT_LT(worst_pressure_error(pair, p), c == "0" ? 6e-4 : 3e-4);
    }
  }
} // namespace
