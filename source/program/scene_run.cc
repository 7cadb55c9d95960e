// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/stopwatch.h>
#include <abut/program/command_line.h>
#include <abut/program/scene_run.h>
#include <abut/program/warn.h>
#include <abut/report/atomic_file.h>
#include <abut/report/console.h>
#include <abut/report/describe.h>
#include <abut/report/progress.h>
#include <abut/report/write_all.h>
#include <abut/run/simulation.h>

#include <iostream>
#include <optional>
#include <unistd.h>

namespace abut
{
  int run_scene(const Scene &scene, const Executor &executor, const bool quiet, std::ostream &out,
                std::ostream &err)
  {
    const WallClock clock;
    Simulation simulation(scene, executor);
    simulation.check_supports();
    std::optional<OutputDirectory> directory;
    if (executor.is_first())
    {
      directory.emplace(scene.output_directory);
      remove_old_results(scene.output_directory);
    }
    History history;
    PassDrawings drawings;
    // What mpirun shows a process as a terminal may be a file.
    const bool is_terminal = &out == &std::cout && executor.n_processes() == 1 && isatty(STDOUT_FILENO) != 0;
    ProgressLine progress(out, is_terminal, quiet);
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
    if (scene.writes_report && executor.is_first())
      observer.state = [&](const PassState &state) { drawings.add(state.results); };
    Results results = simulation.run(observer);
    progress.finish();
    const Written written = write_all(results, history, std::move(drawings), scene.output_directory,
                                      clock.seconds(), simulation.executor());
    results.times.output += written.seconds;
    results.left_out.insert(results.left_out.end(), written.left_out.begin(), written.left_out.end());
    warn_with_results(out, err, scene.file, quiet, results.warnings);
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
    warn(err, scene.file, simulation.input_warnings());
    describe(simulation, out);
    simulation.check_supports();
    return ExitStatus::converged;
  }
} // namespace abut
