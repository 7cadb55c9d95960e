// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <nlohmann/json.hpp>

#include <set>
#include <string>
#include <vector>

namespace abut::testing
{
  /// What the program answered.
  struct Answer
  {
    int status;
    std::string out, err;
    std::string directory;  ///< where the results were to go
    nlohmann::json summary; ///< null where none was written
  };

  /// Runs the program's command line in this process, with `--output` set to a new folder of the test's own.
  Answer run(std::vector<std::string> arguments);

  /// The same with a folder of the caller's.
  Answer run_in(const std::string &directory, std::vector<std::string> arguments);

  /// Goes on with the run whose results are to be in a folder.
  Answer resume(const std::string &directory, const std::vector<std::string> &more = {});

  /// Runs a scene of the project's folder `prm` with overrides `Section/Name=value`.
  Answer run_scene(const std::string &scene, const std::vector<std::string> &overrides = {});

  /// The same for an input of the folder `tests/data/cases`.
  Answer run_case(const std::string &name, const std::vector<std::string> &overrides = {});

  /// Runs a scene given as the text of its file.
  Answer run_text(const std::string &text, const std::vector<std::string> &overrides = {});

  /// Two lists of overrides, one after the other.
  std::vector<std::string> with(std::vector<std::string> overrides, const std::vector<std::string> &more);

  /// A refusal as it should be: status 1, one line that contains all phrases, nothing written.
  void expect_refused(const Answer &answer, const std::vector<std::string> &phrases);

  /// The codes of the summary's warnings.
  std::multiset<std::string> warning_codes(const Answer &answer);

  /// What the summary says of a contact; null, with a failure, where there is none of that name.
  nlohmann::json contact(const Answer &answer, const std::string &name);

  /// A number of it.
  double contact_value(const Answer &answer, const std::string &name, const std::string &key);

  /// The forces and moments on every body balance.
  void expect_balance(const Answer &answer);

  /// The path of a file of the project.
  std::string project_file(const std::string &name);

  /// Writes a file into a new folder of the test's own and returns its path.
  std::string temporary_file(const std::string &name, const std::string &content);

  std::string read_file(const std::string &path);

  /// The numbers of a CSV file's column; empty cells are NaN.
  std::vector<double> column(const std::string &path, const std::string &name);
} // namespace abut::testing
