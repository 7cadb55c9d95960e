// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/user_error.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace dealii
{
  class ExceptionBase;
}

namespace abut
{
  /// Without white space at both ends.
  std::string trim(const std::string &text);

  /// Pieces between the separators that stand outside parentheses, trimmed. An empty text has one empty
  /// piece.
  std::vector<std::string> split_outside_parentheses(const std::string &text, char separator);

  /// The name of sides taken together, `a+b`, with one blank on both sides of every plus.
  std::string name_of_sides(const std::string &text);

  /// What deal.II has to say, in one line and without its final full stop.
  std::string one_line(const dealii::ExceptionBase &exception);

  /// The words a parameter may take, and what they stand for.
  template <typename T> using Choices = std::vector<std::pair<std::string, T>>;

  /// The words, with a separator between them (`|`: the form of deal.II's Patterns::Selection).
  template <typename T> std::string words_of(const Choices<T> &choices, const std::string &separator = "|")
  {
    std::string words;
    for (const auto &choice : choices)
      words += (words.empty() ? "" : separator) + choice.first;
    return words;
  }

  /// The word for a meaning, which must be among the choices.
  template <typename T> std::string word_of(const Choices<T> &choices, const T meaning)
  {
    return std::find_if(choices.begin(), choices.end(),
                        [&](const auto &choice) { return choice.second == meaning; })
        ->first;
  }

  /// The meaning of a word. Throws UserError, beginning with `where`, when it is not one of them.
  template <typename T> T choose(const Choices<T> &choices, const std::string &word, const std::string &where)
  {
    for (const auto &choice : choices)
      if (choice.first == word)
        return choice.second;
    throw UserError(where + ": received `" + word + "`, allowed are " + words_of(choices, ", "));
  }
} // namespace abut
