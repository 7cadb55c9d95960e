// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/stopwatch.h>
#include <abut/base/user_error.h>
#include <abut/program/arguments.h>
#include <abut/program/command_line.h>
#include <abut/report/atomic_file.h>
#include <abut/report/console.h>
#include <abut/report/describe.h>
#include <abut/report/progress.h>
#include <abut/report/reference/pages.h>
#include <abut/report/write_all.h>
#include <abut/run/simulation.h>
#include <abut/study/reproduction.h>
#include <abut/study/scheme_comparison.h>
#include <abut/study/study.h>

#include <cstdlib>
#include <initializer_list>
#include <iostream>
#include <sys/stat.h>
#include <unistd.h>

namespace abut
{
  namespace
  {
    void warn(std::ostream &err, const Scene &scene, const Warnings &warnings)
    {
      for (const Warning &warning : warnings)
        err << "abut: " << scene.file << ": warning (" << to_string(warning.code) << "): " << warning.text
            << '\n';
    }

    /// Whether both are read in one place: a terminal, a file.
    bool share_a_reader(const std::ostream &out, const std::ostream &err)
    {
      struct stat of_out, of_err;
      return &out == &std::cout && &err == &std::cerr && fstat(STDOUT_FILENO, &of_out) == 0 &&
             fstat(STDERR_FILENO, &of_err) == 0 && of_out.st_dev == of_err.st_dev &&
             of_out.st_ino == of_err.st_ino;
    }

    int run_scene(const Scene &scene, const bool quiet, std::ostream &out, std::ostream &err)
    {
      const WallClock clock;
      Simulation simulation(scene);
      simulation.check_supports();
      const OutputDirectory directory(scene.output_directory);
      remove_old_results(scene.output_directory);
      History history;
      PassDrawings drawings;
      ProgressLine progress(out, &out == &std::cout && isatty(STDOUT_FILENO) != 0, quiet);
      if (scene.has_tolerance() && !quiet)
        describe_choices(simulation, out);
      RunObserver observer;
      observer.begin_pass = [&](const unsigned int pass, const Counts &counts) {
        history.begin_pass(pass, counts);
        progress.begin_pass(pass, counts);
      };
      observer.step = [&](const StepRecord &record) {
        history.add(record, clock.seconds());
        if (!simulation.pairs().empty())
          progress.step(record);
      };
      observer.estimate = [&](const StepEstimate &estimate) { history.add(estimate); };
      observer.end_pass = [&](const PassRecord &record) {
        history.end_pass(record);
        progress.end_pass(simulation.scene(), record);
      };
      if (scene.writes_report)
        observer.state = [&](const PassState &state) { drawings.add(state.results); };
      Results results = simulation.run(observer);
      progress.finish();
      const Written written =
          write_all(results, history, std::move(drawings), scene.output_directory, clock.seconds());
      results.times.output += written.seconds;
      results.left_out.insert(results.left_out.end(), written.left_out.begin(), written.left_out.end());
      warn(err, scene, results.warnings);
      if (!quiet && !share_a_reader(out, err))
        print_warnings(out, results.warnings);
      if (!quiet)
        print_results(out, results, scene.output_directory, clock.seconds());
      if (results.converged())
        return ExitStatus::converged;
      err << "abut: " << scene.file << ": " << results.message() << ". The results in "
          << scene.output_directory << " are marked as not converged\n";
      return ExitStatus::not_converged;
    }

    int check_scene(const Scene &scene, std::ostream &out, std::ostream &err)
    {
      const Simulation simulation(scene);
      warn(err, scene, simulation.input_warnings());
      describe(simulation, out);
      simulation.check_supports();
      return ExitStatus::converged;
    }

    int status_of(const bool converged)
    {
      return converged ? ExitStatus::converged : ExitStatus::not_converged;
    }

    int study(const Arguments &arguments, std::ostream &out, std::ostream &err)
    {
      if (arguments.check)
      {
        check_study(arguments.file, arguments.overrides, out);
        return ExitStatus::converged;
      }
      const std::vector<std::string> complaints =
          run_study(arguments.file, arguments.overrides, arguments.quiet, out);
      for (const std::string &complaint : complaints)
        err << "abut: " << arguments.file << ": " << complaint << '\n';
      return status_of(complaints.empty());
    }

    /// A number that Open MPI's mpirun or another process manager tells the processes it starts; 0 without
    /// one.
    int told_by_mpirun(std::initializer_list<const char *> names)
    {
      for (const char *name : names)
        if (const char *value = std::getenv(name))
          return std::atoi(value);
      return 0;
    }

    int run(const Arguments &arguments, std::ostream &out, std::ostream &err)
    {
      if (const int n = told_by_mpirun({"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}); n > 1)
      {
        if (told_by_mpirun({"OMPI_COMM_WORLD_RANK", "PMI_RANK"}) == 0)
          err << "abut: received " << n
              << " processes from mpirun, a run is one process; start it without mpirun (it uses the cores "
                 "of this machine by threads)\n";
        return ExitStatus::wrong_input;
      }
      if (arguments.print_parameters)
      {
        Scene::print_parameters(out);
        return ExitStatus::converged;
      }
      for (const ReferencePage &page : reference_pages())
        if (page.name == arguments.reference)
        {
          out << page.text();
          return ExitStatus::converged;
        }
      switch (arguments.task)
      {
      case Task::study:
        return study(arguments, out, err);
      case Task::schemes:
        return status_of(compare_schemes(arguments.file, arguments.overrides, arguments.quiet, out));
      case Task::reproduce:
        return status_of(run_reproduction(arguments.file, arguments.overrides, arguments.quiet, out));
      case Task::solve:
        break;
      }
      const Scene scene = Scene::read(arguments.file, arguments.overrides);
      return arguments.check ? check_scene(scene, out, err) : run_scene(scene, arguments.quiet, out, err);
    }
  } // namespace

  int run_command_line(const int argc, const char *const *argv, std::ostream &out, std::ostream &err)
  {
    int status = ExitStatus::converged;
    const std::optional<Arguments> arguments = parse_arguments(argc, argv, status, out, err);
    if (!arguments)
      return status;
    try
    {
      return run(*arguments, out, err);
    }
    catch (const UserError &error)
    {
      const std::string text = error.what();
      const bool names_file = arguments->file.empty() || text.find(arguments->file) != std::string::npos;
      err << "abut: " << (names_file ? "" : arguments->file + ": ") << text << '\n';
      return ExitStatus::wrong_input;
    }
    catch (const ComputationError &error)
    {
      err << "abut: " << arguments->file << ": " << error.what() << ". No results were written\n";
      return ExitStatus::not_converged;
    }
    catch (const std::bad_alloc &)
    {
      err << "abut: " << arguments->file << ": out of memory; use fewer cells (Body <name>/Cells)\n";
      return ExitStatus::not_converged;
    }
    catch (const std::exception &error)
    {
      err << "abut: " << arguments->file
          << ": ended by an error that the program does not know: " << error.what()
          << ". No results were written\n";
      return ExitStatus::not_converged;
    }
  }
} // namespace abut

int abut_run_command_line(const int argc, const char *const *argv)
{
  return abut::run_command_line(argc, argv, std::cout, std::cerr);
}
