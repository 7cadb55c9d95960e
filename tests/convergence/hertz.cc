// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/reference/hertz.h>

#include "convergence_table.h"
#include "solved_scene.h"
#include <sstream>

namespace
{
  using namespace abut;

  constexpr double roller_radius = 1.;

  /// What a run shows of Hertz's profile.
  struct Profile
  {
    double peak, half_width;
  };

  std::string text(const double number)
  {
    std::ostringstream stream;
    stream.precision(15);
    stream << number;
    return stream.str();
  }

  /// `prm/hertz.prm` on finer meshes and under another load.
  Profile solve(const double half_force)
  {
    const SolvedScene scene("hertz.prm",
                            {"Body roller/Cells=128, 64", "Body block/Cells=192, 96",
                             "Constants/Values=" + text(roller_radius) + ", " + text(half_force)});
    const PairResult &pair = scene.pair();
    const Eigen::VectorXd forces = pair.pair->weights().cwiseProduct(pair.loads);
    double second_moment = 0., nearest = 1e9, peak = 0.;
    for (const std::size_t k : pair.parts)
    {
      const Part &part = pair.part(k);
      const auto i = static_cast<Eigen::Index>(k);
      // the mean of x^2 over the part
      second_moment += forces[i] * (std::pow(part.middle.x(), 2) + part.length * part.length / 12.);
      if (part.place.norm() < nearest)
      {
        nearest = part.place.norm();
        peak = pair.pressures[i];
      }
    }
    // Of p0 sqrt(1 - x^2/a^2) the mean of x^2 is a^2/4.
    return {peak, 2. * std::sqrt(second_moment / forces.sum())};
  }

  TEST(HertzScene, deviates_by_the_square_of_half_width_over_size)
  {
    const double modulus = composite_modulus(5.2e3, .3, 2.8e3, .4);
    ConvergenceTable table("Hertz, bodies of the size R: deviation from half-planes against a/R",
                           {"peak pressure", "half-width"});
    for (const double a : {.2, .2 * std::sqrt(.5), .1, .1 * std::sqrt(.5)})
    {
      const double half_force = std::acos(-1.) * modulus * a * a / (8. * roller_radius);
      const HertzLineContact hertz(2. * half_force, roller_radius, modulus);
      const Profile computed = solve(half_force);
      const double peak = std::abs(computed.peak / hertz.max_pressure() - 1.);
      const double half_width = std::abs(computed.half_width / hertz.half_width() - 1.);
      std::cout << "a/R = " << a << ": p0 " << computed.peak << " (Hertz " << hertz.max_pressure()
                << "), deviation / (a/R)^2 " << peak / (a * a) << "; half-width " << computed.half_width
                << ", deviation / (a/R)^2 " << half_width / (a * a) << '\n';
      EXPECT_GT(computed.peak, hertz.max_pressure());
      EXPECT_LT(computed.half_width, hertz.half_width());
      table.add(a, {peak, half_width});
    }
    table.print();
    EXPECT_NEAR(table.overall_rate(0), 2., .05);
    // Half-widths feel the meshes too: contact ends within a part.
    EXPECT_NEAR(table.overall_rate(1), 2., .2);
    EXPECT_LT(table.last_error(0), .0025); // .25 (a/R)^2 with (a/R)^2 = 0.005
    EXPECT_LT(table.last_error(1), .0025);
  }
} // namespace
