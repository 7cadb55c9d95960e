// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/text.h>
#include <abut/scene/parameter_file.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <sstream>

namespace abut
{
  namespace
  {
    ParameterLine line_of_override(const std::string &given)
    {
      const auto equals = given.find('=');
      ParameterLine line;
      std::stringstream names(given.substr(0, equals) + "/");
      for (std::string name; std::getline(names, name, '/');)
        line.sections.push_back(trim(name));
      const bool has_empty_name = std::any_of(line.sections.begin(), line.sections.end(),
                                              [](const auto &name) { return name.empty(); });
      if (equals == std::string::npos || has_empty_name ||
          given.find_first_of("#\\\n\r") != std::string::npos)
        throw UserError("override `" + std::regex_replace(given, std::regex("[\n\r]+"), " ") +
                        "`: allowed is Section/Sub/Name=value in one line without # and \\");
      line.sets = true;
      line.name = line.sections.back();
      line.sections.pop_back();
      line.value = trim(given.substr(equals + 1));
      line.place = "override `" + given + "`: ";
      return line;
    }
  } // namespace

  ParameterFile::ParameterFile(const std::string &name, const std::vector<std::string> &overrides)
      : name_(name), text_(read_parameter_text(name))
  {
    for (const auto &given : overrides)
      overrides_.push_back(line_of_override(given));
  }

  namespace
  {
    /// Empty where there is none any more.
    std::string present_directory()
    {
      std::error_code gone;
      return std::filesystem::current_path(gone).string();
    }
  } // namespace

  SceneInput ParameterFile::read() const
  {
    return {name_, read_parameter_lines(text_), overrides_, present_directory()};
  }

  std::string SceneInput::directory() const
  {
    const std::filesystem::path folder = std::filesystem::path(name).parent_path();
    return working_directory == present_directory() ? folder.string() : (working_directory / folder).string();
  }
} // namespace abut
