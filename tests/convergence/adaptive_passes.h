// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "solved_scene.h"
#include <functional>

/// The passes of an adapting scene against its exact solution, printed with the rates between neighbours.
class AdaptivePasses
{
public:
  AdaptivePasses(const std::string &title, const std::string &scene,
                 const std::vector<std::string> &overrides);

  /// The error falls like (unknowns)^(-rate): fitted to the passes with at least 1/factor of the last
  /// unknowns.
  double energy_rate(double factor) const;
  double last_energy_error() const { return passes_.back().true_errors.energy.value(); }
  double last_stress_error() const { return passes_.back().true_errors.stress.value(); }
  /// Estimated by true stress error of the last pass.
  double last_effectivity() const { return passes_.back().effectivity().value(); }

private:
  void print(const std::string &title) const;

  std::vector<abut::PassRecord> passes_;
};
