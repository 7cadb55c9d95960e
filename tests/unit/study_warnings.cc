// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Warnings of variants: each said once, with the variants that have it.
#include <abut/study/study_warnings.h>

#include <gtest/gtest.h>

using namespace abut;

namespace
{
  const Warning strain_a{WarningCode::large_strain, "Body part1: a strain of 0.06"},
      strain_b{WarningCode::large_strain, "Body part1: a strain of 0.1"},
      other_body{WarningCode::large_strain, "Body part2: a strain of 0.06"},
      overlap{WarningCode::large_overlap, "Contact c: they overlap by 1"};

  std::vector<std::string> texts(const std::vector<VariantWarnings> &variants)
  {
    std::vector<std::string> all;
    for (const Warning &warning : study_warnings(variants))
      all.push_back(warning.text);
    return all;
  }

  TEST(StudyWarnings, NameTheVariants)
  {
    EXPECT_EQ(texts({{"a", {overlap}}, {"b", {strain_a, overlap}}, {"c", {overlap}}}),
              (std::vector<std::string>{overlap.text + " (in all variants)",
                                        strain_a.text + " (in the variant `b`)"}));
    EXPECT_EQ(texts({{"a", {overlap}}, {"b", {}}, {"c", {overlap}}}),
              std::vector<std::string>{overlap.text + " (in the variants `a`, `c`)"});
    EXPECT_EQ(texts({{"1", {overlap}}, {"2", {overlap}}, {"3", {overlap}}, {"4", {overlap}}, {"5", {}}}),
              std::vector<std::string>{overlap.text + " (in the variants `1`, `2`, `3` and 1 more)"});
  }

  TEST(StudyWarnings, AreOneWhereOnlyNumbersDiffer)
  {
    EXPECT_EQ(texts({{"a", {strain_a}}, {"b", {strain_b}}}),
              std::vector<std::string>{strain_a.text + " (in all variants; the numbers are those of `a`)"});
  }

  TEST(StudyWarnings, AreSeveralWhereNamesOrCodesDifferOrOneVariantHasSeveral)
  {
    EXPECT_EQ(texts({{"a", {strain_a}}, {"b", {other_body}}}).size(), 2u);
    EXPECT_EQ(texts({{"a", {strain_a}}, {"b", {{WarningCode::far_motion, strain_a.text}}}}).size(), 2u);
    EXPECT_EQ(texts({{"a", {strain_a, strain_b}}, {"b", {strain_a, strain_b}}}).size(), 2u);
    EXPECT_TRUE(texts({{"a", {}}, {"b", {}}}).empty());
  }

  TEST(StudyWarnings, CodesAreListedOnce)
  {
    EXPECT_EQ(codes_of({strain_a, other_body, overlap}), "large-strain large-overlap");
    EXPECT_EQ(codes_of({}), "");
  }
} // namespace
