// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/archive.h>

#include <Eigen/Core>

namespace abut
{
  /// What boundary elements cost: one body, one estimate. Seconds of wall clock.
  struct BoundaryCost
  {
    Eigen::Index elements = 0;
    Eigen::Index unknowns = 0;
    unsigned int models = 0; ///< operators made for a new mesh
    double assemble = 0.;    ///< operators and factors; zero where those of the mesh were there already
    double solve = 0.;       ///< right side and solution
    double evaluate = 0.;    ///< stress at the points

    double seconds() const { return assemble + solve + evaluate; }
    /// Of several bodies or estimates.
    BoundaryCost &operator+=(const BoundaryCost &other)
    {
      elements += other.elements;
      unknowns += other.unknowns;
      models += other.models;
      assemble += other.assemble;
      solve += other.solve;
      evaluate += other.evaluate;
      return *this;
    }

    void serialize(Archive &archive) { archive(elements, unknowns, models, assemble, solve, evaluate); }
  };
} // namespace abut
