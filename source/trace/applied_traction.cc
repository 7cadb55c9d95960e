// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/trace/applied_traction.h>

#include <Eigen/Cholesky>

namespace abut
{
  std::vector<Eigen::VectorXd> applied_pressure(const Trace &slave, const Eigen::VectorXd &multipliers)
  {
    const GaussRule rule(slave.basis().degree() + 3);
    std::vector<Eigen::VectorXd> pressures;
    for (const Segment &segment : slave.segments())
    {
      const auto n = static_cast<Eigen::Index>(segment.nodes.size());
      Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(n, n);
      Eigen::VectorXd moments = Eigen::VectorXd::Zero(n);
      for (Eigen::Index q = 0; q < rule.points.size(); ++q)
      {
        const double weight = rule.weights[q] * slave.tangent(segment, rule.points[q]).norm();
        const Eigen::VectorXd values = slave.basis().values(rule.points[q]);
        mass += weight * values * values.transpose();
        moments += weight * values;
      }
      for (Eigen::Index i = 0; i < n; ++i)
        moments[i] *= multipliers[segment.nodes[static_cast<std::size_t>(i)]];
      pressures.push_back(mass.ldlt().solve(moments));
    }
    return pressures;
  }
} // namespace abut
