// SPDX-License-Identifier: LGPL-2.1-or-later
// The schemes on springs in place of bodies, whose contact is known in closed form: no finite elements.
#include <abut/base/user_error.h>
#include <abut/decomposition/interface_solver.h>
#include <abut/decomposition/resultant_loading.h>

#include <gtest/gtest.h>

#include "spring_body.h"
#include "trace_testing.h"
#include <deque>

using namespace abut;

namespace
{
  using Index = Eigen::Index;

  constexpr double length = 2., below = .02, above = .05; // compliances of the springs
  constexpr double tolerance = 1e-10;

  /// A side of `length` at a height with its body below or above it.
  Trace top_at(const double height)
  {
    return make_line(length, 0., height, 4);
  }
  Trace bottom_at(const double height, const unsigned int n_segments = 6)
  {
    return make_line(0., length, height, n_segments);
  }

  SpringBase moved(const double x, const double y)
  {
    SpringBase base;
    base.displacement = {x, y};
    return base;
  }
  SpringBase loaded(const double force, const double support_stiffness = 0.)
  {
    SpringBase base;
    base.is_free = true;
    base.force = force;
    base.support_stiffness = support_stiffness;
    return base;
  }

  DecompositionParameters parameters_of(const std::string &scheme)
  {
    DecompositionParameters parameters;
    parameters.scheme = scheme;
    parameters.tolerance = tolerance;
    return parameters;
  }

  /// Rows of springs one above the other; each is the slave of the next.
  class SpringStack
  {
  public:
    SpringStack(std::vector<SpringBody> bodies, const double penalty,
                std::unique_ptr<const ContactLaw> law = std::make_unique<FrictionlessLaw>())
        : bodies_(std::move(bodies))
    {
      for (std::size_t i = 0; i + 1 < bodies_.size(); ++i)
      {
        ContactDescription &contact = contacts_.emplace_back();
        contact.name = bodies_[i].name() + " under " + bodies_[i + 1].name();
        contact.penalty = penalty;
        const std::size_t top = bodies_[i].contact_sides().size() - 1;
        surfaces_.emplace_back(
            std::vector<PairInput>{{&contact, &placement_, contact_body(i, top), contact_body(i + 1, 0)}});
      }
      std::vector<const TraceBody *> all;
      for (const SpringBody &body : bodies_)
        all.push_back(&body);
      problem_ = std::make_unique<InterfaceProblem>(all, surfaces_, std::move(law));
    }

    const InterfaceProblem &problem() const { return *problem_; }
    SchemeResult solve(const std::string &scheme, const double rigid_displacement = 0.) const
    {
      const InterfaceSolver solver(problem(), parameters_of(scheme));
      return solver.solve(problem().loads(rigid_displacement), {}, {});
    }

  private:
    ContactBody contact_body(const std::size_t body, const std::size_t side) const
    {
      // A layer of this depth yields as much as the springs.
      return {body, side, bodies_[body].contact_sides()[side], {1., 0.}, bodies_[body].compliance()};
    }

    std::vector<SpringBody> bodies_;
    std::deque<ContactDescription> contacts_;
    const Placement placement_;
    std::vector<ContactSurface> surfaces_;
    std::unique_ptr<InterfaceProblem> problem_;
  };

  /// Two rows of springs, `gap` apart, of which the upper one's base is given.
  SpringStack two_springs(const double gap, const SpringBase &upper, const double penalty)
  {
    return SpringStack(
        {SpringBody("lower", {top_at(0.)}, below, {}), SpringBody("upper", {bottom_at(gap)}, above, upper)},
        penalty);
  }

  /// One component of the multipliers on one surface is uniform.
  void expect_uniform(const SpringStack &springs, const SchemeResult &result, const std::size_t surface,
                      const double expected, const double scale, const Index component = normal_direction)
  {
    EXPECT_TRUE(result.converged()) << result.message;
    const Eigen::VectorXd found = springs.problem().of_surface(surface, result.traction, component);
    EXPECT_GT(found.size(), 0);
    EXPECT_LE((found.array() - expected).abs().maxCoeff(), 1e2 * tolerance * scale) << expected;
  }

  const std::vector<std::string> exact_schemes = {"conjugate", "newton"};

  /// What a penalty allows, and exact contact.
  std::vector<std::string> schemes_for(const double penalty)
  {
    std::vector<std::string> schemes = exact_schemes;
    if (penalty > 0.)
      schemes.emplace_back("neumann");
    return schemes;
  }
} // namespace

TEST(DecompositionSprings, TwoSpringsPressAsOne)
{
  constexpr double gap = .003, approach = .01;
  for (const double penalty : {0., .01, .1})
    for (const std::string &scheme : schemes_for(penalty))
    {
      const SpringStack springs = two_springs(gap, moved(0., -approach), penalty);
      const SchemeResult result = springs.solve(scheme);
      const double pressure = (approach - gap) / (below + above + penalty);
      expect_uniform(springs, result, 0, pressure, pressure);
      EXPECT_NEAR(springs.problem().normal_force(result.traction), pressure * length, 1e-6 * pressure);
      // The lower side goes down, the upper one less than its base: both along their own normals inwards.
      const auto normal = [&](const std::size_t body) -> Eigen::ArrayXd {
        return springs.problem().normal_displacements(result.response, body).array();
      };
      EXPECT_LT((normal(0) + below * pressure).abs().maxCoeff(), 1e-8 * approach);
      EXPECT_LT((normal(1) - (approach - above * pressure)).abs().maxCoeff(), 1e-8 * approach);
      EXPECT_LT((springs.problem().gaps(result.response).array() + penalty * pressure).abs().maxCoeff(),
                1e-8 * approach);
    }
}

TEST(DecompositionSprings, SpringsApartDoNotPress)
{
  for (const double penalty : {0., .01})
    for (const std::string &scheme : schemes_for(penalty))
    {
      const SpringStack springs = two_springs(.003, moved(0., -.002), penalty);
      const SchemeResult result = springs.solve(scheme);
      expect_uniform(springs, result, 0, 0., 0.);
      EXPECT_LT((springs.problem().gaps(result.response).array() - .001).abs().maxCoeff(), 1e-15);
    }
}

TEST(DecompositionSprings, AFloatingBodyPressesWithItsWeight)
{
  constexpr double gap = .003, weight = .4;
  for (const double penalty : {0., .01})
    for (const std::string &scheme : exact_schemes)
    {
      const SpringStack springs = two_springs(gap, loaded(-weight), penalty);
      const SchemeResult result = springs.solve(scheme);
      const double pressure = weight / length;
      expect_uniform(springs, result, 0, pressure, pressure);
      ASSERT_EQ(result.motions.size(), 1);
      EXPECT_NEAR(result.motions[0], -(gap + (below + above + penalty) * pressure), 1e-8 * gap);
    }
}

TEST(DecompositionSprings, WhatLiftsAFloatingBodyIsRefused)
{
  const SpringStack springs = two_springs(0., loaded(.4), 0.);
  for (const std::string &scheme : exact_schemes)
    EXPECT_THROW(springs.solve(scheme), UserError);
}

TEST(DecompositionSprings, ARigidSideWithAResultantSinksIntoTheSprings)
{
  constexpr double gap = .003, force = .4, stiffness = 25.;
  const SpringStack springs = two_springs(gap, loaded(-force, stiffness), .01);
  // stiffness a = -force + length p, (c_1 + c_2 + theta) p = -(gap + a)
  const double softness = (below + above + .01) / length,
               base = -(force * softness + gap) / (1. + stiffness * softness);
  const double pressure = (force + stiffness * base) / length;
  ASSERT_GT(pressure, 0.);
  for (const std::string &scheme : exact_schemes)
  {
    const SchemeResult result = springs.solve(scheme);
    expect_uniform(springs, result, 0, pressure, pressure);
    ASSERT_EQ(result.motions.size(), 1);
    EXPECT_NEAR(result.motions[0], base, 1e-8 * gap);
  }
  // The parallel Neumann scheme is given the displacement, which is sought outside.
  const auto force_at = [&](const double displacement) {
    const SchemeResult result = springs.solve("neumann", displacement);
    return stiffness * displacement - springs.problem().normal_force(result.traction);
  };
  EXPECT_NEAR(find_rigid_displacement(force_at, -force, gap, 1e-9, "upper"), base, 1e-7 * gap);
}

TEST(DecompositionSprings, ABlockBetweenTwoSprings)
{
  // A floating block in the middle, of the compliance 0.03 on both sides; open above where the upper base is
  // far away.
  constexpr double gap = .003, weight = .1, middle = .03, theta = .01;
  for (const double approach : {.02, .001})
  {
    const SpringStack springs({SpringBody("lower", {top_at(0.)}, below, {}),
                               SpringBody("block", {bottom_at(gap), top_at(1.)}, middle, loaded(-weight)),
                               SpringBody("upper", {bottom_at(1. + gap)}, above, moved(0., -approach))},
                              theta);
    const double k_1 = below + middle + theta, k_2 = middle + above + theta;
    const double base = -(weight / length + gap / k_1 + (approach - gap) / k_2) / (1. / k_1 + 1. / k_2);
    double upper = (approach - gap + base) / k_2, lower = -(gap + base) / k_1;
    if (upper < 0.)
    {
      upper = 0.;
      lower = weight / length;
    }
    EXPECT_EQ(upper > 0., approach > .01);
    for (const std::string &scheme : exact_schemes)
    {
      const SchemeResult result = springs.solve(scheme);
      expect_uniform(springs, result, 0, lower, lower);
      expect_uniform(springs, result, 1, upper, lower);
    }
  }
}

namespace
{
  /// Rough contact: what presses does not slide.
  class RoughLaw : public ContactLaw
  {
  public:
    Index n_components() const override { return 2; }
    Eigen::VectorXd project(const Eigen::VectorXd &multipliers) const override
    {
      Eigen::VectorXd result = multipliers;
      for (Index k = 0; k < result.size(); k += 2)
        if (!(result[k] > 0.))
          result.segment<2>(k).setZero();
      return result;
    }
    std::vector<bool> active(const Eigen::VectorXd &multipliers) const override
    {
      std::vector<bool> result;
      for (Index k = 0; k < multipliers.size(); ++k)
        result.push_back(multipliers[k - k % 2] > 0.);
      return result;
    }
    bool is_linear_complementarity() const override { return false; }
  };

  SpringStack rough_springs(const double gap, const double approach, const double shift, const double penalty)
  {
    return SpringStack({SpringBody("lower", {top_at(0.)}, below, {}),
                        SpringBody("upper", {bottom_at(gap)}, above, moved(shift, -approach))},
                       penalty, std::make_unique<RoughLaw>());
  }
} // namespace

TEST(DecompositionSprings, ALawWithATangentialComponent)
{
  constexpr double gap = .003, shift = .004, penalty = .02;
  const double softness = below + above + penalty;
  for (const double approach : {.01, .002})
  {
    const SpringStack springs = rough_springs(gap, approach, shift, penalty);
    const InterfaceProblem &problem = springs.problem();
    EXPECT_EQ(problem.layout().n_components(), 2);
    EXPECT_EQ(problem.layout().size(), 2 * problem.surfaces()[0].n_parts());
    const SchemeResult result = springs.solve("neumann");
    const bool presses = approach > gap;
    expect_uniform(springs, result, 0, presses ? (approach - gap) / softness : 0., 1., normal_direction);
    expect_uniform(springs, result, 0, presses ? shift / softness : 0., 1., tangential_direction);
    // The lower body is taken along to the right, the upper one held back.
    for (std::size_t body = 0; body < 2; ++body)
    {
      const Eigen::VectorXd forces = problem.contact_forces(body, result.traction);
      const double x = forces(Eigen::seqN(0, forces.size() / 2, 2)).sum();
      EXPECT_NEAR(x, presses ? (body == 0 ? 1. : -1.) * length * shift / softness : 0., 1e-8);
    }
  }
}

TEST(DecompositionSprings, SchemesForPressuresAloneRefuseAnotherLaw)
{
  const SpringStack springs = rough_springs(0., .01, .004, .02);
  for (const std::string &scheme : exact_schemes)
    EXPECT_THROW(springs.solve(scheme), UserError);
}
