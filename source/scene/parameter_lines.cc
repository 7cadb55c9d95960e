// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/text.h>
#include <abut/scene/parameter_lines.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

namespace abut
{
  namespace
  {
    /// Words with one blank between them.
    std::string single_blanks(const std::string &text)
    {
      std::string word, result;
      for (std::istringstream words(text); words >> word;)
        result += (result.empty() ? "" : " ") + word;
      return result;
    }

    /// A line joined with those that continue it, trimmed, without its comment.
    struct LogicalLine
    {
      std::string text;
      std::string original; ///< with its comment
      unsigned int number;  ///< of the first of them
    };

    std::vector<LogicalLine> logical_lines(const std::string &text)
    {
      std::vector<LogicalLine> lines;
      std::istringstream stream(text);
      bool continued = false;
      unsigned int number = 0;
      for (std::string line; std::getline(stream, line);)
      {
        ++number;
        line = trim(line);
        const bool goes_on = !line.empty() && line.back() == '\\';
        if (goes_on)
          line.pop_back();
        if (continued)
          lines.back().original += line;
        else
          lines.push_back({"", line, number});
        continued = goes_on;
      }
      for (LogicalLine &line : lines)
      {
        line.text = line.original.substr(0, line.original.find('#'));
        std::replace(line.text.begin(), line.text.end(), '\t', ' ');
        line.text = trim(line.text);
      }
      return lines;
    }

    /// What follows a command, written in small or in capital letters.
    std::optional<std::string> after(const std::string &line, const std::string &small,
                                     const std::string &capital)
    {
      if (line.compare(0, small.size(), small) != 0 && line.compare(0, small.size(), capital) != 0)
        return {};
      return trim(line.substr(small.size()));
    }

    class LineReader
    {
    public:
      /// `file`: how messages name an included one, else empty.
      LineReader(std::vector<ParameterLine> &lines, std::vector<std::string> &sections,
                 const std::string &file, const unsigned int depth)
          : lines_(lines), sections_(sections), file_(file), depth_(depth)
      {}

      void read(const std::string &text)
      {
        const std::vector<std::string> outside = sections_;
        for (const LogicalLine &line : logical_lines(text))
          if (!line.text.empty())
            read_line(line);
        if (sections_ != outside)
          throw UserError(file_ + "There are unequal numbers of 'subsection' and 'end' statements in the "
                                  "parameter file");
      }

    private:
      void read_line(const LogicalLine &line)
      {
        place_ = file_ + "line " + std::to_string(line.number) + ": ";
        if (const auto section = after(line.text, "subsection ", "SUBSECTION "))
        {
          sections_.push_back(single_blanks(*section));
          add({sections_, false, "", ""}, line.number);
        }
        else if (const auto rest = after(line.text, "end", "END"))
          leave(*rest);
        else if (const auto setting = after(line.text, "set ", "SET "))
          set(*setting, line.number);
        else if (const auto name = after(line.text, "include ", "INCLUDE "))
          include(*name);
        else
          throw UserError(place_ + "The line <" + single_blanks(line.original) +
                          "> could not be parsed: please check to make sure that the file is not missing a "
                          "'set', 'include', 'subsection', or 'end' statement");
      }

      void leave(const std::string &rest)
      {
        if (!rest.empty())
          throw UserError(place_ + "Invalid content after 'end' or 'END' statement");
        if (sections_.empty())
          throw UserError(place_ + "There is no subsection to leave here");
        sections_.pop_back();
      }

      void set(const std::string &setting, const unsigned int number)
      {
        const auto equals = setting.find('=');
        if (equals == std::string::npos)
          throw UserError(place_ + "Invalid format of 'set' or 'SET' statement");
        add({sections_, true, single_blanks(setting.substr(0, equals)), trim(setting.substr(equals + 1))},
            number);
      }

      void add(ParameterLine line, const unsigned int number)
      {
        line.number = depth_ == 0 ? number : 0;
        line.place = place_;
        lines_.push_back(std::move(line));
      }

      void include(const std::string &name)
      {
        constexpr unsigned int deepest = 20;
        if (!std::ifstream(name))
          throw UserError(place_ + "This line contains an 'include' or 'INCLUDE' statement, but the given " +
                          "file to include <" + name + "> cannot be opened");
        if (depth_ == deepest)
          throw UserError(place_ + "the file to include <" + name + "> includes itself");
        LineReader(lines_, sections_, "file " + name + ", ", depth_ + 1).read(read_parameter_text(name));
      }

      std::vector<ParameterLine> &lines_;
      std::vector<std::string> &sections_;
      std::string file_, place_;
      unsigned int depth_;
    };
  } // namespace

  std::string ParameterLine::section() const
  {
    std::string result;
    for (const std::string &section : sections)
      result += (result.empty() ? "" : "/") + section;
    return result;
  }

  std::vector<ParameterLine> read_parameter_lines(const std::string &text)
  {
    std::vector<ParameterLine> lines;
    std::vector<std::string> sections;
    LineReader(lines, sections, "", 0).read(text);
    return lines;
  }

  std::string read_parameter_text(const std::string &name)
  {
    std::ifstream file(name, std::ios::binary);
    if (!file || std::filesystem::is_directory(name))
      throw UserError("Parameter file `" + name + "`: cannot be read");
    std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    text.erase(std::remove(text.begin(), text.end(), '\r'), text.end());
    return text;
  }
} // namespace abut
