// SPDX-License-Identifier: LGPL-2.1-or-later
#include "program.h"

#include <abut/program/command_line.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <sstream>

namespace abut::testing
{
  namespace
  {
    /// A folder that is removed when the test program ends.
    class TemporaryFolder
    {
    public:
      TemporaryFolder()
      {
        std::string pattern = (std::filesystem::temp_directory_path() / "abut-test-XXXXXX").string();
        path_ = mkdtemp(pattern.data());
      }
      ~TemporaryFolder() { std::filesystem::remove_all(path_); }
      std::filesystem::path next() { return path_ / std::to_string(count_++); }

    private:
      std::filesystem::path path_;
      unsigned int count_ = 0;
    };

    std::filesystem::path new_path()
    {
      static TemporaryFolder folder;
      return folder.next();
    }

    std::vector<std::string> cells(const std::string &line)
    {
      std::vector<std::string> result;
      std::istringstream stream(line + ",");
      for (std::string cell; std::getline(stream, cell, ',');)
        result.push_back(cell);
      return result;
    }
  } // namespace

  Answer run(std::vector<std::string> arguments)
  {
    return run_in(new_path().string(), std::move(arguments));
  }

  namespace
  {
    Answer answer_to(const std::vector<std::string> &arguments, const std::string &directory)
    {
      std::vector<const char *> argv = {"abut"};
      for (const std::string &argument : arguments)
        argv.push_back(argument.c_str());
      std::ostringstream out, err;
      Answer answer{};
      answer.status = run_command_line(static_cast<int>(argv.size()), argv.data(), out, err);
      answer.out = out.str();
      answer.err = err.str();
      answer.directory = directory;
      std::ifstream summary(directory + "/summary.json");
      if (summary)
        answer.summary = nlohmann::json::parse(summary);
      return answer;
    }
  } // namespace

  Answer run_in(const std::string &directory, std::vector<std::string> arguments)
  {
    arguments.insert(arguments.end(), {"--output", directory});
    return answer_to(arguments, directory);
  }

  Answer resume(const std::string &directory, const std::vector<std::string> &more)
  {
    return answer_to(with({"--resume", directory}, more), directory);
  }

  namespace
  {
    Answer run_file(const std::string &path, const std::vector<std::string> &overrides)
    {
      std::vector<std::string> arguments = {path};
      for (const std::string &override : overrides)
        arguments.insert(arguments.end(), {"--set", override});
      return run(arguments);
    }
  } // namespace

  Answer run_scene(const std::string &scene, const std::vector<std::string> &overrides)
  {
    return run_file(project_file("prm/" + scene + ".prm"), overrides);
  }

  Answer run_case(const std::string &name, const std::vector<std::string> &overrides)
  {
    return run_file(project_file("tests/data/cases/" + name + ".prm"), overrides);
  }

  Answer run_text(const std::string &text, const std::vector<std::string> &overrides)
  {
    return run_file(temporary_file("scene.prm", text), overrides);
  }

  std::vector<std::string> with(std::vector<std::string> overrides, const std::vector<std::string> &more)
  {
    overrides.insert(overrides.end(), more.begin(), more.end());
    return overrides;
  }

  void expect_refused(const Answer &answer, const std::vector<std::string> &phrases)
  {
    EXPECT_EQ(answer.status, 1);
    EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << answer.err;
    for (const std::string &phrase : phrases)
      EXPECT_NE(answer.err.find(phrase), std::string::npos)
          << "'" << phrase << "' is missing in: " << answer.err;
    EXPECT_FALSE(std::filesystem::exists(answer.directory)) << "something was written";
  }

  std::multiset<std::string> warning_codes(const Answer &answer)
  {
    std::multiset<std::string> codes;
    for (const auto &warning : answer.summary["warnings"])
      codes.insert(warning["code"].get<std::string>());
    return codes;
  }

  nlohmann::json contact(const Answer &answer, const std::string &name)
  {
    for (const auto &pair : answer.summary["contacts"])
      if (pair["name"] == name)
        return pair;
    ADD_FAILURE() << "no contact " << name;
    return {};
  }

  double contact_value(const Answer &answer, const std::string &name, const std::string &key)
  {
    return contact(answer, name)[key].get<double>();
  }

  void expect_balance(const Answer &answer)
  {
    double worst = 0.;
    for (const auto &body : answer.summary["bodies"])
    {
      EXPECT_LT(body["equilibrium_residual"].get<double>(), 1e-10) << body["name"];
      EXPECT_LT(body["moment_residual"].get<double>(), 1e-10) << body["name"];
      worst = std::max(worst, body["equilibrium_residual"].get<double>());
    }
    std::cout << "worst balance of a body " << worst << '\n';
  }

  std::string project_file(const std::string &name)
  {
    return std::string(ABUT_SOURCE_DIR) + "/" + name;
  }

  std::string temporary_file(const std::string &name, const std::string &content)
  {
    const std::filesystem::path folder = new_path();
    std::filesystem::create_directories(folder);
    std::ofstream(folder / name) << content;
    return (folder / name).string();
  }

  std::string read_file(const std::string &path)
  {
    std::ifstream file(path);
    std::ostringstream content;
    content << file.rdbuf();
    return content.str();
  }

  std::vector<double> column(const std::string &path, const std::string &name)
  {
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    const std::vector<std::string> header = cells(line);
    const auto position = std::find(header.begin(), header.end(), name) - header.begin();
    std::vector<double> values;
    while (std::getline(file, line))
    {
      const std::string cell = cells(line).at(static_cast<std::size_t>(position));
      values.push_back(cell.empty() ? std::numeric_limits<double>::quiet_NaN() : std::stod(cell));
    }
    return values;
  }
} // namespace abut::testing
