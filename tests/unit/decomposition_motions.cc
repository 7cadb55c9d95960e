// SPDX-License-Identifier: LGPL-2.1-or-later
// Motions that contact holds, hardly notices, or leaves free.
#include <abut/base/user_error.h>
#include <abut/decomposition/motion_terms.h>

#include <gtest/gtest.h>

#include "decomposition_testing.h"

using namespace abut;

namespace
{
  using Index = Eigen::Index;

  const std::vector<std::string> meshes = {"Body upper/Cells=24, 6", "Body lower/Cells=32, 8"};

  /// Two motions of one body: a lift that opens the gaps of all but `n_other` nodes at the ends, and a slip
  /// that they hardly notice, closing one half of them and opening the other. With other nodes a third
  /// motion, of another body, that opens the gaps there, under a load of a million.
  InterfaceMotions motions_of(const InterfaceProblem &problem, const double noticed, const double load,
                              const Index n_other)
  {
    const Index n = problem.n_pressures(), first = n_other / 2, own = n - n_other, half = own / 2,
                size = n_other > 0 ? 3 : 2;
    const Eigen::VectorXd &weights = problem.weights();
    InterfaceMotions motions;
    motions.responses = Eigen::MatrixXd::Zero(problem.response_size(), size);
    motions.responses.col(0).segment(first, own) = weights.segment(first, own);
    motions.responses.col(1).segment(first, half) = noticed * weights.segment(first, half);
    motions.responses.col(1).segment(first + own - half, half) =
        -noticed * weights.segment(first + own - half, half);
    const auto own_normals = [&](const std::size_t body) {
      return Eigen::seqN(problem.normal_displacement_offset(body), problem.bodies()[body]->trace_size() / 2);
    };
    motions.responses(own_normals(0), 0).setConstant(-1.);
    const Index n_nodes = problem.bodies()[0]->trace_size() / 2;
    motions.responses(own_normals(0), 1) = Eigen::VectorXd::NullaryExpr(
        n_nodes, [&](const Index i) { return 2 * i < n_nodes ? noticed : -noticed; });
    if (n_other > 0)
      motions.responses(own_normals(1), 2).setConstant(-1.);
    motions.stiffness = Eigen::MatrixXd::Zero(size, size);
    motions.loads = Eigen::VectorXd::Zero(size);
    motions.loads.head(2) << -1., load;
    motions.names = {"lift", "slip"};
    motions.offsets = {0, 2, size};
    if (n_other > 0)
    {
      motions.responses.col(2).head(first) = weights.head(first);
      motions.responses.col(2).tail(first) = weights.tail(first);
      motions.loads[2] = -1e6;
      motions.names.emplace_back("other");
    }
    return motions;
  }
} // namespace

TEST(DecompositionMotions, LoadsOnMotionsThatAreHardlyNoticed)
{
  const TwoLayers layers(meshes);
  const InterfaceProblem &problem = layers.problem();
  for (const Index n_other : {0, 10}) // what acts on another body changes nothing
  {
    std::vector<Index> held = {0};
    if (n_other > 0)
      held.push_back(2);
    const auto with = [&](const double noticed, const double load) {
      return held_motions(problem, motions_of(problem, noticed, load, n_other));
    };
    EXPECT_EQ(with(1e-4, 1e-12).indices, held);
    EXPECT_TRUE(with(1e-4, 1e-12).dropped_loads.empty());
    EXPECT_EQ(with(1e-4, 3e-4).indices, held);
    ASSERT_EQ(with(1e-4, 3e-4).dropped_loads.size(), 1u);
    EXPECT_NE(with(1e-4, 3e-4).dropped_loads[0].find("slip hardly changes a gap"), std::string::npos);
    EXPECT_THROW(with(1e-4, 5e-3), UserError);
    EXPECT_EQ(with(.1, 0.).indices.size(), held.size() + 1);
  }
}

TEST(DecompositionMotions, AnotherBodysLoadsHideNoImbalance)
{
  // A lift that pulls, beside a million that presses another body.
  const TwoLayers layers(meshes);
  InterfaceMotions motions = motions_of(layers.problem(), .1, 0., 10);
  EXPECT_NO_THROW(held_motions(layers.problem(), motions));
  motions.loads[0] = .05;
  EXPECT_THROW(held_motions(layers.problem(), motions), UserError);
}

TEST(DecompositionMotions, AFarMotionHidesNoImbalance)
{
  // One body that falls by 1 on stiff layers: 4 % of its weight is no round-off.
  MotionTerms motions;
  motions.gaps = Eigen::MatrixXd::Constant(1, 1, -1.);
  motions.reach = Eigen::MatrixXd::Ones(1, 1);
  motions.stiffness = Eigen::MatrixXd::Zero(1, 1);
  motions.loads = motions.layer_stiffness = Eigen::VectorXd::Ones(1);
  motions.layer_stiffness *= 1e9;
  const Eigen::VectorXd amplitudes = Eigen::VectorXd::Ones(1);
  EXPECT_FALSE(motions.is_balanced(Eigen::VectorXd::Constant(1, .96), amplitudes));
  EXPECT_TRUE(motions.is_balanced(Eigen::VectorXd::Constant(1, 1. + 1e-11), amplitudes));
  EXPECT_TRUE(motions.is_balanced(Eigen::VectorXd::Constant(1, 1. + 1e-6), amplitudes)); // round-off
}
