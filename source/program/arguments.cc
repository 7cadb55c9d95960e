// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/program/arguments.h>
#include <abut/program/command_line.h>

#include <CLI/CLI.hpp>

#include <ostream>

namespace abut
{
  namespace
  {
    void add_options(CLI::App &app, Arguments &arguments, std::string &output)
    {
      app.set_version_flag("--version", "abut " ABUT_VERSION);
      app.add_option("FILE.prm", arguments.file, "Parameter file: the scene to solve");
      app.add_option("--set", arguments.overrides,
                     "Override a parameter: 'Section/Sub/Name=value' (repeatable)")
          ->take_all()
          ->allow_extra_args(false);
      app.add_option("--output", output, "Folder of the results (overrides Output/Directory)");
      app.add_option("--resume", arguments.resume,
                     "Instead of FILE.prm: go on with the run that was interrupted, with its results in DIR")
          ->type_name("DIR");
      app.add_flag("--check", arguments.check, "Check the scene, print what would be solved, and stop");
      app.add_flag("--quiet", arguments.quiet, "No progress and no tables; errors only");
      app.add_flag("--print-parameters", arguments.print_parameters,
                   "Print every parameter with its documentation and default, and stop");
      app.add_option("--reference", arguments.reference,
                     "Print a file of doc/reference, all parameters or what result files hold, and stop")
          ->check(CLI::IsMember(std::vector<std::string>{"parameters", "results", "schema"}));
    }

    void add_tasks(CLI::App &app, Arguments &arguments)
    {
      struct Word
      {
        Task task;
        const char *name, *documentation;
      };
      static const Word words[] = {
          {Task::study, "study",
           "Run the variants that the file's section Study lists: error against run time"},
          {Task::schemes, "schemes",
           "Solve the contact on the file's meshes by every scheme: steps, seconds and error of each"},
          {Task::reproduce, "reproduce",
           "Run the file and the variants of its section Study; write the figures of "
           "doc/reproducing-the-paper.md and their data"}};
      for (const Word &word : words)
        app.add_subcommand(word.name, word.documentation)->fallthrough()->parse_complete_callback([&] {
          if (arguments.task == Task::solve || word.task < arguments.task)
            arguments.task = word.task;
        });
    }

    /// The exit status after the parser has given up: with an answer, or for a mistake.
    int answer(const CLI::App &app, const CLI::ParseError &error, std::ostream &out, std::ostream &err)
    {
      const bool is_answer = error.get_exit_code() == 0; // --help, --version
      if (is_answer)
        app.exit(error, out, err);
      else
        // one piece: mpirun's lines do not come within it
        err << std::string("abut: ") + error.what() + "; `abut --help` lists what is allowed\n";
      return is_answer ? ExitStatus::converged : ExitStatus::wrong_input;
    }
  } // namespace

  std::optional<Arguments> parse_arguments(const int argc, const char *const *argv, int &status,
                                           std::ostream &out, std::ostream &err)
  {
    Arguments arguments;
    std::string output;
    CLI::App app("abut: frictionless contact of elastic bodies in plane strain, solved body by body.",
                 "abut");
    add_options(app, arguments, output);
    add_tasks(app, arguments);
    // After the subcommands, which would inherit it.
    app.footer(
        "`mpirun -np N abut FILE.prm` shares the bodies of a scene among N processes.\n\n"
        "A long run that adapts saves its state in the folder of its results; `abut --resume DIR` goes "
        "on from there if it was interrupted, on any number of processes.\n\n"
        "Exit status: 0 converged; 1 wrong command line, parameter, mesh or scene; 2 ran, but did not "
        "reach what it was asked for (the results say so).");
    try
    {
      app.parse(argc, argv);
      if (!arguments.resume.empty() && (!arguments.file.empty() || !arguments.overrides.empty() ||
                                        !output.empty() || arguments.check || arguments.task != Task::solve))
        throw CLI::ExcludesError("--resume", "all but --quiet: it is a scene's run, with its own parameters");
      if (arguments.file.empty() && arguments.resume.empty() && !arguments.print_parameters &&
          arguments.reference.empty())
        throw CLI::RequiredError("FILE.prm");
    }
    catch (const CLI::ParseError &error)
    {
      status = answer(app, error, out, err);
      return {};
    }
    if (!output.empty())
      arguments.overrides.push_back("Output/Directory=" + output);
    return arguments;
  }
} // namespace abut
