// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/finite_elements/space.h>

#include <cstddef>

namespace abut
{
  /// How large a problem is.
  struct Counts
  {
    std::size_t cells = 0;         ///< active ones
    std::size_t dofs = 0;          ///< unknowns, supported ones included
    std::size_t boundary_dofs = 0; ///< those of nodes on the boundary
  };

  Counts count(const Space &space);
  Counts operator+(const Counts &a, const Counts &b);
} // namespace abut
