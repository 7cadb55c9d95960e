// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/stopwatch.h>
#include <abut/base/user_error.h>
#include <abut/program/command_line.h>
#include <abut/report/atomic_file.h>
#include <abut/report/console.h>
#include <abut/report/describe.h>
#include <abut/report/progress.h>
#include <abut/report/write_all.h>
#include <abut/run/simulation.h>
#include <abut/study/reproduction.h>
#include <abut/study/scheme_comparison.h>
#include <abut/study/study.h>

#include <CLI/CLI.hpp>

#include <iostream>
#include <unistd.h>

namespace abut
{
  namespace
  {
    struct Options
    {
      std::string file;
      std::vector<std::string> overrides;
      bool check = false, quiet = false, print_parameters = false;
      bool study = false, reproduce = false, schemes = false;
    };

    /// Empty where the command line is dealt with: `status` is then what to end with.
    std::optional<Options> parse(const int argc, const char *const *argv, int &status, std::ostream &out,
                                 std::ostream &err)
    {
      Options options;
      std::string output;
      CLI::App app("abut: frictionless contact of elastic bodies in plane strain, solved body by body.",
                   "abut");
      app.set_version_flag("--version", "abut " ABUT_VERSION);
      app.add_option("FILE.prm", options.file, "Parameter file: the scene to solve");
      app.add_option("--set", options.overrides,
                     "Override a parameter: 'Section/Sub/Name=value' (repeatable)")
          ->take_all()
          ->allow_extra_args(false);
      app.add_option("--output", output, "Folder of the results (overrides Output/Directory)");
      app.add_flag("--check", options.check, "Check the scene, print what would be solved, and stop");
      app.add_flag("--quiet", options.quiet, "No progress and no tables; errors only");
      app.add_flag("--print-parameters", options.print_parameters,
                   "Print every parameter with its documentation and default, and stop");
      app.add_subcommand("study",
                         "Run the variants that the file's section Study lists: error against run time")
          ->fallthrough()
          ->parse_complete_callback([&] { options.study = true; });
      app.add_subcommand(
             "schemes",
             "Solve the contact on the file's meshes by every scheme: steps, seconds and error of each")
          ->fallthrough()
          ->parse_complete_callback([&] { options.schemes = true; });
      app.add_subcommand("reproduce",
                         "Run the file and the variants of its section Study; write the figures of "
                         "doc/reproducing-the-paper.md and their data")
          ->fallthrough()
          ->parse_complete_callback([&] { options.reproduce = true; });
      app.footer("Exit status: 0 converged; 1 wrong command line, parameter, mesh or scene; 2 ran, but did "
                 "not reach what "
                 "it was asked for (the results say so).");
      try
      {
        app.parse(argc, argv);
        if (options.file.empty() && !options.print_parameters)
          throw CLI::RequiredError("FILE.prm");
      }
      catch (const CLI::ParseError &error)
      {
        const bool is_answer = error.get_exit_code() == 0; // --help, --version
        if (is_answer)
          app.exit(error, out, err);
        else
          err << "abut: " << error.what() << "; `abut --help` lists what is allowed\n";
        status = is_answer ? ExitStatus::converged : ExitStatus::wrong_input;
        return {};
      }
      if (!output.empty())
        options.overrides.push_back("Output/Directory=" + output);
      return options;
    }

    void print_warnings(std::ostream &err, const Scene &scene, const Warnings &warnings)
    {
      for (const Warning &warning : warnings)
        err << "abut: " << scene.file << ": warning (" << to_string(warning.code) << "): " << warning.text
            << '\n';
    }

    int run_scene(const Scene &scene, const bool quiet, std::ostream &out, std::ostream &err)
    {
      const WallClock clock;
      Simulation simulation(scene);
      simulation.check_supports();
      make_output_directory(scene.output_directory);
      remove_old_results(scene.output_directory);
      History history;
      ProgressLine progress(out, &out == &std::cout && isatty(STDOUT_FILENO) != 0, quiet);
      RunObserver observer;
      observer.begin_pass = [&](const unsigned int pass, const Counts &counts) {
        history.begin_pass(pass, counts);
        progress.begin_pass(pass, counts);
      };
      observer.step = [&](const StepRecord &record) {
        history.add(record, clock.seconds());
        progress.step(record);
      };
      observer.estimate = [&](const StepEstimate &estimate) { history.add(estimate); };
      observer.end_pass = [&](const PassRecord &record) { history.end_pass(record); };
      Results results = simulation.run(observer);
      progress.finish();
      const Written written = write_all(results, history, scene.output_directory, clock.seconds());
      results.times.output = written.seconds;
      results.left_out.insert(results.left_out.end(), written.left_out.begin(), written.left_out.end());
      print_warnings(err, scene, results.warnings);
      if (!quiet)
        print_results(out, results, scene.output_directory, clock.seconds());
      if (results.converged())
        return ExitStatus::converged;
      err << "abut: " << scene.file << ": " << results.message() << ". The results in "
          << scene.output_directory << " are marked as not converged\n";
      return ExitStatus::not_converged;
    }

    int study(const Options &options, std::ostream &out, std::ostream &err)
    {
      const std::vector<std::string> failed = run_study(options.file, options.overrides, options.quiet, out);
      for (const std::string &name : failed)
        err << "abut: " << options.file << ": the variant `" << name
            << "` has not reached what it was asked for; run it by itself to see why\n";
      return failed.empty() ? ExitStatus::converged : ExitStatus::not_converged;
    }

    int run(const Options &options, std::ostream &out, std::ostream &err)
    {
      if (options.print_parameters)
      {
        Scene::print_parameters(out);
        return ExitStatus::converged;
      }
      if (options.study)
        return study(options, out, err);
      const auto status_of = [](const bool converged) {
        return converged ? ExitStatus::converged : ExitStatus::not_converged;
      };
      if (options.reproduce)
        return status_of(run_reproduction(options.file, options.overrides, options.quiet, out));
      if (options.schemes)
        return status_of(compare_schemes(options.file, options.overrides, options.quiet, out));
      const Scene scene = Scene::read(options.file, options.overrides);
      if (!options.check)
        return run_scene(scene, options.quiet, out, err);
      const Simulation simulation(scene);
      print_warnings(err, scene, simulation.input_warnings());
      describe(simulation, out);
      simulation.check_supports();
      return ExitStatus::converged;
    }
  } // namespace

  int run_command_line(const int argc, const char *const *argv, std::ostream &out, std::ostream &err)
  {
    int status = ExitStatus::converged;
    const std::optional<Options> options = parse(argc, argv, status, out, err);
    if (!options)
      return status;
    try
    {
      return run(*options, out, err);
    }
    catch (const UserError &error)
    {
      const std::string text = error.what();
      const bool names_file = options->file.empty() || text.find(options->file) != std::string::npos;
      err << "abut: " << (names_file ? "" : options->file + ": ") << text << '\n';
      return ExitStatus::wrong_input;
    }
    catch (const ComputationError &error)
    {
      err << "abut: " << options->file << ": " << error.what() << ". No results were written\n";
      return ExitStatus::not_converged;
    }
    catch (const std::bad_alloc &)
    {
      err << "abut: " << options->file << ": out of memory; use fewer cells (Body <name>/Cells)\n";
      return ExitStatus::not_converged;
    }
    catch (const std::exception &error)
    {
      err << "abut: " << options->file
          << ": ended by an error that the program does not know: " << error.what()
          << ". No results were written\n";
      return ExitStatus::not_converged;
    }
  }
} // namespace abut
