// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/interface_solver.h>
#include <abut/run/model.h>

namespace abut
{
  /// The body with a rigid side that carries a given force, or null.
  const Body *body_with_resultant(const Model &model);

  struct RigidSideSolution
  {
    SchemeResult iteration;
    double displacement = 0.;
  };

  /**
   * Scheme neumann: the displacement of the rigid side for which it carries its force, by a secant method,
   * and the interface problem's solution there; its steps are those of all solutions. `guess`: of the
   * displacement, 0 where there is none. Throws ComputationError.
   */
  RigidSideSolution solve_with_resultant(const Model &model, const InterfaceSolver &solver,
                                         const std::optional<Eigen::VectorXd> &start, double guess,
                                         double tolerance, const StepObserver &observer);
} // namespace abut
