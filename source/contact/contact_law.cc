// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/contact/contact_law.h>

#include <deal.II/base/exceptions.h>

namespace abut
{
  Eigen::VectorXd ContactLaw::penalised(const Eigen::VectorXd &gaps, const Eigen::VectorXd &penalties) const
  {
    AssertDimension(gaps.size(), penalties.size());
    return project(-gaps.cwiseQuotient(penalties));
  }

  Eigen::VectorXd ContactLaw::residual(const Eigen::VectorXd &multipliers, const Eigen::VectorXd &gaps,
                                       const Eigen::VectorXd &penalties, const Eigen::VectorXd &beta) const
  {
    AssertDimension(multipliers.size(), gaps.size());
    AssertDimension(multipliers.size(), penalties.size());
    AssertDimension(multipliers.size(), beta.size());
    Assert(((penalties + beta).array() > 0.).all(), dealii::ExcMessage("theta + beta has to be positive"));
    const Eigen::VectorXd slack = gaps + penalties.cwiseProduct(multipliers);
    return multipliers - project(multipliers - slack.cwiseQuotient(penalties + beta));
  }

  Eigen::VectorXd FrictionlessLaw::project(const Eigen::VectorXd &multipliers) const
  {
    return multipliers.cwiseMax(0.);
  }

  std::vector<bool> FrictionlessLaw::active(const Eigen::VectorXd &multipliers) const
  {
    std::vector<bool> result;
    for (const double pressure : multipliers)
      result.push_back(pressure > 0.);
    return result;
  }
} // namespace abut
