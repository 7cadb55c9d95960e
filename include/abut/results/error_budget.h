// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/archive.h>

#include <array>
#include <optional>
#include <string>

namespace abut
{
  /// A part of the error of a solution, and its size.
  struct ErrorPart
  {
    const char *name; ///< as in summary.json
    double error;     ///< relative, energy norm
  };

  /**
   * What the error of a solution is made of, relative, in the energy norm of all bodies together, against the
   * exact solution of the problem without a penalty. Empty: not estimated.
   */
  struct ErrorBudget
  {
    std::optional<double> discretisation; ///< of every body under its own traction: b of Estimation
    std::optional<double> contact;        ///< what the sides of contacts miss of the contact law
    std::optional<double> iteration;      ///< of the interface problem
    std::optional<double> penalty;        ///< exact contact: 0
    std::optional<double> linear_algebra; ///< round-off in the bodies' equations
    std::optional<double> geometry;       ///< edges of cells against the curves that they stand for
    /// Discretisation, contact and iteration together, where boundary elements say so (Estimation::bound).
    std::optional<double> bounded_part;

    /// All, with 0 for what is not estimated.
    std::array<ErrorPart, 6> parts() const;
    /// Root of the sum of squares; empty without a discretisation error.
    std::optional<double> estimate() const;
    /// The sum, in which `bounded_part` stands for what it bounds; empty without one.
    std::optional<double> bound() const;
    /// The largest part.
    ErrorPart dominant() const;

    void serialize(Archive &archive)
    {
      archive(discretisation, contact, iteration, penalty, linear_algebra, geometry, bounded_part);
    }
  };
} // namespace abut
