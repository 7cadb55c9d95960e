// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mpirun.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <sys/wait.h>

// Exported by OpenBLAS alone: with another BLAS the address is null.
extern "C" char *openblas_get_corename() __attribute__((weak));

namespace abut::testing
{
  namespace
  {
    std::string in_quotes(const std::string &word)
    {
      return "'" + word + "'"; // no word of these tests has a quote
    }

    /// Runs that are compared have to round alike: the program would choose other kernels of OpenBLAS than
    /// this one has where OpenBLAS does not know the processor. Whatever is started from here inherits it.
    const bool kernels_are_passed_on = [] {
      return openblas_get_corename != nullptr && setenv("OPENBLAS_CORETYPE", openblas_get_corename(), 0) == 0;
    }();

    std::filesystem::path new_folder()
    {
      return std::filesystem::path(temporary_file("marker", "")).parent_path();
    }

    /// Without mpirun's banners, which follow an exit status that is not 0; all of it where abut says
    /// nothing.
    std::string words_of_abut(const std::string &text)
    {
      std::string kept;
      for (const std::string &line : lines(text))
        if (line.rfind("abut: ", 0) == 0)
          kept += line + '\n';
      return kept.empty() ? text : kept;
    }
  } // namespace

  std::vector<std::string> lines(const std::string &text)
  {
    std::vector<std::string> result;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
      result.push_back(line);
    return result;
  }

  Answer run_processes(const std::vector<Group> &groups)
  {
    return run_processes_in(new_folder() / "results", groups);
  }

  namespace
  {
    /// `output`: what is asked of all of them beside.
    Answer answer_of(const std::vector<Group> &groups, const std::string &output)
    {
      const std::filesystem::path folder = new_folder();
      Answer answer{};
      // Tests may run as root, on fewer cores than processes, and side by side: mpirun's session folder is
      // that of all runs unless it is told.
      std::string command =
          "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_orte_tmpdir_base=" +
          in_quotes(folder) + " " ABUT_TIMEOUT " 200 " ABUT_MPIRUN " --oversubscribe";
      for (std::size_t i = 0; i < groups.size(); ++i)
      {
        command += (i > 0 ? " : -np " : " -np ") + std::to_string(groups[i].n_processes) + " " +
                   in_quotes(ABUT_PROGRAM);
        for (const std::string &argument : groups[i].arguments)
          command += " " + in_quotes(argument);
        command += output;
      }
      const std::string out = folder / "out", err = folder / "err";
      const int ended = std::system((command + " >" + in_quotes(out) + " 2>" + in_quotes(err)).c_str());
      answer.status = WIFEXITED(ended) ? WEXITSTATUS(ended) : -1;
      answer.out = read_file(out);
      answer.err = words_of_abut(read_file(err));
      return answer;
    }
  } // namespace

  Answer run_processes_with(const std::vector<Group> &groups)
  {
    return answer_of(groups, "");
  }

  Answer run_processes_in(const std::string &directory, const std::vector<Group> &groups)
  {
    Answer answer = answer_of(groups, " --output " + in_quotes(directory));
    answer.directory = directory;
    std::ifstream summary(answer.directory + "/summary.json");
    if (summary)
      answer.summary = nlohmann::json::parse(summary);
    return answer;
  }
} // namespace abut::testing
