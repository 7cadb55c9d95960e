// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/processes.h>
#include <abut/base/user_error.h>
#include <abut/program/arguments.h>
#include <abut/program/command_line.h>
#include <abut/program/scene_run.h>
#include <abut/program/warn.h>
#include <abut/report/reference/pages.h>
#include <abut/study/reproduction.h>
#include <abut/study/scheme_comparison.h>
#include <abut/study/study.h>

#include <iostream>
#include <memory>

namespace abut
{
  namespace
  {
    int status_of(const bool converged)
    {
      return converged ? ExitStatus::converged : ExitStatus::not_converged;
    }

    int study(const Arguments &arguments, std::ostream &out, std::ostream &err)
    {
      if (arguments.check)
      {
        warn(err, arguments.file, check_study(arguments.file, arguments.overrides, out));
        return ExitStatus::converged;
      }
      const StudyMessages messages = run_study(arguments.file, arguments.overrides, arguments.quiet, out);
      warn_with_results(out, err, arguments.file, arguments.quiet, messages.warnings);
      for (const std::string &complaint : messages.complaints)
        err << "abut: " << arguments.file << ": " << complaint << '\n';
      return status_of(messages.complaints.empty());
    }

    /// In all processes, where there are several.
    int solve(const Arguments &arguments, const std::shared_ptr<Processes> &processes, std::ostream &out,
              std::ostream &err)
    {
      int status = ExitStatus::converged;
      const auto run = [&]() {
        const Executor executor(processes);
        status = arguments.resume.empty() ? run_scene(Scene::read(arguments.file, arguments.overrides),
                                                      executor, arguments.quiet, out, err)
                                          : resume_run(arguments.resume, executor, arguments.quiet, out, err);
      };
      if (processes)
        processes->run(run);
      else
        run();
      return status;
    }

    void refuse_processes(const Arguments &arguments, const Launch &launch)
    {
      if (arguments.task != Task::solve && !arguments.check)
        throw UserError("received " + std::to_string(launch.n_processes) +
                        " processes from mpirun, which share the run of a scene only; start this command "
                        "without mpirun (it uses the cores of this machine by threads)");
    }

    /// What one process does by itself.
    int run(const Arguments &arguments, std::ostream &out, std::ostream &err)
    {
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
      if (arguments.check)
        return check_scene(Scene::read(arguments.file, arguments.overrides), out, err);
      return solve(arguments, nullptr, out, err);
    }

    /// What one of several processes does; the first one does alone what they cannot share.
    int run_as_one_of(const Launch &launch, const Arguments &arguments, std::shared_ptr<Processes> &processes,
                      std::ostream &out, std::ostream &err)
    {
      refuse_processes(arguments, launch);
      if (arguments.task == Task::solve && !arguments.check && !arguments.print_parameters &&
          arguments.reference.empty())
      {
        processes = std::make_shared<Processes>(launch);
        return solve(arguments, processes, out, err);
      }
      return launch.rank == 0 ? run(arguments, out, err) : ExitStatus::converged;
    }

    int run_process(const Launch &launch, const int argc, const char *const *argv, std::ostream &out,
                    std::ostream &err)
    {
      int status = ExitStatus::converged;
      const std::optional<Arguments> arguments = parse_arguments(argc, argv, status, out, err);
      if (!arguments)
        return status;
      const std::string &subject = arguments->resume.empty() ? arguments->file : arguments->resume;
      std::shared_ptr<Processes>
          processes; // until the last word is said: mpirun ends all when one has ended badly
      try
      {
        return launch.n_processes > 1 ? run_as_one_of(launch, *arguments, processes, out, err)
                                      : run(*arguments, out, err);
      }
      catch (const UserError &error)
      {
        const std::string text = error.what();
        const bool names_file = subject.empty() || text.find(subject) != std::string::npos;
        // one piece: mpirun's lines do not come within it
        err << "abut: " + (names_file ? "" : subject + ": ") + text + '\n';
        return ExitStatus::wrong_input;
      }
      catch (const ComputationError &error)
      {
        err << "abut: " + subject + ": " + error.what() + ". No results were written\n";
        return ExitStatus::not_converged;
      }
      catch (const std::bad_alloc &)
      {
        err << "abut: " << subject << ": out of memory; use fewer cells (Body <name>/Cells)\n";
        return ExitStatus::not_converged;
      }
      catch (const std::exception &error)
      {
        err << "abut: " << subject << ": ended by an error that the program does not know: " << error.what()
            << ". No results were written\n";
        return ExitStatus::not_converged;
      }
    }
  } // namespace

  int run_command_line(const int argc, const char *const *argv, std::ostream &out, std::ostream &err)
  {
    const Launch launch = Launch::from_environment();
    if (launch.rank == 0)
      return run_process(launch, argc, argv, out, err);
    std::ostream silent(nullptr);
    return run_process(launch, argc, argv, silent, silent);
  }
} // namespace abut

int abut_run_command_line(const int argc, const char *const *argv)
{
  return abut::run_command_line(argc, argv, std::cout, std::cerr);
}
