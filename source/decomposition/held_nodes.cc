// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/contact_residual.h>
#include <abut/decomposition/held_nodes.h>
#include <abut/decomposition/spectrum.h>
#include <abut/user_error.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    /// Of what a half-plane yields, and of the side's length for gaps.
    constexpr double held_share = 1e-12;
  } // namespace

  HeldNodes::HeldNodes(const InterfaceProblem &problem, const InterfaceCompliance &compliance,
                       const MotionTerms &motions)
      : problem_(problem)
  {
    const Index n = problem.n_pressures();
    const Eigen::VectorXd &weights = problem.weights();
    const Eigen::VectorXd least = held_share * weights.cwiseProduct(node_softness(problem));
    const Eigen::VectorXd penalties = weights.cwiseProduct(problem.penalties());
    if (((weights.array() == 0.) || (penalties.array() > least.array())).all())
      return;
    // Positive and without a pattern: C p has no zeros but in the zero rows of C.
    const Eigen::VectorXd yielding = compliance.apply(probing_vector(n)).head(n);
    for (Index i = 0; i < n; ++i)
      if (weights[i] > 0. && std::abs(yielding[i]) + penalties[i] <= least[i] &&
          (motions.size() == 0 || motions.gaps.row(i).cwiseAbs().maxCoeff() <= held_share * weights[i]))
        indices_.push_back(i);
  }

  InterfaceProblem::Loads HeldNodes::opened(InterfaceProblem::Loads loads) const
  {
    for (const Index i : indices_)
    {
      const double weight = problem_.weights()[i], hair = held_share * problem_.weights().sum();
      const double gap = loads.response[i] / weight;
      if (gap < -hair)
        refuse(i, gap);
      loads.response[i] = std::max(gap, hair) * weight;
    }
    return loads;
  }

  void HeldNodes::refuse(const Index multiplier, const double gap) const
  {
    const Vector2 &place = problem_.place(multiplier);
    std::ostringstream text;
    text << "Contact " << problem_.pairs()[problem_.pair_of(multiplier)].name() << ": at (" << place.x()
         << ", " << place.y() << ") supports hold both bodies, and make them overlap by " << -gap
         << "; let the contact side end before the held nodes, or give the contact a Penalty coefficient";
    throw ComputationError(text.str());
  }
} // namespace abut
