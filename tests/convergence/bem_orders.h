// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <gtest/gtest.h>

#include "bem_study.h"
#include "convergence_table.h"

namespace abut
{
  /// Columns of a BoundaryStudy.
  enum Quantity : std::size_t
  {
    displacement,
    traction,
    stress
  };

  /// Errors on `n_meshes` meshes with n = `coarsest`, doubled from one to the next; printed.
  inline ConvergenceTable study(const std::string &title,
                                const std::function<BoundaryCase(unsigned int n)> &make,
                                const unsigned int coarsest, const unsigned int n_meshes = 4)
  {
    ConvergenceTable table(title, {"displacement", "traction", "stress"});
    for (unsigned int n = coarsest, mesh = 0; mesh < n_meshes; n *= 2, ++mesh)
    {
      const BoundaryErrors errors = solve(make(n));
      table.add(1. / n, {errors.displacement, errors.traction, errors.stress});
    }
    table.print();
    return table;
  }

  struct Degrees
  {
    unsigned int displacement, traction;
  };
  inline constexpr Degrees all_degrees[] = {{1, 1}, {1, 0}, {2, 1}, {2, 2}};
  inline std::string name_of(const Degrees &degrees)
  {
    return ", P" + std::to_string(degrees.displacement) + "/P" + std::to_string(degrees.traction);
  }

  /**
   * With displacements of degree p and tractions of degree q, exact data interpolated at nodes and projected:
   * the energy norm is of the order e = min(p + 1/2, q + 3/2), displacements in L2 of min(p + 1, e + 1/2),
   * tractions in L2 of e - 1/2 (by the inverse inequality) or better. Stresses inside are of the order of
   * displacements interpolated in a weak norm, p + 1 (p + 2 for even p, Simpson's rule), or of e + 3/4 and
   * more (Galerkin, the dual problem having the singularity of clamped right angles).
   */
  inline void expect_orders(const ConvergenceTable &table, const Degrees &degrees)
  {
    const double energy = std::min(degrees.displacement + .5, degrees.traction + 1.5);
    EXPECT_GT(table.last_rate(displacement), std::min(degrees.displacement + 1., energy + .5) - .1);
    EXPECT_GT(table.last_rate(traction), energy - .6);
    EXPECT_GT(table.last_rate(stress), degrees.displacement + .9);
  }
} // namespace abut
