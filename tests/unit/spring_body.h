// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/trace_body.h>

#include <utility>

namespace abut
{
  /// What the springs of a body stand on.
  struct SpringBase
  {
    Vector2 displacement = Vector2::Zero(); ///< where it is prescribed
    /// Free to move up and down, with a force along y (per thickness) on it.
    bool is_free = false;
    double force = 0.;
    double support_stiffness = 0.; ///< of a spring that holds a free base to the ground, force per length
  };

  /**
   * Springs in place of a body: the nodes of its contact sides stand on springs of one compliance (length per
   * stress) in every direction, over the share of the side that each node has, all on one rigid base. Its
   * answers are known exactly: under a uniform pressure every node yields by compliance times pressure.
   */
  class SpringBody : public TraceBody
  {
  public:
    SpringBody(std::string name, std::vector<Trace> sides, const double compliance, const SpringBase &base)
        : name_(std::move(name)), sides_(std::move(sides)), compliance_(compliance), base_(base),
          shares_(Eigen::VectorXd::Zero(trace_size()))
    {
      for (std::size_t side = 0; side < sides_.size(); ++side)
        for (const Segment &segment : sides_[side].segments())
          for (std::size_t j = 0; j < segment.nodes.size(); ++j)
            shares_.segment<2>(trace_offset(side) + 2 * segment.nodes[j]).array() +=
                segment.length * sides_[side].basis().integrals()[static_cast<Eigen::Index>(j)];
    }

    double compliance() const { return compliance_; }
    const std::string &name() const override { return name_; }
    const std::vector<Trace> &contact_sides() const override { return sides_; }

    /// With the base at rest. That of a free one moves by the amplitude of its motion: together they are the
    /// displacement wherever the forces balance.
    Eigen::MatrixXd respond(const Eigen::MatrixXd &forces) const override
    {
      return compliance_ * shares_.cwiseInverse().asDiagonal() * forces;
    }

    LoadResponse respond_to_loads(const double rigid_displacement) const override
    {
      const Vector2 moved = base_.is_free ? Vector2(0., rigid_displacement) : base_.displacement;
      LoadResponse response;
      response.displacement = moved.replicate(trace_size() / 2, 1);
      response.force_displacement = Eigen::VectorXd::Zero(trace_size());
      response.energy_product = base_.support_stiffness * moved.squaredNorm();
      return response;
    }

    BodyMotions motions() const override
    {
      if (!base_.is_free)
        return TraceBody::motions();
      return {translation(),
              Eigen::MatrixXd::Constant(1, 1, base_.support_stiffness),
              Eigen::VectorXd::Constant(1, base_.force),
              {"translation along (0, 1)"}};
    }

  private:
    /// All nodes up by 1.
    Eigen::VectorXd translation() const { return Vector2(0., 1.).replicate(trace_size() / 2, 1); }

    std::string name_;
    std::vector<Trace> sides_;
    double compliance_;
    SpringBase base_;
    Eigen::VectorXd shares_; ///< length of the side that each component's node has
  };
} // namespace abut
