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
      Eigen::VectorXd result = Eigen::VectorXd::Zero(gaps.cols());
      for (std::size_t i = 0; i < problem.pairs().size(); ++i)
      {
        const ContactPair &pair = problem.pairs()[i];
        const double softness =
            pair.slave().layer_compliance + pair.master().layer_compliance + pair.penalty();
        for (Index k = 0; k < pair.n_multipliers(); ++k)
        {
          const Index row = problem.pressure_offset(i) + k;
          if (problem.weights()[row] > 0.)
            result += gaps.row(row).cwiseAbs2().transpose() / (softness * problem.weights()[row]);
        }
      }
      return result;
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

  bool MotionTerms::is_balanced(const Eigen::VectorXd &pressures, const Eigen::VectorXd &amplitudes,
                                const double share) const
  {
    constexpr double round_off = 100. * std::numeric_limits<double>::epsilon();
    return size() == 0 ||
           unbalanced(pressures, amplitudes).cwiseAbs().maxCoeff() <=
               share * force_scale(pressures) + round_off * layer_stiffness.dot(amplitudes.cwiseAbs());
  }

  MotionTerms make_motion_terms(const InterfaceProblem &problem)
  {
    MotionTerms terms;
    terms.all = interface_motions(problem);
    terms.held = held_motions(problem, terms.all);
    terms.gaps = terms.all.responses(Eigen::seqN(0, problem.n_pressures()), terms.held);
    terms.stiffness = terms.all.stiffness(terms.held, terms.held);
    terms.loads = terms.all.loads(terms.held);
    terms.layer_stiffness = layer_stiffnesses(problem, terms.gaps);
    return terms;
  }
} // namespace abut
