// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/scene/repeated_parameters.h>

#include <gtest/gtest.h>

namespace
{
  using namespace abut;

  TEST(RepeatedParameters, AreFoundInTheirSections)
  {
    const auto found = repeated_parameters(read_parameter_lines("set Bodies = a, b\n"
                                                                "subsection Body a\n"
                                                                "  set Size = 1, 1 # set Size = 2, 2\n"
                                                                "  set Cells = 2, \\\n"
                                                                "              2\n"
                                                                "end\n"
                                                                "subsection Body b\n"
                                                                "  set Size = 1, 1\n"
                                                                "end\n"
                                                                "# set Bodies = c\n"
                                                                "subsection  Body  a\n"
                                                                "  set Young   modulus = 1\n"
                                                                "  set Cells = 3, 3\n"
                                                                "  set Young modulus=2\n"
                                                                "  set Young modulus = 3\n"
                                                                "end\n"));
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].name, "Body a/Cells");
    EXPECT_EQ(found[0].first_line, 4u);
    EXPECT_EQ(found[0].last_line, 13u);
    EXPECT_EQ(found[1].name, "Body a/Young modulus");
    EXPECT_EQ(found[1].first_line, 12u);
    EXPECT_EQ(found[1].last_line, 15u);
  }

  TEST(RepeatedParameters, AFileWithoutAny)
  {
    EXPECT_TRUE(repeated_parameters({}).empty());
    EXPECT_TRUE(
        repeated_parameters(read_parameter_lines("set A = 1\nsubsection s\nset A = 1\nend\n")).empty());
  }
} // namespace
