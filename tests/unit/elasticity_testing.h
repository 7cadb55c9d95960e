// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/elasticity/body.h>

#include "mesh_testing.h"

namespace abut
{
  inline void set_conditions(BodyDescription &body, const std::string &text)
  {
    body.conditions = parse_conditions(text, {}, "test");
  }

  /// Largest difference of a displacement from a given field over all nodes.
  inline double distance(const Body &body, const Eigen::VectorXd &displacement,
                         const std::function<Vector2(const Vector2 &)> &field)
  {
    const Nodes nodes = all_nodes(body.space());
    double largest = 0.;
    for (std::size_t i = 0; i < nodes.dofs.size(); ++i)
    {
      const Vector2 u(displacement[nodes.dofs[i][0]], displacement[nodes.dofs[i][1]]);
      largest = std::max(largest, (u - field(nodes.places[i])).norm());
    }
    return largest;
  }

  /// The displacement of a body that nothing touches.
  inline Eigen::VectorXd untouched(Body &body)
  {
    body.prepare();
    return body.displacement(Eigen::VectorXd::Zero(body.trace_size()), 0.);
  }
} // namespace abut
