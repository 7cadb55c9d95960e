// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/scene/allowed_values.h>

#include <regex>

namespace abut
{
  namespace
  {
    /// `0...MAX_DOUBLE`: from 0 on.
    std::string range_text(const std::string &least, const std::string &most)
    {
      const bool from_below = least == "-MAX_DOUBLE" || least == "MIN_INT",
                 without_end = most.compare(0, 4, "MAX_") == 0 || most == "2147483647";
      if (from_below && without_end)
        return "";
      if (without_end)
        return ", at least " + least;
      return from_below ? ", at most " + most : " from " + least + " to " + most;
    }

    std::string in_words(std::string alternatives)
    {
      std::string text;
      for (const char c : alternatives)
        text += c == '|' ? std::string(", ") : std::string(1, c);
      return text;
    }

    /// A list of several of the same kind.
    std::string list_of(const std::string &kind, const std::string &least, const std::string &most)
    {
      if (least == most)
        return least + " of these, separated by commas: " + kind;
      return "any number of these, separated by commas: " + kind;
    }
  } // namespace

  std::string allowed_by(const std::string &pattern)
  {
    static const std::regex number("\\[(Double|Integer)(?: range)? (.+)\\.\\.\\.(.+) \\(inclusive\\)\\]"),
        selection("\\[Selection (.*?) ?\\]"),
        list("\\[List of <(.*)> of length (\\d+)\\.\\.\\.(\\d+) \\(inclusive\\)\\]");
    std::smatch found;
    if (std::regex_match(pattern, found, number))
      return (found[1] == "Double" ? "a number" : "a whole number") + range_text(found[2], found[3]);
    if (std::regex_match(pattern, found, selection))
      return in_words(found[1]);
    if (std::regex_match(pattern, found, list))
      return list_of(allowed_by(found[1]), found[2], found[3]);
    if (pattern.compare(0, 5, "[Bool") == 0)
      return "true, false";
    if (pattern.compare(0, 9, "[FileName") == 0)
      return "a file name";
    if (pattern.compare(0, 10, "[Directory") == 0)
      return "a folder";
    if (pattern == "[Double]" || pattern == "[Integer]")
      return pattern == "[Double]" ? "a number" : "a whole number";
    return "";
  }
} // namespace abut
