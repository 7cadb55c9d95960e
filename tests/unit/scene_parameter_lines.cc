// SPDX-License-Identifier: LGPL-2.1-or-later
// What a parameter file says, line by line.
#include <abut/scene/parameter_lines.h>

#include "scene_file.h"
#include "scene_testing.h"

using namespace abut;

namespace
{
  /// `Section/Name = value` of the only line that sets something.
  std::string setting(const std::string &text)
  {
    std::string found;
    for (const ParameterLine &line : read_parameter_lines(text))
      if (line.sets)
        found += line.place + line.section() + "/" + line.name + " = " + line.value;
    return found;
  }
} // namespace

TEST(ParameterLines, AreReadAsDealIIDoes)
{
  EXPECT_EQ(setting("set Bodies = a, b"), "line 1: /Bodies = a, b");
  EXPECT_EQ(setting("\n# no\n\tSET\tBodies=a # set b = c"), "line 3: /Bodies = a");
  EXPECT_EQ(setting("subsection Body a\nset Size = 1,\t1\nend"), "line 2: Body a/Size = 1, 1");
  EXPECT_EQ(setting("SUBSECTION  Body   a \n set Young  modulus =\nEND #"),
            "line 2: Body a/Young modulus = ");
  EXPECT_EQ(setting("subsection a\nsubsection b\nset c = = 1\nend\nend"), "line 3: a/b/c = = 1");
}

TEST(ParameterLines, GoOnAfterABackslash)
{
  EXPECT_EQ(setting("set Size = 1, \\  \n   2"), "line 1: /Size = 1, 2");
  EXPECT_EQ(setting("set Size = 1\\\n\\\n2"), "line 1: /Size = 12");
  EXPECT_EQ(setting("set Size = 1 # and \\\n 2"), "line 1: /Size = 1");
  EXPECT_EQ(setting("set Size = 1 \\"), "line 1: /Size = 1");
}

TEST(ParameterLines, TellOfEmptySections)
{
  const auto lines = read_parameter_lines("subsection Body a\nend\n");
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_FALSE(lines[0].sets);
  EXPECT_EQ(lines[0].section(), "Body a");
}

TEST(ParameterLines, RefuseWhatIsNoLine)
{
  const auto refused = [](const std::string &text, const std::string &message) {
    EXPECT_EQ(message_of([&] { read_parameter_lines(text); }), message);
  };
  refused("subsection a\n",
          "There are unequal numbers of 'subsection' and 'end' statements in the parameter file");
  refused("end", "line 1: There is no subsection to leave here");
  refused("\nsubsection a\nend a", "line 3: Invalid content after 'end' or 'END' statement");
  refused("set a", "line 1: Invalid format of 'set' or 'SET' statement");
  for (const std::string line : {"hello  # you", "Set a = 1", "set", "subsection", "include", "settle a = 1"})
    expect_phrase(message_of([&] { read_parameter_lines("\n" + line); }), "line 2: The line <");
  refused("include no/where.prm",
          "line 1: This line contains an 'include' or 'INCLUDE' statement, but the given file to include "
          "<no/where.prm> cannot be opened");
}

TEST(ParameterLines, IncludeOtherFiles)
{
  const SceneFile other("set Size = 1, 1\n");
  EXPECT_EQ(setting("subsection Body a\ninclude " + other.name() + "\nend"),
            "file " + other.name() + ", line 1: Body a/Size = 1, 1");
  const SceneFile open("subsection Body a\n");
  expect_phrase(message_of([&] { read_parameter_lines("include " + open.name() + "\nend"); }),
                "file " + open.name() + ", There are unequal numbers");
  const SceneFile itself("");
  std::ofstream(itself.name()) << "include " << itself.name() << "\n";
  expect_phrase(message_of([&] { read_parameter_lines("include " + itself.name()); }), "includes itself");
}

TEST(ParameterLines, UnknownNamesAreRefusedWithTheNearest)
{
  const auto refused = [](const std::string &more, const std::string &phrase) {
    expect_phrase(message_of([&] { SceneFile(two_squares + more).read(); }), phrase);
  };
  refused("subsection Body uper\nend\n",
          "line 18: There is no such subsection to be entered: Body uper (sections "
          "of bodies and contacts need their names in the lists Bodies, Contacts; with Contacts = automatic "
          "there are no sections of contacts); did you mean Body upper?");
  refused("subsection Body upper\nset Yuong modulus = 1\nend\n",
          "line 19: No entry with name <Yuong modulus> was declared in the current subsection; did you mean "
          "Young modulus?");
  refused("set Bodys = a\n", "did you mean Bodies?");
  refused("subsection Body upper\nsubsection Body lower\nend\nend\n",
          "line 19: There is no such subsection to be entered: Body upper/Body lower");
}

TEST(ParameterLines, WhatIsIncludedCountsAsInTheFile)
{
  const SceneFile other("subsection Body upper\nset Cells = 5, 6\nend\n");
  const Scene scene = SceneFile(two_squares + "include " + other.name() + "\n").read();
  EXPECT_EQ(scene.bodies[0].cells, (std::array<unsigned int, 2>{{5, 6}}));
}
