// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/measures.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

namespace abut
{
  double relative_change(const InterfaceProblem &problem, const Eigen::VectorXd &u, const Eigen::VectorXd &v)
  {
    AssertDimension(u.size(), problem.response_size());
    AssertDimension(v.size(), problem.response_size());
    double largest = 0.;
    for (std::size_t a = 0; a < problem.bodies().size(); ++a)
    {
      const Eigen::VectorXd now = problem.normal_displacements(u, a);
      const double change = (now - problem.normal_displacements(v, a)).norm();
      if (change > 0.) // a body that comes back to rest has changed wholly
        largest = std::max(largest, now.norm() > 0. ? change / now.norm() : 1.);
    }
    return largest;
  }

  double reference_norm(const InterfaceProblem &problem, const InterfaceProblem::Loads &loads,
                        const Eigen::VectorXd &pressures, const Eigen::VectorXd &response)
  {
    const Eigen::Index n = problem.n_pressures();
    AssertDimension(pressures.size(), n);
    const double of_contact = pressures.dot((response - loads.response).head(n));
    const double of_all = loads.energy_product + 2. * pressures.dot(loads.force_gap) + of_contact;
    return std::sqrt(std::max(std::min(of_contact, of_all), 0.));
  }

  StepRecord step_record(const InterfaceProblem &problem, const unsigned int step, const double increment,
                         const double bound, const Eigen::VectorXd &pressures)
  {
    AssertDimension(pressures.size(), problem.n_pressures());
    return {step, increment, bound, problem.normal_force(pressures), problem.max_pressure(pressures)};
  }
} // namespace abut
