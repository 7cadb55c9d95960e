// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/plane_geometry.h>
#include <abut/bodies/prescribed.h>

#include <Eigen/Core>

#include <cmath>

namespace abut
{
  /// Sums forces and their moments about the middle of the nodes.
  class Balance
  {
  public:
    explicit Balance(const Nodes &nodes) : box_(box_around(nodes.places)) {}

    void add(const Vector2 &place, const Vector2 &force)
    {
      const Vector2 arm = (place - box_.middle()) / box_.diagonal();
      sum_ += force;
      moment_ += arm.x() * force.y() - arm.y() * force.x();
      size_ += force.norm();
    }
    /// Adds the forces at all nodes and returns their resultant.
    Vector2 add_all(const Nodes &nodes, const Eigen::VectorXd &forces)
    {
      const Vector2 before = sum_;
      for (std::size_t i = 0; i < nodes.dofs.size(); ++i)
        add(nodes.places[i], {forces[nodes.dofs[i][0]], forces[nodes.dofs[i][1]]});
      return sum_ - before;
    }
    double of_forces() const { return size_ > 0. ? sum_.norm() / size_ : 0.; }
    double of_moments() const { return size_ > 0. ? std::abs(moment_) / size_ : 0.; }

  private:
    Box box_;
    Vector2 sum_ = Vector2::Zero();
    double moment_ = 0., size_ = 0.;
  };
} // namespace abut
