// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/contact_residual.h>
#include <abut/decomposition/model_compliance.h>
#include <abut/decomposition/motion_terms.h>

namespace abut
{
  /// What the schemes newton and conjugate solve, and what they need for it; made once for a mesh.
  struct ContactSystem
  {
    /// Problem and compliance must outlive the object. Takes one product with the compliance. Throws
    /// UserError where the contact law is no linear complementarity problem.
    ContactSystem(const InterfaceProblem &interface_problem, const InterfaceCompliance &interface_compliance,
                  MotionTerms motion_terms);

    const InterfaceProblem &problem;
    const InterfaceCompliance &compliance;
    MotionTerms motions;
    ModelCompliance model;
    ContactResidual residual;
  };
} // namespace abut
