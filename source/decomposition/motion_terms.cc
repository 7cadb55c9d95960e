// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/motion_terms.h>

#include <algorithm>
#include <limits>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    Eigen::VectorXd layer_stiffnesses(const InterfaceProblem &problem, const Eigen::MatrixXd &gaps)
    {
      const Eigen::VectorXd softness =
          problem.weights().cwiseProduct(problem.layer_compliances() + problem.penalties());
      const Eigen::VectorXd stiffness = (softness.array() > 0.).select(softness.cwiseInverse(), 0.);
      return gaps.cwiseAbs2().transpose() * stiffness;
    }
  } // namespace

  Eigen::VectorXd MotionTerms::amplitudes(const Eigen::VectorXd &of_held) const
  {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(all.size());
    result(held) = of_held;
    return result;
  }

  double MotionTerms::force_scale(const Eigen::VectorXd &pressures) const
  {
    const Eigen::VectorXd sums = gaps.cwiseAbs().transpose() * pressures.cwiseAbs();
    return size() > 0 ? std::max(loads.cwiseAbs().maxCoeff(), sums.maxCoeff()) : 0.;
  }

  bool MotionTerms::is_balanced(const Eigen::VectorXd &pressures, const Eigen::VectorXd &amplitudes) const
  {
    constexpr double share = 1e-10;
    constexpr double round_off = 100. * std::numeric_limits<double>::epsilon();
    return imbalance(pressures, amplitudes) <=
           share * force_scale(pressures) + round_off * layer_stiffness.dot(amplitudes.cwiseAbs());
  }

  MotionTerms make_motion_terms(const InterfaceProblem &problem)
  {
    MotionTerms terms;
    terms.all = interface_motions(problem);
    HeldMotions held = held_motions(problem, terms.all);
    terms.held = std::move(held.indices);
    terms.dropped_loads = std::move(held.dropped_loads);
    terms.gaps = terms.all.responses(Eigen::seqN(0, problem.n_pressures()), terms.held);
    terms.stiffness = terms.all.stiffness(terms.held, terms.held);
    terms.loads = terms.all.loads(terms.held);
    terms.layer_stiffness = layer_stiffnesses(problem, terms.gaps);
    return terms;
  }
} // namespace abut
