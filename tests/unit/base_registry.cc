// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/registry.h>
#include <abut/base/user_error.h>

#include <gtest/gtest.h>

namespace
{
  using namespace abut;

  struct ToyEntry
  {
    static constexpr const char *parameter = "Toy";
    std::string name, documentation;
    int (*make)() = nullptr;
  };

  const Registered<ToyEntry> top({"top", "it spins", [] { return 2; }});
  const Registered<ToyEntry> ball({"ball", "it rolls", [] { return 1; }});
  const Registered<ToyEntry> box({"box", "empty"});

  TEST(Registry, FindsDocumentsAndMakesWhatIsRegistered)
  {
    EXPECT_EQ(Registry<ToyEntry>::get().find("ball").make(), 1);
    EXPECT_EQ(Registry<ToyEntry>::get().find("top").make(), 2);
    EXPECT_EQ(Vocabulary::of("Toy").documentation(), "ball: it rolls. box: empty. top: it spins.");
  }

  TEST(Registry, IsInAlphabeticalOrder)
  {
    EXPECT_EQ(Registry<ToyEntry>::get().names_with([](const ToyEntry &) { return true; }), "ball, box, top");
    EXPECT_EQ(
        Registry<ToyEntry>::get().names_with([](const ToyEntry &toy) { return toy.make != nullptr; }, " or "),
        "ball or top");
  }

  TEST(Registry, RefusesWhatNobodyHasRegistered)
  {
    EXPECT_THROW(Registry<ToyEntry>::get().find("doll"), UserError);
  }
} // namespace
