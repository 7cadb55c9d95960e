// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/base/user_error.h>
#include <abut/report/atomic_file.h>
#include <abut/run/simulation.h>
#include <abut/study/quality_table.h>
#include <abut/study/result_file.h>
#include <abut/study/study.h>
#include <abut/study/study_data.h>
#include <abut/study/study_page.h>
#include <abut/study/study_table.h>
#include <abut/study/study_warnings.h>
#include <abut/study/sweeps.h>
#include <abut/study/variants.h>

#include <ostream>

namespace abut
{
  namespace
  {
    Scene read_study(const std::string &file, const std::vector<std::string> &overrides)
    {
      Scene scene = Scene::read(file, overrides);
      if (scene.study.variants.empty())
        throw UserError(file +
                        ": Study/Variants: received an empty list, a study needs at least one variant, "
                        "load case or sweep");
      return scene;
    }

    /// Calls something for a variant; what it refuses begins with the variant's name.
    template <typename Action> auto for_variant(const StudyParameters::Variant &variant, const Action &action)
    {
      try
      {
        return action();
      }
      catch (const UserError &error)
      {
        throw UserError("variant `" + variant.name + "`: " + error.what());
      }
    }

    /// What a study works with.
    struct ReadVariant
    {
      const StudyParameters::Variant &variant;
      Scene scene;
      std::optional<Scene> fine; ///< of the fine run it is compared with
    };

    /// All are read before the first one runs.
    std::vector<ReadVariant> read_variants(const Scene &scene, const std::vector<std::string> &overrides)
    {
      std::vector<ReadVariant> all;
      for (const StudyParameters::Variant &variant : scene.study.variants)
        all.push_back(for_variant(variant, [&]() -> ReadVariant {
          ReadVariant read{variant, read_variant(scene.file, overrides, variant), {}};
          if (scene.study.has_fine_run && !read.scene.reference.is_named())
            read.fine = fine_scene(scene.file, overrides, variant);
          return read;
        }));
      return all;
    }

    void print_run(const StudyRun &run, std::ostream &out)
    {
      out << study_table(run) << '\n';
      const std::string quality = quality_table(run);
      if (!quality.empty())
        out << quality << '\n';
      out << std::flush;
    }

    void print_quantities(const std::vector<StudyRun> &runs, std::ostream &out)
    {
      const std::string legend = study_table_legend(runs);
      if (!legend.empty())
        out << legend << '\n';
      out << "  " << quantity_title(runs) << '\n' << aligned(quantity_table(runs)) << '\n';
    }

    std::vector<std::string> complaints(const std::vector<StudyRun> &runs)
    {
      std::vector<std::string> texts;
      for (const StudyRun &run : runs)
      {
        if (!run.converged)
          texts.push_back("the variant `" + run.name() +
                          "` has not reached what it was asked for; run it by itself to see why");
        if (!run.refusal.empty())
          texts.push_back(run.refusal);
      }
      return texts;
    }
  } // namespace

  StudyMessages run_study(const std::string &file, const std::vector<std::string> &overrides,
                          const bool quiet, std::ostream &out)
  {
    const Scene scene = read_study(file, overrides);
    const std::vector<ReadVariant> variants = read_variants(scene, overrides);
    const std::vector<StudyLine> peers = read_peers(scene);
    const OutputDirectory directory(scene.output_directory);
    FineRuns fine_runs(scene.output_directory, quiet ? nullptr : &out);
    std::vector<StudyRun> runs;
    std::vector<std::string> failures;
    for (const ReadVariant &read : variants)
      try
      {
        runs.push_back(for_variant(read.variant, [&] {
          const auto fine = read.fine ? fine_runs.of(*read.fine) : nullptr;
          return run_variant(read.variant, read.scene, fine.get());
        }));
        if (!quiet)
          print_run(runs.back(), out);
      }
      catch (const ComputationError &error)
      {
        failures.push_back("the variant `" + read.variant.name + "` has no results: " + error.what());
      }
    if (runs.empty())
      throw ComputationError(failures.front());
    const std::string table = write_result(scene, "study.csv", csv(study_data(runs)));
    const std::string page = write_result(scene, "study.html", study_page(scene, runs, peers));
    if (!quiet)
      print_quantities(runs, out);
    if (!quiet)
      out << "  The same in " << table << ", with diagrams in " << page << '\n';
    const std::vector<std::string> unreached = complaints(runs);
    failures.insert(failures.end(), unreached.begin(), unreached.end());
    return {study_warnings(runs), failures};
  }

  Warnings check_study(const std::string &file, const std::vector<std::string> &overrides, std::ostream &out)
  {
    const Scene scene = read_study(file, overrides);
    std::vector<VariantWarnings> warnings;
    for (const StudyParameters::Variant &variant : scene.study.variants)
      for_variant(variant, [&] {
        const Scene changed = read_variant(file, overrides, variant);
        const Simulation simulation(changed);
        warnings.push_back({variant.name, simulation.input_warnings()});
        simulation.check_supports();
        if (scene.study.has_fine_run && !changed.reference.is_named())
          fine_scene(file, overrides, variant);
        out << "Variant " << variant.name << ": " << simulation.bodies().size() << " bodies, "
            << simulation.pairs().size() << " contacts, " << simulation.counts().cells << " cells, "
            << simulation.counts().dofs << " unknowns\n";
      });
    read_peers(scene);
    return study_warnings(warnings);
  }
} // namespace abut
