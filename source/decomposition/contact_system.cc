// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/decomposition/contact_system.h>

#include <utility>

namespace abut
{
  namespace
  {
    const InterfaceProblem &with_pressures_alone(const InterfaceProblem &problem)
    {
      if (!problem.law().is_linear_complementarity())
        throw UserError(
            "Decomposition/Scheme: the schemes newton and conjugate know one contact law, pressures "
            "that push without friction; take neumann for any other");
      return problem;
    }
  } // namespace

  ContactSystem::ContactSystem(const InterfaceProblem &interface_problem,
                               const InterfaceCompliance &interface_compliance, MotionTerms motion_terms)
      : problem(with_pressures_alone(interface_problem)), compliance(interface_compliance),
        motions(std::move(motion_terms)), model(problem), residual(problem, compliance)
  {}
} // namespace abut
