// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/archive.h>

#include <cstddef>

namespace abut
{
  /// How large a problem is.
  struct Counts
  {
    std::size_t cells = 0;         ///< active ones
    std::size_t dofs = 0;          ///< unknowns, supported ones included
    std::size_t boundary_dofs = 0; ///< those of nodes on the boundary

    void serialize(Archive &archive) { archive(cells, dofs, boundary_dofs); }
  };

  inline Counts operator+(const Counts &a, const Counts &b)
  {
    return {a.cells + b.cells, a.dofs + b.dofs, a.boundary_dofs + b.boundary_dofs};
  }
} // namespace abut
