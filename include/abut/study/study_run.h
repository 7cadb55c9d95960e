// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/run/checks/validity.h>
#include <abut/study/fine_run.h>

#include <optional>
#include <string>
#include <vector>

namespace abut
{
  /// One pass of a variant.
  struct StudyPass
  {
    PassRecord record; ///< its seconds without what the study looked at
    Quantities quantities;
    /// Against the fine run, relative.
    std::optional<double> peak_pressure_error, strain_energy_error;
    bool is_compared = false; ///< with the fine run, which is good enough
  };

  /// One variant of a study.
  struct StudyRun
  {
    StudyParameters::Variant variant;
    std::string reference; ///< what errors are against: an exact solution, `fine run`, or empty
    std::optional<double> reference_error; ///< estimated, of the fine run
    std::vector<StudyPass> passes;
    bool converged = false;
    Warnings warnings;   ///< those that the run by itself has
    std::string refusal; ///< why the fine run is no reference for some passes; empty where it is for all

    const std::string &name() const { return variant.name; }
  };

  /// Runs a variant. `fine`: what to compare with where the scene names no exact solution; may be null.
  /// Throws UserError and ComputationError.
  StudyRun run_variant(const StudyParameters::Variant &variant, const Scene &scene, const FineRun *fine);
} // namespace abut
