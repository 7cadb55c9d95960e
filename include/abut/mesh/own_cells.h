// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/grid/filtered_iterator.h>

namespace abut
{
  /// The active cells, of a mesh or of its DoFHandler, that are this process's own: all of them, unless
  /// processes share the mesh.
  template <typename Mesh> auto own_cells(const Mesh &mesh)
  {
    return dealii::filter_iterators(mesh.active_cell_iterators(),
                                    dealii::IteratorFilters::LocallyOwnedCell());
  }
} // namespace abut
