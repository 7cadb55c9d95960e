// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/contact_residual.h>
#include <abut/decomposition/held_parts.h>
#include <abut/decomposition/spectrum.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    /// Of what a half-plane yields, and of the side's length for gaps.
    constexpr double held_share = 1e-12;
  } // namespace

  HeldParts::HeldParts(const InterfaceProblem &problem, const InterfaceCompliance &compliance,
                       const MotionTerms &motions)
      : problem_(problem)
  {
    const Index n = problem.n_pressures();
    const Eigen::VectorXd &weights = problem.weights();
    const Eigen::VectorXd least = held_share * weights.cwiseProduct(part_softness(problem));
    const Eigen::VectorXd penalties = weights.cwiseProduct(problem.penalties());
    if ((penalties.array() > least.array()).all())
      return;
    // Positive and without a pattern: C p has no zeros but in the zero rows of C.
    const Eigen::VectorXd yielding = compliance.apply(probing_vector(n)).head(n);
    for (Index i = 0; i < n; ++i)
      if (std::abs(yielding[i]) + penalties[i] <= least[i] &&
          (motions.size() == 0 || motions.gaps.row(i).cwiseAbs().maxCoeff() <= held_share * weights[i]))
        indices_.push_back(i);
  }

  InterfaceProblem::Loads HeldParts::opened(InterfaceProblem::Loads loads) const
  {
    AssertDimension(loads.response.size(), problem_.response_size());
    for (const Index i : indices_)
    {
      const double weight = problem_.weights()[i], hair = held_share * problem_.weights().sum();
      loads.response[i] = std::max(loads.response[i], hair * weight);
    }
    return loads;
  }
} // namespace abut
