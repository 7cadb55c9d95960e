// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/measures.h>
#include <abut/decomposition/schemes/conjugate.h>
#include <abut/decomposition/schemes/contact_guess.h>
#include <abut/decomposition/schemes/projected_gradients.h>
#include <abut/scene/scheme_entry.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

namespace abut
{
  namespace
  {
    constexpr double first_softness_of_steps = 1e-2; // of the layers' stiffness
    constexpr double last_softness_of_steps = 1e-7;
    constexpr int most_outer_steps = 200;
    constexpr double first_accuracy = .1; // of the gradient, times the tolerance

    std::string unfinished(const bool stalled, const unsigned int maximum_steps)
    {
      return stalled
                 ? "The scheme conjugate does not come nearer to the tolerance; take the scheme newton or "
                   "raise Decomposition/Tolerance"
                 : "The scheme conjugate has not reached the tolerance within Decomposition/Maximum steps "
                   "= " +
                       std::to_string(maximum_steps);
    }

    /// The problem in sqrt(D) p with the motions eliminated, for one proximal step.
    class ScaledProblem
    {
    public:
      ScaledProblem(const ContactSystem &system, const double softness)
          : problem_(system.problem), compliance_(system.compliance), motions_(system.motions),
            scaling_(problem_.weights().array().rsqrt()), softness_(softness * motions_.layer_stiffness)
      {
        if (motions_.size() > 0)
          factor_.compute(motions_.stiffness + Eigen::MatrixXd(softness_.asDiagonal()));
        norm_ = rough_norm([&](const Eigen::VectorXd &x) { return product(x); }, scaling_.size());
      }

      double norm() const { return norm_; }
      Eigen::VectorXd pressures(const Eigen::VectorXd &x) const { return scaling_.cwiseProduct(x); }
      Eigen::VectorXd scaled(const Eigen::VectorXd &pressures) const
      {
        return problem_.weights().cwiseSqrt().cwiseProduct(pressures);
      }
      /// alpha for pressures.
      Eigen::VectorXd motions_for(const Eigen::VectorXd &pressures, const Eigen::VectorXd &before) const
      {
        return solve(motions_.loads + softness_.cwiseProduct(before) + motions_.gaps.transpose() * pressures);
      }
      Eigen::VectorXd product(const Eigen::VectorXd &x) const
      {
        const Eigen::VectorXd p = pressures(x);
        Eigen::VectorXd gaps = compliance_.apply(p).head(p.size());
        gaps += problem_.weights().cwiseProduct(problem_.penalties()).cwiseProduct(p);
        gaps += motions_.gaps * solve(motions_.gaps.transpose() * p);
        return scaling_.cwiseProduct(gaps);
      }
      Eigen::VectorXd linear(const Eigen::VectorXd &gaps, const Eigen::VectorXd &before) const
      {
        return scaling_.cwiseProduct(gaps +
                                     motions_.gaps * solve(motions_.loads + softness_.cwiseProduct(before)));
      }

    private:
      Eigen::VectorXd solve(const Eigen::VectorXd &right_side) const
      {
        return motions_.size() > 0 ? Eigen::VectorXd(factor_.solve(right_side)) : right_side;
      }

      const InterfaceProblem &problem_;
      const InterfaceCompliance &compliance_;
      const MotionTerms &motions_;
      Eigen::VectorXd scaling_, softness_;
      Eigen::LDLT<Eigen::MatrixXd> factor_;
      double norm_;
    };
  } // namespace

  SchemeResult ConjugateScheme::solve(const InterfaceProblem::Loads &loads, const InterfaceState &start,
                                      const StepObserver &observer) const
  {
    double softness = first_softness_of_steps;
    auto scaled = std::make_unique<ScaledProblem>(system_, softness);
    const Eigen::VectorXd gaps = loads.response.head(system_.problem.n_pressures());
    const ContactGuess guess = guess_contact(system_, loads, start.traction);
    Eigen::VectorXd x = scaled->scaled(guess.pressures), motions = guess.motions;
    unsigned int steps = 0;
    const auto count_on = [&](const Eigen::VectorXd &iterate) {
      const Eigen::VectorXd p = scaled->pressures(iterate);
      if (observer)
        observer(step_record(system_.problem, steps, std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::quiet_NaN(), p));
    };
    double accuracy = first_accuracy * parameters_.tolerance, imbalance = 0.;
    for (int outer = 1;; ++outer)
    {
      const BoundedProblem bounded{[&](const Eigen::VectorXd &v) { return scaled->product(v); },
                                   scaled->linear(gaps, motions), scaled->norm()};
      const double small =
          accuracy * (bounded.linear.cwiseMin(0.).norm() + std::numeric_limits<double>::min());
      const bool minimal =
          ProjectedGradients(bounded).solve(small, parameters_.maximum_steps, steps, x, count_on);
      const Eigen::VectorXd p = scaled->pressures(x);
      motions = scaled->motions_for(p, motions);
      SchemeResult result = result_of(loads, p, motions, system_.compliance.apply(p));
      result.steps = steps;
      const bool balanced = system_.motions.is_balanced(p, motions);
      if (balanced && result.iteration_error <= parameters_.tolerance)
        return result;
      if (!minimal || outer == most_outer_steps)
      {
        result.stopped_by = minimal ? StoppedBy::stalled : StoppedBy::maximum_steps;
        result.message = unfinished(minimal, parameters_.maximum_steps);
        return result;
      }
      accuracy = std::max(.2 * accuracy, 1e-13);
      const double before = std::exchange(imbalance, system_.motions.imbalance(p, motions));
      if (outer > 1 && imbalance > .1 * before && softness > last_softness_of_steps)
      {
        softness *= .1;
        scaled = std::make_unique<ScaledProblem>(system_, softness);
      }
    }
  }

  namespace
  {
    SchemeEntry conjugate_entry()
    {
      SchemeEntry entry{"conjugate", "projected conjugate gradients"};
      entry.expected_solves = [](const DecompositionParameters & /*parameters*/, std::size_t /*n_motions*/) {
        return 25.;
      };
      entry.make = [](const SchemeSetting &setting) -> std::unique_ptr<Scheme> {
        return std::make_unique<ConjugateScheme>(*setting.system, setting.parameters);
      };
      return entry;
    }

    const Registered<SchemeEntry> registered_conjugate(conjugate_entry());
  } // namespace
} // namespace abut
