// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/checksum.h>
#include <abut/base/user_error.h>

#include <gtest/gtest.h>

#include <set>

using namespace abut;

namespace
{
  std::string checksum_of(const std::string &text)
  {
    return checksum(text.data(), text.size());
  }

  // Values of http://www.isthe.com/chongo/tech/comp/fnv, its test vectors of 64 bits.
  TEST(Checksum, IsThatOfFowlerNollAndVo)
  {
    EXPECT_EQ(checksum_of(""), "cbf29ce484222325");
    EXPECT_EQ(checksum_of("a"), "af63dc4c8601ec8c");
    EXPECT_EQ(checksum_of("foobar"), "85944171f73967e8");
  }

  TEST(Checksum, NoticesEveryFlippedBitAndMissingByte)
  {
    const std::string text = "records of a run";
    std::set<std::string> all = {checksum_of(text)};
    for (std::size_t i = 0; i < text.size(); ++i)
    {
      for (int bit = 0; bit < 8; ++bit)
      {
        std::string flipped = text;
        flipped[i] = static_cast<char>(flipped[i] ^ (1 << bit));
        all.insert(checksum_of(flipped));
      }
      all.insert(checksum_of(text.substr(0, i)));
    }
    EXPECT_EQ(all.size(), 1 + 9 * text.size());
  }

  TEST(Checksum, OfAFileThatIsNotThereIsRefused)
  {
    EXPECT_THROW(file_checksum("/no/such/file"), UserError);
  }
} // namespace
