// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bodies/finite_elements/rigid_motion.h>

#include <Eigen/QR>

#include <cmath>
#include <unordered_map>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;
    using ModesAtNode = Eigen::Matrix<double, 2, 3>;

    /// Translations and the rotation about the first node, vectors of length one of all nodes.
    class RigidModes
    {
    public:
      explicit RigidModes(const Nodes &nodes) : origin_(nodes.places.front())
      {
        double square = 0.;
        for (const Vector2 &place : nodes.places)
          square += (place - origin_).squaredNorm();
        const double length = std::sqrt(static_cast<double>(nodes.places.size()));
        lengths_ << length, length, std::sqrt(square);
      }

      ModesAtNode at(const Vector2 &place) const
      {
        const Vector2 arm = place - origin_;
        ModesAtNode modes;
        modes << 1., 0., -arm.y(), 0., 1., arm.x();
        return modes * lengths_.cwiseInverse().asDiagonal();
      }

      Eigen::VectorXd field(const Nodes &nodes, const Eigen::Vector3d &amounts, const Index n_dofs) const
      {
        Eigen::VectorXd field = Eigen::VectorXd::Zero(n_dofs);
        for (std::size_t i = 0; i < nodes.dofs.size(); ++i)
          field(nodes.dofs[i]) = at(nodes.places[i]) * amounts;
        return field;
      }

    private:
      Vector2 origin_;
      Eigen::Vector3d lengths_;
    };

    /// What supports hold of the modes at a node: what is along their directions.
    ModesAtNode held(const SupportNode &node, const ModesAtNode &modes)
    {
      if (node.directions.size() == 2)
        return modes;
      const Vector2 &direction = node.directions.front();
      return direction * (direction.transpose() * modes);
    }

    /// At the unknowns of the supported nodes, two rows each, one node after the other.
    Eigen::MatrixXd held_modes(const RigidModes &modes, const Nodes &nodes, const Supports &supports)
    {
      std::unordered_map<unsigned int, std::size_t> numbers;
      for (std::size_t k = 0; k < supports.nodes.size(); ++k)
        numbers[supports.nodes[k].dofs[0]] = k;
      Eigen::MatrixXd rows(2 * static_cast<Index>(supports.nodes.size()), 3);
      for (std::size_t i = 0; i < nodes.dofs.size(); ++i)
        if (const auto number = numbers.find(nodes.dofs[i][0]); number != numbers.end())
          rows.middleRows<2>(2 * static_cast<Index>(number->second)) =
              held(supports.nodes[number->second], modes.at(nodes.places[i]));
      return rows;
    }
  } // namespace

  RigidMotions split_off_rigid_motions(const Nodes &nodes, Supports &supports)
  {
    const Index n_dofs = supports.free_directions.rows();
    const RigidModes modes(nodes);
    const Eigen::MatrixXd supported = held_modes(modes, nodes, supports);
    RigidMotions motions{Eigen::VectorXd::Zero(n_dofs), Eigen::VectorXd::Zero(n_dofs)};
    if (supported.rows() < 3)
      return motions;
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> fit(supported);
    if (fit.rank() < 3)
      return motions;
    std::vector<unsigned int> dofs; // where supports prescribe anything
    for (const SupportNode &node : supports.nodes)
      dofs.insert(dofs.end(), node.dofs.begin(), node.dofs.end());
    const auto split = [&](Eigen::VectorXd &prescribed) -> Eigen::VectorXd {
      const Eigen::VectorXd before = prescribed(dofs), amounts = fit.solve(before);
      const Eigen::VectorXd rest = before - supported * amounts;
      // What the fit leaves of a motion that is rigid is round-off: it must not look like a stress.
      const double round_off = 1e-13 * before.lpNorm<Eigen::Infinity>();
      prescribed(dofs) = (rest.array().abs() > round_off).select(rest, 0.);
      return modes.field(nodes, amounts, n_dofs);
    };
    motions.fixed = split(supports.fixed);
    motions.moving = split(supports.moving);
    return motions;
  }
} // namespace abut
