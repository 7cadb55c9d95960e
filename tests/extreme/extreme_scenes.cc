// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Stiff, nearly incompressible, tiny and huge scenes: right results, or a message; never nonsense.

#include <abut/base/material.h>

#include <gtest/gtest.h>

#include "../regression/program.h"
#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

namespace
{
  using abut::testing::Answer;
  using abut::testing::column;
  using abut::testing::run_scene;

  Answer patch(const std::vector<std::string> &overrides)
  {
    return run_scene("patch-test", overrides);
  }

  /// Upper and lower block.
  struct Materials
  {
    double e1, nu1, e2, nu2;
  };

  /// p = Delta/(sum (1 - nu^2) H/E + theta), theta = (c/2) sum H/E, for blocks of height 1 and approach 1e-3.
  double patch_pressure(const Materials &m, const double c)
  {
    return 1e-3 /
           ((1. - m.nu1 * m.nu1) / m.e1 + (1. - m.nu2 * m.nu2) / m.e2 + .5 * c * (1. / m.e1 + 1. / m.e2));
  }

  const std::vector<std::string> schemes = {"neumann", "conjugate", "newton"};

  /// What is allowed; pressures relative to the exact one.
  struct Limits
  {
    double at_a_node = 1e-9, mean = 1e-9; ///< deviation of the pressure
    double residual = 1e-10;              ///< of a body's equilibrium
  };

  struct Deviation
  {
    double largest = 0., mean = 0.;
  };

  Deviation deviation_from(const double exact, const std::string &file)
  {
    const std::vector<double> pressures = column(file, "pressure"), places = column(file, "arc_length");
    Deviation result;
    for (std::size_t i = 0; i < pressures.size(); ++i)
    {
      const double deviation = pressures[i] / exact - 1.;
      result.largest = std::max(result.largest, std::abs(deviation));
      const double share =
          places[std::min(i + 1, places.size() - 1)] - places[i - std::min<std::size_t>(i, 1)];
      result.mean += .5 * share / (places.back() - places.front()) * deviation;
    }
    return result;
  }

  /// By every scheme, with a penalty and, but for neumann, without.
  void expect_uniform(const std::vector<std::string> &overrides, const Materials &materials,
                      const Limits &limits = {})
  {
    for (const std::string &scheme : schemes)
      for (const double c : {.05, 0.})
      {
        if (scheme == "neumann" && c == 0.)
          continue;
        SCOPED_TRACE(scheme + ", c = " + std::to_string(c));
        std::vector<std::string> all = {"Decomposition/Scheme=" + scheme,
                                        "Contact interface/Penalty coefficient=" + std::to_string(c)};
        all.insert(all.end(), overrides.begin(), overrides.end());
        const Answer answer = patch(all);
        ASSERT_EQ(answer.status, 0) << answer.err;
        const Deviation deviation =
            deviation_from(patch_pressure(materials, c), answer.directory + "/contact_interface.csv");
        EXPECT_LT(deviation.largest, limits.at_a_node);
        EXPECT_LT(std::abs(deviation.mean), limits.mean);
        for (const auto &body : answer.summary["bodies"])
          EXPECT_LT(body["equilibrium_residual"].get<double>(), limits.residual);
        std::cout << scheme << ", c = " << c << ": largest relative deviation of the pressure "
                  << deviation.largest << " of " << limits.at_a_node << ", mean " << deviation.mean << '\n';
      }
  }

  /**
   * How many times its size in the energy norm, both relative to the uniform pressure p, an error e of the
   * pressure can have at one node. With the compliance Z of the interface, |e|_Z^2 = e.Ze:
   *     |e_i| <= |e|_Z sqrt((Z^-1)_ii), (Z^-1)_ii <= k/w^2, |p|_Z^2 = p^2 sum (1 - nu^2) H/E
   * for sides of length 1, where w is the node's share of the slave's side and k what its body, stiffer by
   * the master and all other nodes being held, resists to that node's normal displacement. k/w^2 is largest
   * at the ends of the side, with the stiffness of one bilinear cell. Flat cells resist by shear: the factor
   * is some 1/width times the root of height over width.
   */
  double node_per_energy(const Materials &m, const double width, const double height)
  {
    const abut::Material slave{m.e2, m.nu2};
    const double k =
        (slave.lambda() + 2. * slave.mu()) * width / (3. * height) + slave.mu() * height / (3. * width);
    const double uniform = (1. - m.nu1 * m.nu1) / m.e1 + (1. - m.nu2 * m.nu2) / m.e2;
    return std::sqrt(uniform * k) / (.5 * width);
  }
} // namespace

TEST(Extreme, StiffnessContrastOfAMillionMillion)
{
  expect_uniform({"Body upper/Young modulus=1e8", "Body lower/Young modulus=1e-4"}, {1e8, .3, 1e-4, .3});
}

TEST(Extreme, NearlyIncompressible)
{
  // The layers of the initial guess are stiff without end here: the first steps only let its pressure decay.
  // Forces are differences of products with lambda = 5e6 mu: round-off leaves some 5e6 times 2e-16 of them,
  // so that no scheme comes to the file's 1e-12 without a penalty. Pressures: the backward error of Cholesky
  // for the 32 unknowns of a body, 32 times 1.1e-16, times the condition lambda/mu.
  constexpr double nu = .4999999;
  constexpr double lambda_per_mu = 2. * nu / (1. - 2. * nu);
  constexpr double round_off = 32. * .5 * std::numeric_limits<double>::epsilon() * lambda_per_mu;
  expect_uniform({"Body upper/Poisson ratio=0.4999999", "Body lower/Poisson ratio=0.4999999",
                  "Decomposition/Tolerance=1e-9"},
                 {100., nu, 100., nu}, {round_off, round_off, 5e-9});
}

TEST(Extreme, NegativePoissonRatio)
{
  expect_uniform({"Body upper/Poisson ratio=-0.9"}, {100., -.9, 100., .3});
}

TEST(Extreme, MicrometresAndKilometres)
{
  for (const std::string scale : {"1e-6", "1e6"})
    expect_uniform({"Body upper/Scale=" + scale, "Body lower/Scale=" + scale, "Body upper/Shift=0, " + scale},
                   {100., .3, 100., .3});
}

TEST(Extreme, NumbersNearTheEndsOfTheRange)
{
  for (const std::string modulus : {"1e-100", "1e100"})
    expect_uniform({"Body upper/Young modulus=" + modulus, "Body lower/Young modulus=" + modulus},
                   {std::stod(modulus), .3, std::stod(modulus), .3});
}

TEST(Extreme, ARigidBody)
{
  expect_uniform({"Body upper/Young modulus=1e300"}, {1e300, .3, 100., .3});
}

TEST(Extreme, FlatCells)
{
  // The tolerance is one of the energy norm; below 1e-9 it is beyond the scheme conjugate here. The mean of
  // the pressure has to keep it, since a uniform pressure is answered by a uniform gap. The pressure of one
  // node costs little energy: a scheme may leave 1.9e-6 there, and rounding decides with which step it ends.
  constexpr double tolerance = 1e-9;
  const Materials materials{100., .3, 100., .3};
  expect_uniform({"Body upper/Cells=3, 300", "Body lower/Cells=200, 2", "Decomposition/Tolerance=1e-9"},
                 materials, {tolerance * node_per_energy(materials, 1. / 200., 1. / 2.), tolerance});
}

TEST(Extreme, ApartAndNeverTouching)
{
  const Answer answer = patch({"Contact interface/Gap=0.5"});
  ASSERT_EQ(answer.status, 0) << answer.err;
  EXPECT_EQ(answer.summary["contacts"][0]["normal_force"], 0.);
  EXPECT_EQ(answer.summary["contacts"][0]["contact_length"], 0.);
  EXPECT_EQ(answer.summary["status"], "converged");
}

TEST(Extreme, AdaptedMeshesDoNotDependOnUnitsAndContrast)
{
  // Lengths, both moduli, or one of them: on equal layers of nu = 0.3 the stiffness ratio changes no shape.
  const std::vector<std::string> adaptive = {"Body upper/Cells=16, 4",
                                             "Body lower/Cells=16, 4",
                                             "Body upper/Adapt=true",
                                             "Body lower/Adapt=true",
                                             "Adaptation/Estimator=spr",
                                             "Adaptation/Maximum passes=6",
                                             "Contact interface/Penalty coefficient=5e-3"};
  const auto layers = [&](std::vector<std::string> overrides) {
    overrides.insert(overrides.end(), adaptive.begin(), adaptive.end());
    return run_scene("two-layers-rollers", overrides);
  };
  const Answer plain = layers({});
  ASSERT_EQ(plain.status, 0) << plain.err;
  const double error = plain.summary["true_error"]["energy"];
  for (const std::vector<std::string> &change : std::vector<std::vector<std::string>>{
           {"Body upper/Young modulus=2.1e13"},
           {"Body lower/Young modulus=2.1e-3"},
           {"Body upper/Scale=1e-6", "Body lower/Scale=1e-6", "Body upper/Shift=0, 1e-6"},
           {"Body upper/Scale=1e6", "Body lower/Scale=1e6", "Body upper/Shift=0, 1e6"}})
  {
    const Answer answer = layers(change);
    ASSERT_EQ(answer.status, 0) << answer.err;
    EXPECT_EQ(answer.summary["pass_table"].back()["dofs"], plain.summary["pass_table"].back()["dofs"])
        << change[0];
    EXPECT_NEAR(answer.summary["true_error"]["energy"].get<double>(), error, 1e-8 * error) << change[0];
  }
}

TEST(Extreme, TheEstimateSeesLocking)
{
  // Linear triangles lock at nu = 0.4999: half of the energy is error, and the estimate says so.
  const Answer answer = run_scene(
      "two-layers-rollers",
      {"Body upper/Cells=16, 4", "Body lower/Cells=16, 4", "Body upper/Adapt=true", "Body lower/Adapt=true",
       "Adaptation/Estimator=spr", "Adaptation/Maximum passes=6",
       "Contact interface/Penalty coefficient=5e-3", "Body upper/Poisson ratio=0.4999",
       "Body lower/Poisson ratio=0.4999", "Body upper/Cell type=triangles", "Body lower/Cell type=triangles",
       "Body upper/Allow locking=true", "Body lower/Allow locking=true"});
  ASSERT_EQ(answer.status, 0) << answer.err;
  EXPECT_GT(answer.summary["true_error"]["energy"].get<double>(), .2);
  EXPECT_NEAR(answer.summary["error"]["effectivity"].get<double>(), 1., .1);
}

TEST(Extreme, ATolerancePastRoundOffEndsWithAMessage)
{
  const Answer answer = patch({"Decomposition/Tolerance=1e-30"});
  EXPECT_EQ(answer.status, 2);
  EXPECT_NE(answer.err.find("round-off"), std::string::npos) << answer.err;
  EXPECT_EQ(answer.summary["status"], "not converged");
}

TEST(Extreme, AForceThatNothingCarries)
{
  // The upper block is pulled up, but contact cannot hold it down.
  const std::string pull = "Body upper/Conditions=left: normal displacement: 0; top: resultant: 0, 5";
  const Answer secant = patch({pull, "Decomposition/Scheme=neumann"});
  EXPECT_EQ(secant.status, 2);
  EXPECT_NE(secant.err.find("no displacement of the rigid side carries the force"), std::string::npos)
      << secant.err;
  EXPECT_TRUE(secant.summary.is_null());
  for (const std::string scheme : {"newton", "conjugate"})
  {
    const Answer answer = patch({pull, "Decomposition/Scheme=" + scheme});
    EXPECT_EQ(answer.status, 1);
    EXPECT_NE(answer.err.find("no pressures that push balance the loads: a resultant of 5 along it"),
              std::string::npos)
        << answer.err;
    EXPECT_TRUE(answer.summary.is_null());
  }
}

TEST(Extreme, AForceIsCarriedWhateverTheStiffness)
{
  for (const std::string modulus : {"1e-3", "1e6"})
    for (const std::string &scheme : schemes)
    {
      const Answer answer =
          patch({"Body upper/Conditions=left: normal displacement: 0; top: resultant: 0, -7",
                 "Body upper/Young modulus=" + modulus, "Decomposition/Scheme=" + scheme});
      ASSERT_EQ(answer.status, 0) << answer.err;
      EXPECT_NEAR(answer.summary["contacts"][0]["normal_force"].get<double>(), 7., 7e-9) << scheme;
    }
}
