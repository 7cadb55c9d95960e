// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What holds on any pair of sides, with random numbers: bodies apart do not press, it does not matter which
// side is the slave or how the scene is turned, forces do not jump with the cover.
#include <gtest/gtest.h>

#include "program.h"
#include <cmath>
#include <random>
#include <sstream>

using namespace abut::testing;

namespace
{
  const double pi = std::acos(-1.);

  /// A rectangle turned by its own angle about its lower left corner, which stands at (x, y); all turned by
  /// `turn`.
  struct TurnedBlock
  {
    double x, y, width, height, angle;
    unsigned int columns, rows;
    double modulus;
    std::string conditions;
  };

  std::string block_section(const std::string &name, const TurnedBlock &block, const double turn)
  {
    const double c = std::cos(turn * pi / 180.), s = std::sin(turn * pi / 180.);
    std::ostringstream text;
    text.precision(17);
    text << "subsection Body " << name << "\n set Size = " << block.width << ", " << block.height
         << "\n set Rotation angle = " << block.angle + turn << "\n set Shift = " << c * block.x - s * block.y
         << ", " << s * block.x + c * block.y << "\n set Cells = " << block.columns << ", " << block.rows
         << "\n set Young modulus = " << block.modulus
         << "\n set Poisson ratio = 0.3\n set Conditions = " << block.conditions << "\nend\n";
    return text.str();
  }

  Answer solve(const TurnedBlock &upper, const TurnedBlock &lower, const unsigned int degree,
               const bool swapped, const double turn, const std::string &gap = "geometry")
  {
    const std::string upper_side = "upper:bottom", lower_side = "lower:top";
    return run({temporary_file(
        "scene.prm",
        "set Bodies = upper, lower\nset Contacts = c\nsubsection Discretisation\n set Degree = " +
            std::to_string(degree) + "\nend\n" + block_section("upper", upper, turn) +
            block_section("lower", lower, turn) +
            "subsection Contact c\n set Slave = " + (swapped ? upper_side : lower_side) +
            "\n set Master = " + (swapped ? lower_side : upper_side) + "\n set Gap = " + gap +
            "\nend\nsubsection Decomposition\n set Interface compliance = dense\nend\n")});
  }

  double c_value(const Answer &answer, const std::string &key)
  {
    return contact(answer, "c")[key].get<double>();
  }

  double stress(const Answer &answer, const std::size_t body)
  {
    return answer.summary["bodies"][body]["max_von_mises"].get<double>();
  }

  class Random
  {
  public:
    explicit Random(const unsigned int seed) : generator_(seed) {}
    double between(const double low, const double high)
    {
      return std::uniform_real_distribution<double>(low, high)(generator_);
    }
    double power(const double low, const double high) { return std::pow(10., between(low, high)); }
    unsigned int count(const unsigned int low, const unsigned int high)
    {
      return std::uniform_int_distribution<unsigned int>(low, high)(generator_);
    }
    bool coin() { return between(0., 1.) < .5; }

  private:
    std::mt19937 generator_;
  };
} // namespace

TEST(ContactProperties, BodiesThatAreApartDoNotPress)
{
  Random random(1);
  for (int trial = 0; trial < 60; ++trial)
  {
    // A tilted block whose lowest corner stays above the other one.
    const double angle = random.between(-50., 50.), distance = random.power(-6., -1.);
    const double width = random.between(.3, 1.5);
    const double lowest = std::min(0., width * std::sin(angle * pi / 180.));
    const TurnedBlock upper{random.between(0., 1.),
                            1. - lowest + distance,
                            width,
                            1.,
                            angle,
                            random.count(1, 12),
                            random.count(1, 4),
                            random.power(0., 6.),
                            "top: displacement: 0, 0"};
    const TurnedBlock lower{0., 0., 2., 1., 0., random.count(1, 30), 2, 1e3, "bottom: displacement: 0, 0"};
    const Answer answer =
        solve(upper, lower, random.count(1, 3), random.coin(), random.coin() ? 0. : random.between(0., 360.));
    ASSERT_EQ(answer.status, 0) << answer.err;
    EXPECT_EQ(c_value(answer, "normal_force"), 0.) << trial;
    EXPECT_GE(c_value(answer, "min_gap"), distance * (1. - 1e-6)) << trial;
    EXPECT_EQ(warning_codes(answer), std::multiset<std::string>{"nothing-touches"}) << answer.err;
  }
}

TEST(ContactProperties, SlaveAndMasterMayBeSwapped)
{
  Random random(2);
  for (int trial = 0; trial < 40; ++trial)
  {
    const unsigned int coarse = random.count(4, 24), ratio = random.count(1, 16);
    const bool fine_above = random.coin();
    const double modulus = random.power(-6., 6.);
    const double left = random.coin() ? 0. : random.between(0., .3), width = 2. - random.between(0., .6);
    const TurnedBlock upper{left,
                            1.,
                            width,
                            1.,
                            0.,
                            fine_above ? coarse * ratio : coarse,
                            3,
                            1e3 * std::sqrt(modulus),
                            "top: displacement: 0, -0.01"};
    const TurnedBlock lower{0.,
                            0.,
                            2.,
                            1.,
                            0.,
                            fine_above ? coarse : coarse * ratio,
                            3,
                            1e3 / std::sqrt(modulus),
                            "bottom: displacement: 0, 0"};
    const unsigned int degree = coarse * ratio > 128 ? 1 : random.count(1, 3);
    // The gap is a function of the slave's own x: both bodies begin at the same place where it is not even.
    const std::string gap = left == 0. ? "0.004*x^2" : "0";
    const Answer one = solve(upper, lower, degree, false, 0., gap),
                 two = solve(upper, lower, degree, true, 0., gap);
    ASSERT_EQ(one.status, 0) << one.err;
    ASSERT_EQ(two.status, 0) << two.err;
    EXPECT_GT(c_value(one, "normal_force"), 0.);
    for (const std::string key : {"normal_force", "max_pressure", "contact_length"})
      EXPECT_NEAR(c_value(two, key) / c_value(one, key), 1., 1e-9)
          << key << ", trial " << trial << ": degree " << degree << ", " << upper.columns << " on "
          << lower.columns << " cells, E " << upper.modulus << ", " << lower.modulus << ", x " << left
          << " to " << left + width;
    for (const std::size_t body : {0u, 1u})
      EXPECT_NEAR(stress(two, body) / stress(one, body), 1., 1e-9) << trial;
  }
}

TEST(ContactProperties, TurnedScenesChooseAlike)
{
  Random random(3);
  for (int trial = 0; trial < 30; ++trial)
  {
    const unsigned int n = random.count(3, 20);
    const TurnedBlock upper{
        .5, 1., 1., 1., 0., n, 3, random.coin() ? 1e3 : random.power(0., 6.), "top: displacement: 0, -0.01"};
    // Aligned, equal, or any: ties are to be decided alike.
    const TurnedBlock lower{0., 0.,  2.,
                            1., 0.,  random.coin() ? 2 * n : random.count(3, 40),
                            3,  1e3, "bottom: displacement: 0, 0"};
    const unsigned int degree = random.count(1, 3);
    const bool swapped = random.coin();
    const Answer one = solve(upper, lower, degree, swapped, 0.),
                 two = solve(upper, lower, degree, swapped, random.between(0., 360.));
    ASSERT_EQ(two.status, 0) << two.err;
    for (const std::string key : {"normal_force", "max_pressure", "contact_length"})
      EXPECT_NEAR(c_value(two, key) / c_value(one, key), 1., 1e-8) << key << ' ' << trial;
  }
}

TEST(ContactProperties, TheForceDoesNotJumpWithTheCover)
{
  // A punch whose edge covers a share of a cell of the block, from all of it to 1e-12.
  Random random(4);
  for (int trial = 0; trial < 24; ++trial)
  {
    const auto degree = static_cast<unsigned int>(1 + trial % 3);
    const double cell = .1, modulus = random.power(-6., 6.);
    const auto punch = [&](const double cover) {
      return TurnedBlock{0.,
                         2.,
                         1. + cover * cell,
                         1.,
                         0.,
                         10,
                         6,
                         modulus >= 1. ? 1e3 * modulus : 1e3,
                         "left: normal displacement: 0; top: displacement y: -0.01"};
    };
    const TurnedBlock block{0.,
                            0.,
                            3.,
                            2.,
                            0.,
                            30,
                            10,
                            modulus >= 1. ? 1e3 : 1e3 / modulus,
                            "left: normal displacement: 0; bottom: displacement: 0, 0"};
    const double cover = random.power(-12., 0.);
    const bool swapped = random.coin();
    const Answer none = solve(punch(0.), block, degree, swapped, 0.),
                 some = solve(punch(cover), block, degree, swapped, 0.);
    ASSERT_EQ(some.status, 0) << some.err;
    // The force grows like the punch; to be neither found twice nor lost.
    EXPECT_NEAR(c_value(some, "normal_force") / c_value(none, "normal_force"), 1. + .1 * cover, .02) << cover;
    EXPECT_LT(c_value(some, "max_pressure"), 1.6 * c_value(none, "max_pressure")) << cover << ' ' << modulus;
  }
}
