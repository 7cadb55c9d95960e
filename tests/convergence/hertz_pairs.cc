// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Hertz's line contact between any two bodies: half and whole models, either side the slave, rigid and soft,
// flat and round, like and unlike. Both bodies are as large as the radius, so that their deviation from
// half-planes is of the order (a/R)^2 too.
#include <abut/reference/hertz.h>
#include <abut/run/simulation.h>

#include <gtest/gtest.h>

#include "../unit/scene_file.h"
#include <cmath>
#include <iomanip>
#include <iostream>
#include <sstream>

using namespace abut;

namespace
{
  struct Elastic
  {
    double modulus, poisson_ratio;
  };

  struct HertzCase
  {
    std::string name;
    Elastic upper, lower;
    double lower_radius; ///< 0: flat
    bool whole;
    bool upper_is_slave;
  };

  /// A body 1 high whose top is an arc of the given radius (0: flat), standing on its bottom; from x = 0 or,
  /// whole, from -width.
  std::string round_body(const std::string &name, const double radius, const double width, const bool whole,
                         const Elastic &material, const unsigned int columns, const std::string &placement,
                         const std::string &conditions)
  {
    std::ostringstream text;
    text.precision(17);
    const double middle = whole ? width : 0.;
    text << "subsection Body " << name << "\n set Size = " << (whole ? 2. : 1.) * width << ", 1\n";
    if (radius > 0.)
      text << " set Shape = rectangle with curved top\n set Top = sqrt(" << radius << "^2 - (x - " << middle
           << ")^2) + 1 - " << radius << '\n';
    text << placement << " set Cells = " << (whole ? 4 * columns : columns)
         << ", 32\n set Grading = " << (whole ? 1 : 40)
         << ", 0.025\n set Young modulus = " << material.modulus
         << "\n set Poisson ratio = " << material.poisson_ratio << "\n set Conditions = " << conditions
         << "\nend\n";
    return text.str();
  }

  std::string scene_of(const HertzCase &c, const double force)
  {
    std::ostringstream text;
    text.precision(17);
    const std::string upper = "upper:top", lower = "lower:top";
    text << "set Bodies = upper, lower\nset Contacts = c\n"
         << "subsection Contact c\n set Slave = " << (c.upper_is_slave ? upper : lower)
         << "\n set Master = " << (c.upper_is_slave ? lower : upper)
         << "\nend\nsubsection Decomposition\n set Tolerance = 1e-9\nend\n";
    std::ostringstream load;
    load.precision(17);
    load << "bottom: resultant: " << -(c.whole ? force : .5 * force)
         << (c.whole ? "; bottom: tangential displacement: 0" : "; left: normal displacement: 0");
    const double wide = .8, base = c.lower_radius > 0. ? .9 * std::min(1., c.lower_radius) : 1.;
    std::ostringstream shift;
    shift << " set Shift = " << (c.whole ? -base : 0.) << ", 0\n";
    std::ostringstream upside_down;
    upside_down << " set Mirror = true\n set Rotation angle = 180\n set Shift = " << (c.whole ? -wide : 0.)
                << ", 2\n";
    text << round_body("upper", 1., wide, c.whole, c.upper, 64, upside_down.str(), load.str())
         << round_body("lower", c.lower_radius, base, c.whole, c.lower, 80, shift.str(),
                       c.whole ? "bottom: displacement: 0, 0"
                               : "left: normal displacement: 0; bottom: normal displacement: 0");
    return text.str();
  }

  /// Relative deviations from Hertz, and the share of the load that goes sideways.
  struct HertzDeviation
  {
    double peak, half_width, side;
  };

  HertzDeviation deviation_from_hertz(const HertzCase &c, const double a)
  {
    const double modulus =
        composite_modulus(c.upper.modulus, c.upper.poisson_ratio, c.lower.modulus, c.lower.poisson_ratio);
    const double radius = c.lower_radius > 0. ? 1. / (1. + 1. / c.lower_radius) : 1.;
    const double force = std::acos(-1.) * modulus * a * a / (4. * radius);
    const HertzLineContact hertz(force, radius, modulus);
    const SceneFile file(scene_of(c, force));
    const Scene scene = file.read();
    Simulation simulation(scene);
    const Results results = simulation.run({});
    EXPECT_TRUE(results.converged()) << results.message();
    const PairResult &pair = results.pairs.front();
    const Eigen::VectorXd forces = pair.pair->weights().cwiseProduct(pair.loads);
    // p^2 is linear in x^2: fitted inside .7 a.
    double second_moment = 0., n = 0., sx = 0., sy = 0., sxx = 0., sxy = 0.;
    for (const std::size_t k : pair.parts)
    {
      const Part &part = pair.part(k);
      const auto i = static_cast<Eigen::Index>(k);
      second_moment += forces[i] * (std::pow(part.middle.x(), 2) + part.length * part.length / 12.);
      if (std::abs(part.place.x()) > .7 * a)
        continue;
      const double x = part.place.x() * part.place.x(), y = pair.pressures[i] * pair.pressures[i];
      n += 1.;
      sx += x;
      sy += y;
      sxx += x * x;
      sxy += x * y;
    }
    const double slope = (n * sxy - sx * sy) / (n * sxx - sx * sx), peak = std::sqrt((sy - slope * sx) / n);
    return {peak / hertz.max_pressure() - 1.,
            2. * std::sqrt(second_moment / forces.sum()) / hertz.half_width() - 1.,
            std::abs(pair.force.x()) / pair.normal_force};
  }
} // namespace

TEST(HertzPairs, DeviateByTheSquareOfHalfWidthOverRadius)
{
  const Elastic rubber{1., .3}, steel{1e6, .3}, jelly{1., .45}, cork{1., 0.};
  std::vector<HertzCase> cases;
  for (const bool whole : {false, true})
    for (const bool upper_is_slave : {true, false})
    {
      cases.push_back({"roller and flat alike", rubber, rubber, 0., whole, upper_is_slave});
      cases.push_back({"soft roller on rigid flat", rubber, steel, 0., whole, upper_is_slave});
      cases.push_back({"rigid roller on soft flat", steel, rubber, 0., whole, upper_is_slave});
      cases.push_back({"cork roller on jelly", cork, jelly, 0., whole, upper_is_slave});
      cases.push_back({"roller on roller", rubber, rubber, 1., whole, upper_is_slave});
      cases.push_back({"cork on half as large jelly", cork, jelly, .5, whole, upper_is_slave});
    }
  for (const HertzCase &c : cases)
  {
    std::cout << std::left << std::setw(28) << c.name << (c.whole ? "whole, " : "half,  ")
              << (c.upper_is_slave ? "upper" : "lower") << " slave:" << std::right << std::setprecision(3);
    for (const double a : {.05, .1, .2})
    {
      const HertzDeviation d = deviation_from_hertz(c, a);
      const double square = a * a;
      std::cout << "  a/R " << a << ": p0 " << std::setw(7) << d.peak / square << ", a " << std::setw(7)
                << d.half_width / square << ", side " << std::setw(8) << d.side;
      // What the meshes add: contact ends within a part.
      const double cell = c.whole ? 1.6 / (4. * 64.) : .8 / 64. / 5.;
      EXPECT_LT(std::abs(d.peak), square + .03 * cell / a) << c.name << ' ' << a;
      EXPECT_LT(std::abs(d.half_width), square + .1 * cell / a) << c.name << ' ' << a;
      if (c.lower_radius == 0.)
      {
        EXPECT_LT(d.side, 1e-6) << c.name << ' ' << a;
      }
    }
    std::cout << '\n' << std::setprecision(6);
  }
}
