// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/archive.h>
#include <abut/decomposition/compliance.h>
#include <abut/scene/decomposition_parameters.h>

#include <functional>
#include <limits>
#include <optional>
#include <string>

namespace abut
{
  /// One state of the interface: u^k as far as the pairs see it.
  struct InterfaceState
  {
    /// Pressures whose response, with that to the loads, is the displacement u^k. Empty where u^k is no
    /// field: the paper's literal initial guess gives displacements on the contact nodes alone,
    /// which answer no pressures, so that nothing bounds the error of u^k in the energy norm.
    std::optional<Eigen::VectorXd> traction;
    Eigen::VectorXd response; ///< see InterfaceProblem
  };

  /// What a step tells of itself.
  struct StepRecord
  {
    unsigned int step = 0; ///< from 1
    double increment = 0.; ///< largest relative change of the contact displacement of a body, discrete norm
    double bound = std::numeric_limits<double>::quiet_NaN(); ///< see SchemeResult::iteration_error, for the
                                                             ///< state the step began with
    double normal_force = 0.;                                ///< sum of D_k p_k of that state
    double max_pressure = 0.;                                ///< largest load p_k, not the reported pressure
    /// While the observer runs: the pressures that the displacement of that state answers (null where it is
    /// no field), and those that the contact law makes of it.
    const Eigen::VectorXd *answered = nullptr, *applied = nullptr;

    /// All but what is there while the observer runs.
    void serialize(Archive &archive) { archive(step, increment, bound, normal_force, max_pressure); }
  };

  using StepObserver = std::function<void(const StepRecord &)>;

  enum class StoppedBy
  {
    bound,
    residual, ///< the algebraic error of the contact law, see ContactResidual
    increment,
    maximum_steps,
    stalled
  };

  struct SchemeResult
  {
    /// Pressures in equilibrium with the displacement that is reported.
    Eigen::VectorXd traction;
    /// Response of that displacement.
    Eigen::VectorXd response;
    /// The last iterate u^k as the pairs see it: the same, but where u^k is no field.
    Eigen::VectorXd iterate;
    /// Amplitudes of the motions that no support prescribes (see InterfaceMotions); empty for the parallel
    /// Neumann scheme.
    Eigen::VectorXd motions;
    unsigned int steps = 0;
    StoppedBy stopped_by = StoppedBy::maximum_steps;
    /// Where `error_is_bound`: ||u - u_theta||_A is at most this times the smaller of ||u||_A and the norm of
    /// the part of u that contact makes (energy norm, same mesh). NaN where there is no bound; after the
    /// increment rule it belongs to the iterate before the last, which for gamma < gamma* is no better.
    double iteration_error = std::numeric_limits<double>::quiet_NaN();
    /// False: `iteration_error` is an algebraic error, see ContactResidual, whatever stopped the scheme.
    bool error_is_bound = true;
    double increment = std::numeric_limits<double>::quiet_NaN(); ///< NaN: the scheme does not tell
    double relaxation = 0.;                                      ///< gamma
    /// One sentence with cause and way out; empty when converged.
    std::string message;

    bool converged() const { return message.empty(); }
  };

  struct ContactSystem;

  /// What a scheme is made of: an interface problem, and the parameters chosen for it. All must outlive it.
  struct SchemeSetting
  {
    const InterfaceProblem &problem;
    const InterfaceCompliance &compliance;
    const ContactSystem *system; ///< null for a scheme that takes no motions
    const DecompositionParameters &parameters;
  };

  /// Solves the interface problem: given the traction, every body solves its own linear problem,
  /// independently.
  class Scheme
  {
  public:
    virtual ~Scheme() = default;

    /// The state that it begins with, from the pressures of a mesh before where there are such.
    virtual InterfaceState first_state(const InterfaceProblem::Loads & /*loads*/,
                                       const std::optional<Eigen::VectorXd> &pressures) const
    {
      return {pressures, {}};
    }

    virtual SchemeResult solve(const InterfaceProblem::Loads &loads, const InterfaceState &start,
                               const StepObserver &observer) const = 0;
  };
} // namespace abut
