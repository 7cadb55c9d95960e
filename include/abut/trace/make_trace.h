// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/trace/trace.h>

#include <deal.II/base/types.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping.h>

namespace abut
{
  /**
   * The side `boundary` of a mesh as a curve, with the trace of the vector-valued space of `dof_handler` (two
   * equal scalar elements with support points on the faces). The geometry is that of `geometry_mapping`,
   * sampled as a polynomial of `geometry_degree` on each edge. Where the side consists of several curves they
   * follow one another.
   */
  Trace make_trace(const dealii::DoFHandler<2> &dof_handler, const dealii::Mapping<2> &geometry_mapping,
                   unsigned int geometry_degree, dealii::types::boundary_id boundary);
} // namespace abut
