// SPDX-License-Identifier: LGPL-2.1-or-later
// What is registered, and that the program prints it.
#include <abut/scene/estimator_entry.h>
#include <abut/scene/marking_entry.h>
#include <abut/scene/reference_entry.h>
#include <abut/scene/scene.h>
#include <abut/scene/scheme_entry.h>
#include <abut/scene/shape_entry.h>

#include "scene_testing.h"
#include <sstream>

using namespace abut;

namespace
{
  template <typename Entry> class Registries : public ::testing::Test
  {};

  using Entries = ::testing::Types<ShapeEntry, EstimatorEntry, MarkingEntry, ReferenceEntry, SchemeEntry>;
  TYPED_TEST_SUITE(Registries, Entries);

  /// Words with one blank between them, without the signs of comments.
  std::string as_one_line(const std::string &text)
  {
    std::string line, word;
    for (std::istringstream words(text); words >> word;)
      if (word != "#")
        line += word + " ";
    return line;
  }

  TYPED_TEST(Registries, HaveEntriesWithALineOfDocumentationEach)
  {
    EXPECT_GE(Registry<TypeParam>::get().entries().size(), 3u);
    for (const TypeParam &entry : Registry<TypeParam>::get().entries())
    {
      EXPECT_FALSE(entry.documentation.empty()) << entry.name;
      EXPECT_EQ(entry.documentation.find('\n'), std::string::npos) << entry.name;
      EXPECT_NE(entry.documentation.back(), '.') << entry.name;
      EXPECT_EQ(&Registry<TypeParam>::get().find(entry.name), &entry); // no name twice
    }
  }

  TYPED_TEST(Registries, HoldTheWordsThatAreRead)
  {
    std::string names;
    for (const Word &word : Vocabulary::of(TypeParam::parameter).words())
      names += (names.empty() ? "" : ", ") + word.name;
    EXPECT_EQ(names, Registry<TypeParam>::get().names_with([](const TypeParam &) { return true; }));
  }

  TYPED_TEST(Registries, ArePrintedWithTheParameters)
  {
    std::ostringstream text;
    Scene::print_parameters(text);
    std::string documentation;
    for (const TypeParam &entry : Registry<TypeParam>::get().entries())
      documentation += entry.name + ": " + entry.documentation + ". ";
    expect_phrase(as_one_line(text.str()), as_one_line(documentation));
  }
} // namespace
