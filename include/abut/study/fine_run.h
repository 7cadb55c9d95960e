// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/comparison/recorded_solution.h>
#include <abut/study/quantities.h>

#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

namespace abut
{
  /// A variant's problem, solved on much finer meshes.
  struct FineRun
  {
    double error = 0.; ///< estimated, of the whole (ErrorBudget::estimate); relative, energy norm
    Quantities quantities;
    RecordedSolution solution;
  };

  /// The name of the reference, in the column `reference` of study.csv.
  constexpr auto fine_run_name = "fine run";

  /// The share of a variant's error that the fine run's own may have.
  constexpr double allowed_fine_error = .1;

  /**
   * The scene of the fine run for a variant: the file's, the command line's overrides, those of the variant
   * that belong to the problem and not to its solution, exact contact on bodies that adapt, then
   * `Study/Reference run`. What it does not depend on, output and the rest of the study, is empty. Throws
   * UserError.
   */
  Scene fine_scene(const std::string &file, const std::vector<std::string> &overrides,
                   const StudyParameters::Variant &variant);

  /// Everything that the results of a scene depend on: its parameters and what its mesh files hold.
  std::string identity_of(const Scene &scene);

  /**
   * The fine runs of a study, each made once and kept in files of the output directory, `fine_run_*.bin`,
   * from where later studies take it as long as the scene is the same and the program's version.
   */
  class FineRuns
  {
  public:
    /// `told`: hears of each run, for people, before it is made too; may be null.
    FineRuns(std::string directory, std::ostream *told) : directory_(std::move(directory)), told_(told) {}

    /// Throws UserError, also where the fine run knows no error of its own, and ComputationError.
    std::shared_ptr<const FineRun> of(const Scene &fine_scene);

  private:
    std::shared_ptr<const FineRun> make(const Scene &scene) const;

    struct Known
    {
      std::string identity;
      std::shared_ptr<const FineRun> run;
    };
    std::string directory_;
    std::ostream *told_;
    std::vector<Known> known_; ///< of this study
  };
} // namespace abut
