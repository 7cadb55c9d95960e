// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/compliance.h>
#include <abut/decomposition/motion_terms.h>

namespace abut
{
  /// The parts at which neither body yields to a pressure: supports hold the nodes of both sides along the
  /// normal, no motion moves them and the penalty is none. No pressure is defined there.
  class HeldParts
  {
  public:
    /// Takes one product with the compliance where a pair has no penalty to speak of.
    HeldParts(const InterfaceProblem &problem, const InterfaceCompliance &compliance,
              const MotionTerms &motions);

    const std::vector<Eigen::Index> &indices() const { return indices_; }
    /// The loads with gaps at held parts that touch a hair open, so that no scheme presses there.
    InterfaceProblem::Loads opened(InterfaceProblem::Loads loads) const;

  private:
    const InterfaceProblem &problem_;
    std::vector<Eigen::Index> indices_;
  };
} // namespace abut
