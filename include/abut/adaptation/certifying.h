// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/adaptation/fe_be.h>
#include <abut/adaptation/kelly.h>

namespace abut
{
  /// `Estimator = automatic` where the goal is near: fe-be for the bodies that it is made for, kelly for the
  /// others.
  class CertifyingIndicator : public Indicator
  {
  public:
    explicit CertifyingIndicator(const AdaptationParameters &parameters)
        : boundary_elements_(parameters.boundary_solution, {parameters.boundary_accuracy})
    {}

    CellErrors estimate(const BodySolution &solution) const override
    {
      return why_uncertified(solution.body).empty() ? boundary_elements_.estimate(solution)
                                                    : jumps_.estimate(solution);
    }
    std::string name() const override { return boundary_elements_.name(); }
    std::string name_for(const Body &body) const override
    {
      return why_uncertified(body).empty() ? boundary_elements_.name() : jumps_.name();
    }
    std::string why_uncertified(const Body &body) const override;

  private:
    FEBEIndicator boundary_elements_;
    KellyIndicator jumps_;
  };
} // namespace abut
