// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/run/pass.h>

namespace abut
{
  /// The combined algorithm of the paper, its Fig. 2: one step (20)-(21) of the decomposition, then the
  /// estimate.
  class CombinedPass : public Pass
  {
  public:
    explicit CombinedPass(const Setup &setup) : Pass(setup) {}
    PassOutcome run(const std::optional<CarriedState> &carried, const RunObserver &observer) override;
    void serialize(Archive &archive) override
    {
      Pass::serialize(archive);
      archive(state_is_field_);
    }

  private:
    /// u^0; notes whether it is a field.
    CarriedState initial_state(const InterfaceProblem::Loads &loads);
    /// From u^k to the next state and what it tells of itself.
    void take_step(const CarriedState &state, const InterfaceProblem::Loads &loads,
                   const RunObserver &observer, PassOutcome &outcome) const;

    bool state_is_field_ = true; ///< false after the paper's literal initial guess
  };
} // namespace abut
