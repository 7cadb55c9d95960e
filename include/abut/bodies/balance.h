// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/prescribed.h>

#include <Eigen/Core>

#include <cmath>

namespace abut
{
  /// Sums forces and their moments about the middle of the nodes.
  class Balance
  {
  public:
    explicit Balance(const Nodes &nodes) : low_(nodes.places.front()), high_(low_)
    {
      for (const Vector2 &place : nodes.places)
      {
        low_ = low_.cwiseMin(place);
        high_ = high_.cwiseMax(place);
      }
    }

    void add(const Vector2 &place, const Vector2 &force)
    {
      const Vector2 arm = (place - .5 * (low_ + high_)) / (high_ - low_).norm();
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
    Vector2 low_, high_, sum_ = Vector2::Zero();
    double moment_ = 0., size_ = 0.;
  };
} // namespace abut
