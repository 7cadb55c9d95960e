// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Bodies that pass through each other where no contact joins them, against overlaps that are known.
#include <gtest/gtest.h>

#include "program.h"
#include <sstream>

using namespace abut::testing;

namespace
{
  const std::string behind =
      "subsection Contact behind\n set Slave = wall:bottom\n set Master = floor:top\nend\n";

  /// A block that is moved by `moved` along a floor, towards a wall at `wall` on its right.
  std::string block_and_wall(const std::string &moved, const std::string &wall,
                             const std::string &further = behind)
  {
    return "set Bodies = block, floor, wall\nset Contacts = below" +
           std::string(further.empty() ? "" : ", behind") +
           "\n"
           "subsection Body block\n set Cells = 3, 3\n set Conditions = left: displacement: " +
           moved + ", 0; right: displacement: " + moved +
           ", 0\nend\n"
           "subsection Body floor\n set Size = 3, 1\n set Shift = -1, -1\n set Cells = 4, 2\n"
           " set Conditions = bottom: displacement: 0, 0\nend\n"
           "subsection Body wall\n set Size = 1, 3\n set Cells = 2, 5\n set Shift = " +
           wall +
           ", 0\n set Conditions = right: displacement: 0, 0\nend\n"
           "subsection Contact below\n set Slave = block:bottom\n set Master = floor:top\nend\n" +
           further;
  }

  /// Of the warning unpaired-overlap, empty where there is none; several are a failure.
  std::string overlap_message(const Answer &answer)
  {
    std::string message;
    for (const auto &warning : answer.summary["warnings"])
      if (warning["code"] == "unpaired-overlap")
      {
        EXPECT_EQ(message, "");
        message = warning["message"].get<std::string>();
      }
    return message;
  }

  bool contains(const std::string &text, const std::string &part)
  {
    return text.find(part) != std::string::npos;
  }

  /// A rigid roller of the radius 10 that is pressed 0.05 into a block; its tread is cut in two within the
  /// contact.
  std::string roller(const std::string &tread)
  {
    return "set Bodies = block, roller\nset Contacts = nip\n"
           "subsection Body block\n set Size = 8, 4\n set Shift = -4, -4\n set Cells = 64, 32\n"
           " set Conditions = bottom: displacement: 0, 0\nend\n"
           "subsection Body roller\n set Shape = rigid outline\n"
           " set Outline = (3, 2) -> (-3, 2) -> (-3, 0.45) -> near: y = x^2/20 to (0.2, 0.002) -> "
           "far: y = x^2/20 to (3, 0.45) -> close\n"
           " set Conditions = near: displacement: 0, -0.05\nend\n"
           "subsection Contact nip\n set Slave = block:top\n set Master = roller:" +
           tread + "\nend\n";
  }

  /// Bars of 10 by 0.1 that cross; corners of cells of neither lie within the other.
  const std::string crossing_bars =
      "set Bodies = a, b\n"
      "subsection Body a\n set Size = 10, 0.1\n set Shift = -5, -0.05\n set Cells = 3, 1\n"
      " set Conditions = left: displacement: 0, 0\nend\n"
      "subsection Body b\n set Size = 0.1, 10\n set Shift = -0.05, -5\n set Cells = 1, 3\n"
      " set Conditions = bottom: displacement: 0, 0\nend\n";
} // namespace

TEST(UnpairedBodies, ABlockThatIsMovedIntoAWall)
{
  const Answer through = run_text(block_and_wall("0.13", "1.1")),
               short_of = run_text(block_and_wall("0.07", "1.1"));
  ASSERT_EQ(through.status, 0) << through.err;
  ASSERT_EQ(short_of.status, 0) << short_of.err;
  const std::string message = overlap_message(through);
  EXPECT_TRUE(contains(message, "Bodies block and wall overlap by 0.03 once displaced")) << message;
  EXPECT_TRUE(contains(message, "between block:right and wall:left, which no contact joins")) << message;
  EXPECT_EQ(overlap_message(short_of), "");
}

TEST(UnpairedBodies, AsTheyArePlaced)
{
  const std::string scene = block_and_wall("0", "0.97");
  const Answer answer = run_text(scene), check = run({temporary_file("scene.prm", scene), "--check"});
  ASSERT_EQ(answer.status, 0) << answer.err;
  EXPECT_TRUE(contains(overlap_message(answer), "overlap by 0.03 before anything moves")) << answer.err;
  EXPECT_TRUE(contains(check.err, "unpaired-overlap")) << check.err;
  EXPECT_EQ(overlap_message(run_text(block_and_wall("0", "1"))), ""); // they touch
}

TEST(UnpairedBodies, AContactThatEndsWhereTheSideGoesOn)
{
  const Answer cut = run_text(roller("near")), whole = run_text(roller("near + far"));
  ASSERT_EQ(cut.status, 0) << cut.err;
  ASSERT_EQ(whole.status, 0) << whole.err;
  const std::string message = overlap_message(cut);
  EXPECT_TRUE(contains(message, "roller:far") && contains(message, "roller:near + far in Contact nip"))
      << message;
  const double depth = std::stod(message.substr(message.find("overlap by ") + 11));
  EXPECT_LT(depth, .05); // what the roller is pressed in by
  EXPECT_GT(depth, .005);
  EXPECT_EQ(overlap_message(whole), "");
}

TEST(UnpairedBodies, BarsThatCrossBetweenTheirNodes)
{
  const Answer answer = run_text(crossing_bars);
  ASSERT_EQ(answer.status, 0) << answer.err;
  EXPECT_TRUE(contains(overlap_message(answer), "overlap by 0.05 before anything moves")) << answer.err;
}

TEST(UnpairedBodies, OneThatNoContactNames)
{
  const std::string scene = block_and_wall("0", "1.1", "");
  EXPECT_EQ(warning_codes(run_text(scene)).count("body-without-contact"), 1u);
  EXPECT_EQ(warning_codes(run_text(block_and_wall("0", "1.1"))).count("body-without-contact"), 0u);
  const Answer check = run({temporary_file("scene.prm", scene), "--check"});
  EXPECT_TRUE(contains(check.err, "Body wall is in no contact")) << check.err;
}

TEST(UnpairedBodies, AllOfThemWithoutAContact)
{
  const auto block = [](const std::string &name, const std::string &x) {
    return "subsection Body " + name + "\n set Shift = " + x +
           ", 0\n set Conditions = bottom: displacement: 0, 0\nend\n";
  };
  const Answer two = run_text("set Bodies = a, b\n" + block("a", "0") + block("b", "2")),
               one = run_text("set Bodies = a\n" + block("a", "0"));
  EXPECT_EQ(warning_codes(two), std::multiset<std::string>{"body-without-contact"}) << two.err;
  EXPECT_TRUE(contains(two.err, "2 bodies and no contact")) << two.err;
  EXPECT_EQ(warning_codes(one), std::multiset<std::string>{}) << one.err;
}
