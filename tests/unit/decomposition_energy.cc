// SPDX-License-Identifier: LGPL-2.1-or-later
// Exact contact minimises the energy among all displacements that do not penetrate.
#include <abut/decomposition/interface_solver.h>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "decomposition_testing.h"
#include <cmath>
#include <random>

using namespace abut;

namespace
{
  using Index = Eigen::Index;

  /// Strain energy of the displacements that answer pressures and further forces on the contact sides: with
  /// prescribed displacements alone, F(u).
  double energy(const TwoLayers &layers, const Eigen::VectorXd &pressures,
                const std::vector<Eigen::VectorXd> &forces)
  {
    double sum = 0.;
    for (std::size_t a = 0; a < 2; ++a)
      sum += layers.bodies()[a]->strain_energy(layers.bodies()[a]->deformation(
          Eigen::VectorXd(layers.problem().contact_forces(a, pressures)) + forces[a], 0.));
    return sum;
  }
} // namespace

TEST(DecompositionEnergy, NoFeasiblePerturbationLowersIt)
{
  const TwoLayers layers({"Body upper/Cells=24, 6", "Body lower/Cells=32, 8", "Decomposition/Scheme=newton",
                          "Decomposition/Stopping rule=bound", "Contact interface/Penalty coefficient=0"});
  const InterfaceProblem &problem = layers.problem();
  const Index n = problem.n_pressures();
  const Eigen::MatrixXd c = compliance_matrix(problem).topRows(n);
  const Eigen::LLT<Eigen::MatrixXd> inverse(c);
  const Eigen::VectorXd p =
      InterfaceSolver(problem, layers.parameters()).solve(layers.loads(), {}, {}).traction;
  const Eigen::VectorXd gap = layers.loads().response.head(n) + c * p;
  const std::vector<Eigen::VectorXd> none(2, Eigen::VectorXd::Zero(layers.bodies()[0]->trace_size()));
  std::vector<Eigen::VectorXd> rest = {none[0], Eigen::VectorXd::Zero(layers.bodies()[1]->trace_size())};
  const double least = energy(layers, p, rest);

  std::mt19937 generator(7);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 200; ++trial)
  {
    const double size = std::pow(10., -3. * trial / 200.) * p.maxCoeff() / static_cast<double>(n);
    std::vector<Eigen::VectorXd> forces = rest;
    Eigen::VectorXd change = Eigen::VectorXd::Zero(n);
    for (std::size_t a = 0; a < 2; ++a)
    {
      for (double &f : forces[a])
        f = size * normal(generator);
      change += problem.response_of(a, layers.bodies()[a]->respond(forces[a])).col(0).head(n);
    }
    const Eigen::VectorXd lift = inverse.solve(Eigen::VectorXd((-(gap + change)).cwiseMax(0.)));
    ASSERT_GE((gap + change + c * lift).minCoeff(), -1e-15);
    EXPECT_GE(energy(layers, p + lift, forces), least * (1. - 1e-13)) << trial;
  }
  // Penetration would lower it: the test can fail.
  EXPECT_LT(energy(layers, .99 * p, rest), least);
}
