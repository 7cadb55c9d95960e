// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/base/user_error.h>
#include <abut/report/atomic_file.h>
#include <abut/report/plot.h>
#include <abut/study/paper_figures.h>
#include <abut/study/reproduction.h>

#include <filesystem>
#include <ostream>
#include <sstream>

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

    PaperRuns run_all(const Scene &scene, const std::string &file, const std::vector<std::string> &overrides)
    {
      std::vector<Scene> scenes; // all are read before the first one runs
      for (const StudyParameters::Variant &variant : scene.study.variants)
      {
        std::vector<std::string> all = overrides;
        all.insert(all.end(), variant.overrides.begin(), variant.overrides.end());
        scenes.push_back(Scene::read(file, all));
      }
      PaperRuns runs;
      runs.base = observe_run(scene, name_of(scene), monitored_point);
      for (std::size_t i = 0; i < scenes.size(); ++i)
        runs.variants.push_back(observe_run(scenes[i], scene.study.variants[i].name, monitored_point));
      return runs;
    }

    std::string shown_error(const std::optional<double> &error)
    {
      return error ? short_number(*error, 3) : std::string("-");
    }

    /// A line for each pass.
    std::string error_table(const ObservedRun &run)
    {
      std::vector<std::vector<std::string>> table = {{run.name, "FEM", "FEM and BEM", "seconds",
                                                      "for estimates", "steps", "stress", "energy",
                                                      "pressure"}};
      double estimates = 0.;
      for (const ObservedPass &pass : run.passes)
      {
        const PassRecord &record = pass.record;
        estimates += pass.estimate_seconds;
        table.push_back({"pass " + std::to_string(record.pass + 1), std::to_string(record.counts.dofs),
                         std::to_string(pass.all_unknowns), short_number(record.seconds, 3),
                         short_number(estimates, 3), std::to_string(record.steps),
                         shown_error(record.true_errors.stress), shown_error(record.true_errors.energy),
                         shown_error(record.true_errors.pressure)});
      }
      return aligned(table);
    }

    std::string error_csv(const std::vector<ObservedRun> &runs)
    {
      std::ostringstream out;
      out << "run,pass,fem,fem_and_bem,seconds,estimate_seconds,true_error_stress,true_error_energy\n";
      for (const ObservedRun &run : runs)
        for (const ObservedPass &pass : run.passes)
          out << '"' << run.name << "\"," << pass.record.pass + 1 << ',' << pass.record.counts.dofs << ','
              << pass.all_unknowns << ',' << exact_number(pass.record.seconds) << ','
              << exact_number(pass.estimate_seconds) << ','
              << exact_number(pass.record.true_errors.stress.value()) << ','
              << exact_number(pass.record.true_errors.energy.value()) << '\n';
      return out.str();
    }

    std::string error_figure(const std::vector<ObservedRun> &runs)
    {
      std::vector<Curve> by_unknowns, by_seconds;
      for (const ObservedRun &run : runs)
      {
        Curve first{run.name, {}, Curve::Style::marks}, second = first;
        for (const ObservedPass &pass : run.passes)
        {
          const double error = pass.record.true_errors.energy.value();
          first.points.emplace_back(static_cast<double>(pass.all_unknowns), error);
          second.points.emplace_back(pass.record.seconds, error);
        }
        by_unknowns.push_back(first);
        by_seconds.push_back(second);
      }
      const Axis error{"true error, energy norm, relative", true};
      return plots({{"a", {"unknowns, those of the boundary elements included", true}, error, by_unknowns},
                    {"b", {"seconds, estimates included", true}, error, by_seconds}});
    }

    void write_errors(const Scene &scene, const std::vector<ObservedRun> &runs, std::ostream &out)
    {
      const std::filesystem::path folder(scene.output_directory);
      write_file((folder / "errors.csv").string(), error_csv(runs));
      write_file((folder / "errors.svg").string(), error_figure(runs));
      for (const ObservedRun &run : runs)
        out << error_table(run) << '\n';
    }
  } // namespace

  bool run_reproduction(const std::string &file, const std::vector<std::string> &overrides, const bool quiet,
                        std::ostream &out)
  {
    const Scene scene = Scene::read(file, overrides);
    if (scene.adaptation.combined)
      exact_half_width(scene); // refuses scenes that the figures are not made for
    else if (!scene.reference.is_named())
      throw UserError("Reference/Exact solution: received `none`, allowed for `abut reproduce` without "
                      "Adaptation/Combined are solutions with a stress: the figures show true errors");
    make_output_directory(scene.output_directory);
    PaperRuns runs = run_all(scene, file, overrides);
    const bool converged = runs.base.converged;
    std::ostringstream text;
    if (scene.adaptation.combined)
    {
      text << write_run_table(scene, runs) << '\n';
      text << write_paper_figures(scene, runs);
    }
    else
    {
      runs.variants.insert(runs.variants.begin(), std::move(runs.base));
      write_errors(scene, runs.variants, text);
    }
    if (!quiet)
      out << text.str() << "  Figures and data in " << scene.output_directory << '\n';
    return converged;
  }
} // namespace abut
