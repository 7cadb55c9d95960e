// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/motion_terms.h>

#include <deal.II/base/exceptions.h>

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
      return gaps.cwiseAbs2().transpose() * softness.cwiseInverse();
    }
  } // namespace

  Eigen::VectorXd MotionTerms::amplitudes(const Eigen::VectorXd &of_held) const
  {
    AssertDimension(of_held.size(), size());
    Eigen::VectorXd result = Eigen::VectorXd::Zero(all.size());
    result(held) = of_held;
    return result;
  }

  double MotionTerms::force_scale(const Eigen::VectorXd &pressures) const
  {
    AssertDimension(pressures.size(), gaps.rows());
    if (size() == 0)
      return 0.;
    const Eigen::VectorXd along = gaps.cwiseAbs().transpose() * pressures.cwiseAbs(),
                          on_bodies = reach * pressures.cwiseAbs();
    // What presses a body is opposed by as much: half of the sum.
    return std::max({loads.cwiseAbs().maxCoeff(), along.maxCoeff(), .5 * on_bodies.maxCoeff()});
  }

  bool MotionTerms::is_balanced(const Eigen::VectorXd &pressures, const Eigen::VectorXd &amplitudes) const
  {
    AssertDimension(amplitudes.size(), size());
    constexpr double share = 1e-10;
    constexpr double round_off = 100. * std::numeric_limits<double>::epsilon();
    return imbalance(pressures, amplitudes) <=
           share * force_scale(pressures) + round_off * layer_stiffness.dot(amplitudes.cwiseAbs());
  }

  namespace
  {
    Eigen::MatrixXd reach_of(const InterfaceProblem &problem, const MotionTerms &terms)
    {
      Eigen::MatrixXd reach = Eigen::MatrixXd::Zero(terms.size(), problem.n_pressures());
      for (Index k = 0; k < terms.size(); ++k)
      {
        const std::size_t body = terms.all.body_of(terms.held[static_cast<std::size_t>(k)]);
        problem.for_each_pair([&](const ContactPair &pair, const std::size_t surface) {
          const Eigen::RowVectorXd weights = pair.weights();
          if (pair.slave().body == body || pair.master().body == body)
            for (Index component = 0; component < problem.layout().n_components(); ++component)
              reach(k, problem.layout().indices(surface, component)) += weights;
        });
      }
      return reach;
    }
  } // namespace

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
    terms.reach = reach_of(problem, terms);
    terms.layer_stiffness = layer_stiffnesses(problem, terms.gaps);
    return terms;
  }
} // namespace abut
