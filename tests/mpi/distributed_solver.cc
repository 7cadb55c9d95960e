// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Solvers of a matrix that is spread over processes, here in a single one: beside Cholesky's factor.

#include <abut/base/distributed_solver.h>
#include <abut/base/free_memory.h>
#include <abut/base/sparse_cholesky.h>
#include <abut/base/user_error.h>

#include <gtest/gtest.h>

#include "this_process.h"
#include <cmath>
#include <limits>
#include <unistd.h>

using namespace abut;

namespace
{
  constexpr int n = 60; // nodes in each direction of a square

  /// Springs between neighbouring nodes of a square, the same in both components; one edge is held.
  DistributedMatrix net(const double spring = 1.)
  {
    DistributedMatrix::Rows rows(2 * n * n, 2 * n * n);
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&](const int node, const int other) {
      for (const int component : {0, 1})
      {
        const int i = 2 * node + component, j = 2 * other + component;
        entries.emplace_back(i, i, spring);
        entries.emplace_back(j, j, spring);
        entries.emplace_back(i, j, -spring);
        entries.emplace_back(j, i, -spring);
      }
    };
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x)
      {
        const int node = y * n + x;
        if (x + 1 < n)
          add(node, node + 1);
        if (y + 1 < n)
          add(node, node + n);
        if (x == 0)
          for (const int component : {0, 1})
            entries.emplace_back(2 * node + component, 2 * node + component, spring);
      }
    rows.setFromTriplets(entries.begin(), entries.end());
    return {this_process(), {0, 2 * n * n}, rows};
  }

  /// What moves all nodes alike.
  Eigen::MatrixXd translations()
  {
    Eigen::MatrixXd modes = Eigen::MatrixXd::Zero(2 * n * n, 2);
    for (int i = 0; i < modes.rows(); ++i)
      modes(i, i % 2) = 1.;
    return modes;
  }

  Eigen::MatrixXd loads()
  {
    return Eigen::MatrixXd::NullaryExpr(2 * n * n, 3, [](const Eigen::Index i, const Eigen::Index j) {
      return std::sin(1. + static_cast<double>(i * (j + 3)));
    });
  }

  TEST(DistributedSolver, SolvesAsCholeskysFactorDoes)
  {
    const DistributedMatrix matrix = net();
    const Eigen::SparseMatrix<double> lower = matrix.own;
    const Eigen::MatrixXd expected = SparseCholesky(lower, "net").solve(loads());
    const auto multigrid = make_multigrid_solver(matrix, translations(), "net");
    const auto direct = make_distributed_cholesky(matrix, "net");
    // The residual of 1e-12, and round-off, grow by the condition, about n^2.
    const double tolerance = 1e-12 * n * n * expected.norm();
    EXPECT_NEAR((multigrid->solve(loads()) - expected).norm(), 0., tolerance);
    EXPECT_NEAR((direct->solve(loads()) - expected).norm(), 0., tolerance);
    EXPECT_GT(multigrid->iterations(), 5u);
    EXPECT_LT(multigrid->iterations(), 60u);
    EXPECT_EQ(direct->iterations(), 0u);
  }

  TEST(DistributedSolver, LeavesZeroLoadsAlone)
  {
    const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(2 * n * n, 1);
    EXPECT_EQ(make_multigrid_solver(net(), translations(), "net")->solve(zero), zero);
    EXPECT_EQ(make_distributed_cholesky(net(), "net")->solve(zero), zero);
  }

  TEST(DistributedSolver, SaysThatIterationsWereNotEnough)
  {
    const auto solver = make_multigrid_solver(net(), translations(), "Body net", 2);
    try
    {
      solver->solve(loads());
      FAIL() << "two iterations were enough";
    }
    catch (const ComputationError &error)
    {
      const std::string text = error.what();
      EXPECT_EQ(text.rfind("Body net: 2 iterations", 0), 0u) << text;
      EXPECT_NE(text.find("Processes = 1"), std::string::npos) << text;
    }
  }

  TEST(FreeMemory, IsSomeOfTheMachines)
  {
    const double bytes = free_memory(*this_process());
    EXPECT_GT(bytes, 1e6);
    EXPECT_LE(bytes,
              static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE)));
  }

  TEST(DistributedSolver, RefusesAMatrixThatIsNotPositiveDefinite)
  {
    EXPECT_THROW(make_distributed_cholesky(net(-1.), "net"), ComputationError);
  }

  TEST(DistributedSolver, TakesLoadsOfAnySize)
  {
    const auto solver = make_multigrid_solver(net(), translations(), "net");
    const Eigen::MatrixXd expected = solver->solve(loads());
    for (const double size : {1e-250, 1e250})
      EXPECT_NEAR((solver->solve(size * loads()) / size - expected).norm(), 0., 1e-10 * expected.norm());
    Eigen::MatrixXd infinite = loads();
    infinite(7, 1) = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(solver->solve(infinite).col(1).allFinite());
    EXPECT_TRUE(solver->solve(infinite).col(2).allFinite());
  }
} // namespace
