// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/contact_residual.h>
#include <abut/decomposition/measures.h>
#include <abut/decomposition/schemes/projected_gradients.h>
#include <abut/scene/scheme_entry.h>

#include <cmath>

namespace
{
  using namespace abut;

  /// Projected gradients: the pressures move against g + theta p, and those that would pull become zero.
  class GradientScheme : public Scheme
  {
  public:
    explicit GradientScheme(const SchemeSetting &setting)
        : setting_(setting), residual_(setting.problem, setting.compliance)
    {}

    SchemeResult solve(const InterfaceProblem::Loads &loads, const InterfaceState &start,
                       const StepObserver &observer) const override
    {
      const InterfaceProblem &problem = setting_.problem;
      const double step_length = 1. / largest_curvature();
      Eigen::VectorXd p = start.traction.value_or(Eigen::VectorXd::Zero(problem.n_pressures()));
      for (unsigned int step = 1;; ++step)
      {
        SchemeResult result = state_of(p, loads);
        result.steps = step;
        if (observer)
          observer(step_record(problem, step, NAN, result.iteration_error, p));
        if (result.iteration_error <= setting_.parameters.tolerance)
          return result;
        if (step == setting_.parameters.maximum_steps)
        {
          result.stopped_by = StoppedBy::maximum_steps;
          result.message = "The scheme gradient has not reached the tolerance within Decomposition/Maximum "
                           "steps = " +
                           std::to_string(step);
          return result;
        }
        const Eigen::VectorXd gradient = problem.gaps(result.response) + problem.penalties().cwiseProduct(p);
        p = problem.law().project(p - step_length * gradient);
      }
    }

  private:
    /// What pressures p mean, and how far they are from the solution.
    SchemeResult state_of(const Eigen::VectorXd &p, const InterfaceProblem::Loads &loads) const
    {
      const Eigen::VectorXd response_to_p = setting_.compliance.apply(p);
      SchemeResult result;
      result.traction = p;
      result.response = result.iterate = loads.response + response_to_p;
      result.iteration_error = residual_.algebraic(loads, p, response_to_p, result.response);
      result.error_is_bound = false;
      result.stopped_by = StoppedBy::residual;
      return result;
    }

    /// The largest eigenvalue of C/D + theta, and a tenth more: its estimate comes from below.
    double largest_curvature() const
    {
      const InterfaceProblem &problem = setting_.problem;
      const Eigen::VectorXd scaling = problem.weights().cwiseSqrt().cwiseInverse();
      const auto product = [&](const Eigen::VectorXd &x) -> Eigen::VectorXd {
        const Eigen::VectorXd gaps = setting_.compliance.apply(scaling.cwiseProduct(x)).head(x.size());
        return scaling.cwiseProduct(gaps) + problem.penalties().cwiseProduct(x);
      };
      return 1.1 * rough_norm(product, scaling.size());
    }

    const SchemeSetting setting_;
    const ContactResidual residual_;
  };

  SchemeEntry gradient_entry()
  {
    SchemeEntry entry{"gradient", "projected gradients, many steps; every body needs supports"};
    entry.takes_motions = false;
    entry.expected_solves = [](const DecompositionParameters &, std::size_t) { return 1e3; };
    entry.make = [](const SchemeSetting &setting) -> std::unique_ptr<Scheme> {
      return std::make_unique<GradientScheme>(setting);
    };
    return entry;
  }

  const Registered<SchemeEntry> registered_gradient(gradient_entry());
} // namespace
