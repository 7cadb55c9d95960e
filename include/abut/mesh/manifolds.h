// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/body_description.h>

#include <deal.II/grid/tria.h>

namespace abut
{
  /**
   * Attaches to a triangulation of the placed body the curves and charts of its shape, so that refinement and
   * mappings of higher degree follow the exact boundary: the circle on the arc of a disc, polar coordinates
   * on a whole ring, the chart (x, y/Top(x)) on a whole rectangle with a curved top. Nothing for other
   * shapes.
   */
  void attach_manifolds(dealii::Triangulation<2> &triangulation, const BodyDescription &body);
} // namespace abut
