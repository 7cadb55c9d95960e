// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/study/swept_numbers.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace abut
{
  namespace
  {
    /// A text, a mark in the place of each number, and these.
    struct Dissected
    {
      std::string rest;
      std::vector<double> numbers;
    };

    bool is_digit(const std::string &text, const std::size_t i)
    {
      return i < text.size() && std::isdigit(static_cast<unsigned char>(text[i])) != 0;
    }

    /// Digits within a name begin none.
    bool begins_number(const std::string &text, const std::size_t i)
    {
      if (i > 0 && (std::isalnum(static_cast<unsigned char>(text[i - 1])) != 0 || text[i - 1] == '_'))
        return false;
      const std::size_t unsigned_part = i + (text[i] == '-' || text[i] == '+' ? 1 : 0);
      return is_digit(text, unsigned_part) ||
             (text[unsigned_part] == '.' && is_digit(text, unsigned_part + 1));
    }

    Dissected dissected(const std::string &text)
    {
      Dissected result;
      for (std::size_t i = 0; i < text.size();)
        if (begins_number(text, i))
        {
          char *end = nullptr;
          result.numbers.push_back(std::strtod(text.c_str() + i, &end));
          result.rest += '#';
          i = static_cast<std::size_t>(end - text.c_str());
        }
        else
          result.rest += text[i++];
      return result;
    }
  } // namespace

  std::optional<std::vector<double>> number_that_differs(const std::vector<std::string> &texts)
  {
    std::vector<Dissected> all;
    std::transform(texts.begin(), texts.end(), std::back_inserter(all), dissected);
    for (const Dissected &one : all)
      if (one.rest != all.front().rest)
        return {};
    std::optional<std::vector<double>> found;
    for (std::size_t place = 0; !all.empty() && place < all.front().numbers.size(); ++place)
    {
      std::vector<double> numbers;
      for (const Dissected &one : all)
        numbers.push_back(one.numbers[place]);
      if (std::count(numbers.begin(), numbers.end(), numbers.front()) ==
          static_cast<std::ptrdiff_t>(numbers.size()))
        continue;
      if (found)
        return {};
      found = numbers;
    }
    return found;
  }

  std::string without_numbers(const std::string &text)
  {
    return dissected(text).rest;
  }
} // namespace abut
