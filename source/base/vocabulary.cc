// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/base/vocabulary.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <numeric>

namespace abut
{
  namespace
  {
    std::string in_small_letters(std::string text)
    {
      std::transform(text.begin(), text.end(), text.begin(),
                     [](const unsigned char c) { return static_cast<char>(std::tolower(c)); });
      return text;
    }

    /// The edit distance of Levenshtein.
    std::size_t distance(const std::string &a, const std::string &b)
    {
      std::vector<std::size_t> row(b.size() + 1);
      std::iota(row.begin(), row.end(), std::size_t(0));
      for (std::size_t i = 0; i < a.size(); ++i)
      {
        std::size_t diagonal = row[0]++;
        for (std::size_t j = 0; j < b.size(); ++j)
        {
          const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
          diagonal = row[j + 1];
          row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
        }
      }
      return row.back();
    }
  } // namespace

  Vocabulary &Vocabulary::of(const std::string &parameter)
  {
    static std::map<std::string, Vocabulary> vocabularies;
    return vocabularies[parameter];
  }

  void Vocabulary::add(const Word &word)
  {
    Assert(!word.name.empty() && !word.documentation.empty(), dealii::ExcMessage("a word needs a meaning"));
    Assert(!knows(word.name), dealii::ExcMessage("a word is registered twice"));
    const auto place = std::lower_bound(words_.begin(), words_.end(), word,
                                        [](const Word &a, const Word &b) { return a.name < b.name; });
    words_.insert(place, word);
  }

  bool Vocabulary::knows(const std::string &name) const
  {
    return std::any_of(words_.begin(), words_.end(), [&](const Word &word) { return word.name == name; });
  }

  std::string Vocabulary::list() const
  {
    std::string text;
    for (const Word &word : words_)
      text += (text.empty() ? "" : ", ") + word.name;
    return text;
  }

  std::string Vocabulary::documentation() const
  {
    std::string text;
    for (const Word &word : words_)
      text += (text.empty() ? "" : " ") + word.name + ": " + word.documentation + ".";
    return text;
  }

  std::string Vocabulary::check(const std::string &name, const std::string &where) const
  {
    if (knows(name))
      return name;
    std::vector<std::string> known;
    for (const Word &word : words_)
      known.push_back(word.name);
    const std::string nearest = nearest_word(name, known);
    throw UserError(where + ": received `" + name + "`, allowed are " + list() +
                    (nearest.empty() ? "" : "; did you mean " + nearest + "?"));
  }

  std::string nearest_word(const std::string &word, const std::vector<std::string> &known)
  {
    std::string nearest;
    std::size_t least = 0;
    for (const std::string &candidate : known)
    {
      const std::size_t changes = distance(in_small_letters(word), in_small_letters(candidate));
      if (changes <= std::max<std::size_t>(1, candidate.size() / 3) && (nearest.empty() || changes < least))
      {
        nearest = candidate;
        least = changes;
      }
    }
    return nearest;
  }
} // namespace abut
