// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/comparison/layers_reference.h>
#include <abut/report/atomic_file.h>
#include <abut/study/error_figures.h>
#include <abut/study/paper_figures.h>
#include <abut/study/paper_runs.h>
#include <abut/study/reproduction.h>
#include <abut/study/run_table.h>
#include <abut/study/variants.h>

#include <filesystem>
#include <ostream>

namespace abut
{
  namespace
  {
    const Vector2 monitored_point(.5, .75); // the paper's

    /// For tables and legends: the file's name, or what it does where it refines every cell.
    std::string name_of(const Scene &scene)
    {
      if (scene.adaptation.marking == "fixed fraction" && scene.adaptation.fraction == 1.)
        return "uniform";
      return std::filesystem::path(scene.file).stem().string();
    }

    ObservedRun named_run(const Scene &scene, const std::string &name,
                          const std::vector<std::string> &parameters)
    {
      ObservedRun run = observe_run(scene, monitored_point);
      run.name = name;
      run.parameters = parameters;
      return run;
    }

    std::vector<Scene> read_variants_of(const Scene &scene, const std::vector<std::string> &overrides)
    {
      std::vector<Scene> scenes;
      for (const StudyParameters::Variant &variant : scene.study.variants)
        scenes.push_back(read_variant(scene.file, overrides, variant));
      return scenes;
    }

    PaperRuns run_all(const Scene &scene, const std::vector<Scene> &scenes)
    {
      const std::vector<StudyParameters::Variant> &variants = scene.study.variants;
      PaperRuns runs;
      runs.base = named_run(scene, name_of(scene), {});
      for (std::size_t i = 0; i < scenes.size(); ++i)
        runs.variants.push_back(named_run(scenes[i], variants[i].name, variants[i].parameters));
      return runs;
    }

    /// The paper's numerical example. Whether the scene itself reached what it was asked for.
    bool reproduce_example(const Scene &scene, const std::vector<Scene> &variants, std::string &text)
    {
      if (scene.reference.solution != "infinite layers sliding")
        throw UserError(scene.file +
                        ": Reference/Exact solution must be 'infinite layers sliding' for the figures of "
                        "the combined algorithm");
      const LayersReference reference(scene, Layer::Ends::infinite, Layer::Base::sliding);
      const PressedLayers &exact = reference.solution();
      const OutputDirectory directory(scene.output_directory);
      const PaperRuns runs = run_all(scene, variants);
      text =
          write_run_table(scene, runs, exact.half_width()) + '\n' + write_paper_figures(scene, runs, exact);
      return runs.base.converged;
    }

    /// Errors against cost. The same answer.
    bool reproduce_errors(const Scene &scene, const std::vector<Scene> &variants, std::string &text)
    {
      const auto exact = make_exact_solution(scene);
      if (exact == nullptr || !exact->stress(0))
        throw UserError("Reference/Exact solution: received `" + scene.reference.solution +
                        "`, allowed for `abut reproduce` without Adaptation/Combined are solutions with a "
                        "stress: the figures show true errors");
      const OutputDirectory directory(scene.output_directory);
      PaperRuns runs = run_all(scene, variants);
      const bool converged = runs.base.converged;
      runs.variants.insert(runs.variants.begin(), std::move(runs.base));
      text = write_error_figures(scene, runs.variants);
      return converged;
    }
  } // namespace

  bool run_reproduction(const std::string &file, const std::vector<std::string> &overrides, const bool quiet,
                        std::ostream &out)
  {
    const Scene scene = Scene::read(file, overrides);
    const std::vector<Scene> variants = read_variants_of(scene, overrides); // all, before the first one runs
    std::string text;
    const bool converged = scene.adaptation.combined ? reproduce_example(scene, variants, text)
                                                     : reproduce_errors(scene, variants, text);
    if (!quiet)
      out << text << "  Figures and data in " << scene.output_directory << '\n';
    return converged;
  }
} // namespace abut
