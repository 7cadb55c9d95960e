// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace abut
{
  /// A word that a parameter may take, and one line on what it means.
  struct Word
  {
    std::string name;
    std::string documentation;
  };

  /**
   * The words that a parameter of the scene may take, in alphabetical order. Whoever implements one adds it
   * (see Registry), so that the scene can declare, document and check a parameter without knowing what stands
   * behind its words.
   */
  class Vocabulary
  {
  public:
    /// That of a parameter, by its name in the file, e.g. `Shape`.
    static Vocabulary &of(const std::string &parameter);

    /// Each name once.
    void add(const Word &word);
    const std::vector<Word> &words() const { return words_; }
    bool knows(const std::string &name) const;
    /// `a, b, c`.
    std::string list() const;
    /// `a: what it means. b: ...`.
    std::string documentation() const;
    /// The name again. Throws UserError, beginning with `where`, which lists the words and says which of them
    /// is nearest to an unknown one.
    std::string check(const std::string &name, const std::string &where) const;

  private:
    std::vector<Word> words_;
  };

  /// The word with the fewest letters to change, insert or leave out; empty where that is more than a third
  /// of its letters (and more than one). Capitals count as small letters.
  std::string nearest_word(const std::string &word, const std::vector<std::string> &known);
} // namespace abut
