// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/mortar_parameters.h>
#include <abut/trace/make_trace.h>

#include <vector>

namespace abut
{
  /// Where cells meet finer ones: both sides of a row of edges, as curves.
  struct Seam
  {
    Trace finer, coarser;
  };

  /**
   * All seams of a mesh. With tied vertices every edge of a coarser cell is one of its own; with free ones,
   * rows of such edges are, that end where more or fewer than two meet.
   */
  std::vector<Seam> find_seams(const dealii::DoFHandler<2> &dof_handler, const CellGeometry &geometry,
                               unsigned int geometry_degree, MortarVertices vertices);
} // namespace abut
