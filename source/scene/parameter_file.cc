// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/text.h>
#include <abut/scene/parameter_file.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

namespace abut
{
  namespace
  {
    std::string read_text(const std::string &name)
    {
      std::ifstream file(name, std::ios::binary);
      if (!file || std::filesystem::is_directory(name))
        throw UserError("Parameter file `" + name + "`: cannot be read");
      std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
      text.erase(std::remove(text.begin(), text.end(), '\r'), text.end());
      return text;
    }

    /// `Section/Sub/Name=value` as lines of a parameter file.
    std::string lines_of_override(const std::string &given)
    {
      const auto equals = given.find('=');
      std::vector<std::string> path;
      std::stringstream names(given.substr(0, equals) + "/");
      for (std::string name; std::getline(names, name, '/');)
        path.push_back(trim(name));
      const bool has_empty_name =
          std::any_of(path.begin(), path.end(), [](const auto &name) { return name.empty(); });
      if (equals == std::string::npos || has_empty_name ||
          given.find_first_of("#\\\n\r") != std::string::npos)
        throw UserError("override `" + std::regex_replace(given, std::regex("[\n\r]+"), " ") +
                        "`: allowed is Section/Sub/Name=value in one line without # and \\");

      std::string lines, ends;
      for (std::size_t level = 0; level + 1 < path.size(); ++level)
      {
        lines += "subsection " + path[level] + "\n";
        ends += "end\n";
      }
      return lines + "set " + path.back() + " = " + trim(given.substr(equals + 1)) + "\n" + ends;
    }

    /// deal.II's message, its place in the file as `line 7`, or left out where it means nothing.
    std::string readable(const dealii::ExceptionBase &exception, const bool with_line)
    {
      static const std::regex place("^Line <([0-9]+)> of file <.*?>?: ");
      const std::string line = one_line(exception);
      std::smatch match;
      if (!std::regex_search(line, match, place))
        return line;
      return (with_line ? "line " + match[1].str() + ": " : "") + match.suffix().str();
    }

    void parse_lines(dealii::ParameterHandler &prm, const std::string &lines, const bool with_line,
                     const bool skip_undefined)
    {
      try
      {
        std::istringstream stream(lines);
        prm.parse_input(stream, "input", "", skip_undefined);
      }
      catch (const dealii::ParameterHandler::ExcNoSubsection &exception)
      {
        throw UserError(readable(exception, with_line) +
                        " (sections of bodies and contacts need their names in the lists Bodies, Contacts)");
      }
      catch (const dealii::ExceptionBase &exception)
      {
        throw UserError(readable(exception, with_line));
      }
    }
  } // namespace

  ParameterFile::ParameterFile(const std::string &name, const std::vector<std::string> &overrides)
      : name_(name), text_(read_text(name))
  {
    for (const auto &given : overrides)
      overrides_.push_back({given, lines_of_override(given)});
  }

  void ParameterFile::parse_into(dealii::ParameterHandler &prm, const bool skip_undefined) const
  {
    parse_lines(prm, text_, true, skip_undefined);
    for (const auto &override : overrides_)
      try
      {
        parse_lines(prm, override.lines, false, skip_undefined);
      }
      catch (const UserError &error)
      {
        throw UserError("override `" + override.given + "`: " + error.what());
      }
  }

  std::string ParameterFile::directory() const
  {
    return std::filesystem::path(name_).parent_path().string();
  }
} // namespace abut
