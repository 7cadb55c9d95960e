// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/base/stopwatch.h>
#include <abut/base/user_error.h>
#include <abut/program/command_line.h>
#include <abut/program/scene_run.h>
#include <abut/program/warn.h>
#include <abut/report/atomic_file.h>
#include <abut/report/checkpoint.h>
#include <abut/report/checkpoint_writer.h>
#include <abut/report/console.h>
#include <abut/report/describe.h>
#include <abut/report/progress.h>
#include <abut/report/write_all.h>
#include <abut/run/simulation.h>

#include <filesystem>
#include <iostream>
#include <optional>
#include <unistd.h>

namespace abut
{
  namespace
  {
    /// What a run has told so far.
    struct Told
    {
      History history;
      PassDrawings drawings;
    };

    struct Streams
    {
      std::ostream &out, &err;
      bool quiet;
    };

    void tell_progress(RunObserver &observer, const Simulation &simulation, History &history,
                       ProgressLine &progress, const WallClock &clock)
    {
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
    }

    /// From the next pass to the results. The folder of the results is this run's.
    int run_to_end(Simulation &simulation, Told told, const WallClock &clock, const Streams &streams)
    {
      const Scene &scene = simulation.scene();
      const Executor &executor = simulation.executor();
      const std::string &directory = scene.output_directory;
      auto &[out, err, quiet] = streams;
      // What mpirun shows a process as a terminal may be a file.
      const bool is_terminal =
          &out == &std::cout && executor.n_processes() == 1 && isatty(STDOUT_FILENO) != 0;
      ProgressLine progress(out, is_terminal, quiet);
      RunObserver observer;
      tell_progress(observer, simulation, told.history, progress, clock);
      if (scene.writes_report)
        observer.state = [&](const PassState &state) { told.drawings.add(state.results, executor); };
      std::optional<CheckpointWriter> checkpoints;
      if (executor.is_first())
        checkpoints.emplace(scene, directory);
      observer.adapted = [&](const RunState &state) {
        if (checkpoints)
          checkpoints->save(state, told.history, told.drawings);
      };
      Results results = simulation.run(observer);
      progress.finish();
      if (checkpoints)
        append(results.warnings, checkpoints->warnings());
      const Written written =
          write_all(results, told.history, std::move(told.drawings), directory, clock.seconds(), executor);
      if (executor.is_first())
        remove_checkpoint(directory);
      results.times.output += written.seconds;
      results.left_out.insert(results.left_out.end(), written.left_out.begin(), written.left_out.end());
      warn_with_results(out, err, scene.file, quiet, results.warnings);
      if (!quiet)
        print_results(out, results, directory, clock.seconds());
      if (results.converged())
        return ExitStatus::converged;
      err << "abut: " << scene.file << ": " << results.message() << ". The results in " << directory
          << " are marked as not converged\n";
      return ExitStatus::not_converged;
    }
  } // namespace

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
      remove_checkpoint(scene.output_directory);
    }
    if (scene.has_tolerance() && !quiet)
      describe_choices(simulation, out);
    return run_to_end(simulation, {}, clock, {out, err, quiet});
  }

  int resume_run(const std::string &directory, const Executor &executor, const bool quiet, std::ostream &out,
                 std::ostream &err)
  {
    WallClock clock;
    std::optional<OutputDirectory> locked; // by the first process, which reads for all
    Checkpoint checkpoint = executor.from_first([&]() {
      if (!std::filesystem::is_directory(directory))
        throw UserError("--resume: received `" + directory + "`, allowed is the folder of a run");
      locked.emplace(directory);
      return read_checkpoint(directory);
    });
    const Scene scene = checkpoint.scene(directory);
    clock.add(checkpoint.state.seconds);
    if (!quiet)
      out << "  Going on with " << scene.file << " after pass " << checkpoint.state.passes.back().pass << ", "
          << short_number(checkpoint.state.seconds, 3) << " s\n";
    Simulation simulation(scene, executor);
    simulation.go_on_from(std::move(checkpoint.state));
    return run_to_end(simulation, {std::move(checkpoint.history), std::move(checkpoint.drawings)}, clock,
                      {out, err, quiet});
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
