// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/base/vocabulary.h>

#include <gtest/gtest.h>

namespace
{
  using namespace abut;

  const std::vector<std::string> shapes = {"L-shape", "disc", "half disc", "rectangle", "ring"};

  TEST(Vocabulary, FindsTheNearestWord)
  {
    EXPECT_EQ(nearest_word("ractangel", shapes), "rectangle"); // three letters of nine
    EXPECT_EQ(nearest_word("Ring", shapes), "ring");
    EXPECT_EQ(nearest_word("l-shape", shapes), "L-shape");
    EXPECT_EQ(nearest_word("halfdisc", shapes), "half disc");
    EXPECT_EQ(nearest_word("dics", {"disc"}), ""); // two of four
    EXPECT_EQ(nearest_word("dsc", {"disc"}), "disc");
    EXPECT_EQ(nearest_word("cube", shapes), "");
    EXPECT_EQ(nearest_word("disc", {}), "");
    EXPECT_EQ(nearest_word("lane", {"line", "lame"}), "line"); // the first of those as near
  }

  Vocabulary three_words()
  {
    Vocabulary vocabulary;
    vocabulary.add({"spr", "patches"});
    vocabulary.add({"kelly", "jumps"});
    vocabulary.add({"none", "nothing"});
    return vocabulary;
  }

  TEST(Vocabulary, IsInAlphabeticalOrder)
  {
    EXPECT_EQ(three_words().list(), "kelly, none, spr");
    EXPECT_EQ(three_words().documentation(), "kelly: jumps. none: nothing. spr: patches.");
    EXPECT_EQ(Vocabulary().list(), "");
  }

  TEST(Vocabulary, LetsKnownWordsPass)
  {
    EXPECT_TRUE(three_words().knows("spr"));
    EXPECT_FALSE(three_words().knows("Spr"));
    EXPECT_EQ(three_words().check("spr", "Estimator"), "spr");
  }

  std::string refusal_of(const std::string &word)
  {
    try
    {
      three_words().check(word, "Adaptation/Estimator");
    }
    catch (const UserError &error)
    {
      return error.what();
    }
    return "nothing was refused";
  }

  TEST(Vocabulary, RefusesOthersWithTheNearestOne)
  {
    EXPECT_EQ(refusal_of("keley"),
              "Adaptation/Estimator: received `keley`, allowed are kelly, none, spr; did you mean kelly?");
    EXPECT_EQ(refusal_of("residual"),
              "Adaptation/Estimator: received `residual`, allowed are kelly, none, spr");
  }

  TEST(Vocabulary, OfAParameterIsOne)
  {
    Vocabulary::of("Vocabulary of this test").add({"word", "what it means"});
    EXPECT_TRUE(Vocabulary::of("Vocabulary of this test").knows("word"));
    EXPECT_TRUE(Vocabulary::of("Another").words().empty());
  }
} // namespace
