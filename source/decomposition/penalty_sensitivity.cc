// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/model_compliance.h>
#include <abut/decomposition/penalty_sensitivity.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    constexpr int n_terms = 4;

    /// Inverts C + theta D on the parts in contact, with the motions in balance: H alpha = G^T p.
    class HeldOperator
    {
    public:
      HeldOperator(const InterfaceProblem &problem, const InterfaceCompliance &compliance,
                   const MotionTerms *motions, ActiveSet active)
          : model_(problem), operator_(make_pressure_operator(problem, compliance, model_)),
            active_(std::move(active))
      {
        if (motions == nullptr || motions->size() == 0)
          return;
        gaps_ = motions->gaps(active_, Eigen::all);
        held_ = invert(gaps_);
        stiffness_ = motions->stiffness + gaps_.transpose() * held_;
      }

      Eigen::VectorXd solve(const Eigen::VectorXd &right_side) const
      {
        const Eigen::VectorXd solution = invert(right_side);
        if (gaps_.size() == 0)
          return solution;
        return solution - held_ * stiffness_.fullPivLu().solve(gaps_.transpose() * solution);
      }

    private:
      Eigen::MatrixXd invert(const Eigen::MatrixXd &right_sides) const
      {
        constexpr double accuracy = 1e-3;
        return operator_->solve(active_, right_sides, accuracy);
      }

      ModelCompliance model_;
      std::unique_ptr<PressureOperator> operator_;
      ActiveSet active_;
      Eigen::MatrixXd gaps_, held_, stiffness_;
    };

    /// The parts that press against a penalty.
    ActiveSet penalised_parts(const InterfaceProblem &problem, const Eigen::VectorXd &pressures)
    {
      ActiveSet active;
      for (Index k = 0; k < pressures.size(); ++k)
        if (pressures[k] > 0.)
          active.push_back(k);
      const bool some = std::any_of(active.begin(), active.end(),
                                    [&](const Index k) { return problem.penalties()[k] > 0.; });
      return some ? active : ActiveSet();
    }
  } // namespace

  PenaltyChange penalty_change(const InterfaceProblem &problem, const InterfaceCompliance &compliance,
                               const MotionTerms *motions, const Eigen::VectorXd &pressures)
  {
    AssertDimension(pressures.size(), problem.n_pressures());
    const ActiveSet active = penalised_parts(problem, pressures);
    if (active.empty())
      return {0., 0., Eigen::VectorXd::Zero(pressures.size())};
    const Eigen::VectorXd penalties = problem.weights()(active).cwiseProduct(problem.penalties()(active));
    const HeldOperator held(problem, compliance, motions, active);
    Eigen::VectorXd term = pressures(active), sum = Eigen::VectorXd::Zero(term.size());
    for (int order = 0; order < n_terms; ++order)
      sum += term = held.solve(penalties.cwiseProduct(term));
    Eigen::VectorXd change = Eigen::VectorXd::Zero(pressures.size());
    change(active) = sum;
    return {change.dot(compliance.apply(change).head(change.size())), std::abs(problem.normal_force(change)),
            change};
  }
} // namespace abut
