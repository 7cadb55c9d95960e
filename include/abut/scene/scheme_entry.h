// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/registry.h>

#include <memory>

namespace dealii
{
  class ParameterHandler;
}

namespace abut
{
  class InterfaceProblem;
  class Scheme;
  struct DecompositionParameters;
  struct SchemeSetting;

  /// What stands behind a word of `Scheme`. Each scheme has its own in source/decomposition/schemes/.
  struct SchemeEntry
  {
    static constexpr const char *parameter = "Scheme";

    std::string name, documentation;
    /// Declares and reads entries of the section Decomposition that are the scheme's own; null: it has none.
    void (*declare)(dealii::ParameterHandler &prm) = nullptr;
    void (*parse)(const dealii::ParameterHandler &prm, DecompositionParameters &parameters) = nullptr;

    /// Amplitudes of floating bodies and of rigid sides with resultants are unknowns of it. Else every body
    /// needs supports, and one resultant takes several solutions, more are beyond it.
    bool takes_motions = true;
    /// Exact contact is within its reach. Else every contact needs a penalty above 0.
    bool solves_exact_contact = true;
    /// It iterates on displacements: a step puts the pressures that the contact law makes of the last one
    /// onto the bodies. Such a step may be taken for every mesh (Combined), estimated (Estimate steps), and
    /// stopped by its increment.
    bool iterates_displacements = false;

    /// The parameters with numbers in place of what is automatic, for a problem; null: nothing is.
    DecompositionParameters (*chosen)(const InterfaceProblem &problem,
                                      const DecompositionParameters &parameters) = nullptr;
    /// Solves of each body with the chosen parameters, roughly; `n_motions`: unknown amplitudes.
    double (*expected_solves)(const DecompositionParameters &parameters, std::size_t n_motions) = nullptr;
    std::unique_ptr<Scheme> (*make)(const SchemeSetting &setting) = nullptr;
  };

  /// That of the scene. Throws UserError for a word that is none.
  const SchemeEntry &scheme_of(const DecompositionParameters &parameters);

  /// Names of the schemes with a property, for messages.
  std::string schemes_with(bool SchemeEntry::*property, bool value, const std::string &separator);
} // namespace abut
