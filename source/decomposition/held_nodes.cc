// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/contact_residual.h>
#include <abut/decomposition/held_nodes.h>
#include <abut/user_error.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    constexpr double held_share = 1e-12; // of what a half-plane yields, and of the side's length for gaps

    /// Positive pressures without a pattern: C p has no zero but in the zero rows of C.
    Eigen::VectorXd probing_pressures(const Index n)
    {
      return Eigen::VectorXd::NullaryExpr(
          n, [](const Index i) { return 1. + .5 * std::cos(static_cast<double>(i * i)); });
    }
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
    const Eigen::VectorXd yielding = compliance.apply(probing_pressures(n)).head(n);
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
    std::size_t i = problem_.pairs().size() - 1;
    while (problem_.pressure_offset(i) > multiplier)
      --i;
    const ContactPair &pair = problem_.pairs()[i];
    const Trace &side = problem_.bodies()[pair.slave().body]->contact_sides()[pair.slave().side];
    const Vector2 &place =
        side.node_points()[static_cast<std::size_t>(multiplier - problem_.pressure_offset(i))];
    std::ostringstream text;
    text << "Contact " << pair.name() << ": at (" << place.x() << ", " << place.y()
         << ") supports hold both bodies, and make them overlap by " << -gap
         << "; let the contact side end before the held nodes, or give the contact a Penalty coefficient";
    throw ComputationError(text.str());
  }
} // namespace abut
