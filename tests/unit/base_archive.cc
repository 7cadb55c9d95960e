// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/archive.h>

#include <gtest/gtest.h>

#include <limits>

using namespace abut;

namespace
{
  struct Record
  {
    double number = 0.;
    unsigned int count = 0;
    std::vector<std::string> names;
    Eigen::MatrixXd matrix;
    Eigen::Vector2d place = Eigen::Vector2d::Zero();
    std::map<std::string, Eigen::Vector2d> by_name;
    std::vector<std::pair<double, bool>> pairs;
    std::vector<bool> marks;
    std::optional<double> known, unknown;

    void serialize(Archive &archive)
    {
      archive(number, count, names, matrix, place, by_name, pairs, marks, known, unknown);
    }
  };

  Record example()
  {
    Record record{-.1,
                  7,
                  {"", "a b"},
                  Eigen::MatrixXd(2, 3),
                  {1., 2.},
                  {{"left", {3., 4.}}, {"top", {5., 6.}}},
                  {{.5, true}, {.25, false}},
                  {true, false, false, true},
                  3.,
                  {}};
    record.matrix << 1., 2., 3., 4., 5., std::numeric_limits<double>::infinity();
    return record;
  }

  TEST(Archive, GivesBackWhatItWasGiven)
  {
    const Record expected = example();
    Bytes bytes = packed(expected);
    Record record;
    record.names = {"of before"};
    record.by_name["before"] = {0., 0.};
    record.marks = {false};
    record.unknown = 1.;
    unpack(bytes, record);
    EXPECT_EQ(record.number, expected.number);
    EXPECT_EQ(record.count, expected.count);
    EXPECT_EQ(record.names, expected.names);
    EXPECT_EQ(record.matrix, expected.matrix);
    EXPECT_EQ(record.place, expected.place);
    EXPECT_EQ(record.by_name, expected.by_name);
    EXPECT_EQ(record.pairs, expected.pairs);
    EXPECT_EQ(record.marks, expected.marks);
    EXPECT_EQ(record.known, expected.known);
    EXPECT_EQ(record.unknown, std::nullopt);
    EXPECT_EQ(packed(record), bytes);
  }

  TEST(Archive, TakesOneValueAfterTheOther)
  {
    Bytes bytes;
    Archive pack(bytes, Archive::Direction::pack);
    double first = 1.;
    Eigen::VectorXd none;
    std::string last = "last";
    pack(first, none);
    pack(last);
    Archive unpack(bytes, Archive::Direction::unpack);
    double number = 0.;
    Eigen::VectorXd vector(3);
    std::string text;
    unpack(number);
    unpack(vector, text);
    EXPECT_EQ(number, 1.);
    EXPECT_EQ(vector.size(), 0);
    EXPECT_EQ(text, "last");
  }

  TEST(Archive, RefusesToTakeMoreThanThereIs)
  {
    double number = 1.;
    Bytes bytes = packed(number);
    Archive archive(bytes, Archive::Direction::unpack);
    EXPECT_ANY_THROW(archive(number, number));
  }

  TEST(Archive, CopiesRecordsOfNumbersAtOnce)
  {
    enum class Kind : char
    {
      first,
      second
    };
    std::vector<Eigen::Vector2d> places = {{1., 2.}, {3., 4.}, {5., 6.}};
    std::vector<std::array<unsigned int, 2>> numbers = {{{7, 8}}, {{9, 10}}};
    std::vector<Kind> kinds = {Kind::second, Kind::first};
    Bytes bytes;
    Archive(bytes, Archive::Direction::pack)(places, numbers, kinds);
    EXPECT_EQ(bytes.size(), 3 * sizeof(std::size_t) + 6 * sizeof(double) + 4 * sizeof(int) + 2);
    std::vector<Eigen::Vector2d> found_places;
    std::vector<std::array<unsigned int, 2>> found_numbers;
    std::vector<Kind> found_kinds;
    Archive(bytes.data(), bytes.size())(found_places, found_numbers, found_kinds);
    EXPECT_EQ(found_places, places);
    EXPECT_EQ(found_numbers, numbers);
    EXPECT_EQ(found_kinds, kinds);
    EXPECT_ANY_THROW(Archive(bytes.data(), bytes.size() - 1)(found_places, found_numbers, found_kinds));
  }
} // namespace
