// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Stacks of up to 32 layers, stiff and soft by turns, that contact alone holds upright.
#include <gtest/gtest.h>

#include "../regression/program.h"
#include <sstream>

using namespace abut::testing;

namespace
{
  /// n layers of 4 x 1, gaps x^2 / 1000 between them, pressed together by n / 100.
  std::string stack(const int n)
  {
    std::ostringstream scene, bodies, contacts;
    for (int i = 0; i < n; ++i)
    {
      bodies << (i > 0 ? ", b" : "b") << i;
      scene << "subsection Body b" << i << "\n set Size = 4, 1\n set Shift = 0, " << i
            << "\n set Cells = 32, 8\n set Young modulus = " << (i % 2 == 0 ? "10" : "1e5")
            << "\n set Poisson ratio = 0.3\n set Conditions = left: normal displacement: 0";
      if (i == 0)
        scene << "; bottom: normal displacement: 0";
      if (i == n - 1)
        scene << "; top: displacement y: -" << n << "e-2";
      scene << "\nend\n";
      if (i == 0)
        continue;
      contacts << (i > 1 ? ", c" : "c") << i;
      scene << "subsection Contact c" << i << "\n set Slave = b" << i << ":bottom\n set Master = b" << i - 1
            << ":top\n set Gap = 1e-3*x^2\n set Penalty coefficient = 0\nend\n";
    }
    return "set Bodies = " + bodies.str() + "\nset Contacts = " + contacts.str() + "\n" + scene.str() +
           "subsection Decomposition\n set Scheme = newton\nend\n";
  }
} // namespace

TEST(ManyBodies, StepsAndSolvesDoNotGrowWithTheStack)
{
  for (const int n : {2, 4, 8, 16, 32})
  {
    const Answer answer = run({temporary_file("stack.prm", stack(n))});
    ASSERT_EQ(answer.status, 0) << answer.err;
    EXPECT_LE(answer.summary["steps"].get<int>(), 10) << n;
    // The same force passes through every layer.
    const double force = answer.summary["contacts"][0]["normal_force"];
    EXPECT_GT(force, 0.);
    for (const auto &pair : answer.summary["contacts"])
      EXPECT_NEAR(pair["normal_force"].get<double>(), force, 1e-9 * force) << n << ' ' << pair["name"];
    // A body is solved for its own contact nodes, 33 on a side, loads and the results, whatever the others.
    for (const auto &body : answer.summary["counters"]["bodies"])
      EXPECT_LE(body["solves"].get<int>(), 2 * 33 + 6) << n;
    for (const auto &body : answer.summary["bodies"])
      EXPECT_LT(body["equilibrium_residual"].get<double>(), 1e-10) << n << ' ' << body["name"];
  }
}
