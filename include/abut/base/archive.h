// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/exceptions.h>

#include <Eigen/Core>

#include <array>
#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace abut
{
  using Bytes = std::vector<char>;

  /// Whether a type consists of numbers alone, so that many of them can be copied at once. Records that do
  /// say so where they are declared.
  template <typename T>
  inline constexpr bool consists_of_numbers = std::is_arithmetic_v<T> || std::is_enum_v<T>;
  template <typename T, std::size_t n>
  inline constexpr bool consists_of_numbers<std::array<T, n>> = consists_of_numbers<T>;
  template <int rows, int columns>
  inline constexpr bool consists_of_numbers<Eigen::Matrix<double, rows, columns>> =
      rows != Eigen::Dynamic &&columns != Eigen::Dynamic;

  /**
   * Turns values into bytes, or takes them from there in the same order: for processes of one program on
   * machines of one kind. A record lists what it consists of, once for both directions:
   *
   *     void serialize(Archive &archive) { archive(first, second); }
   */
  class Archive
  {
  public:
    enum class Direction
    {
      pack,  ///< values are appended to the bytes
      unpack ///< values are taken from the bytes
    };

    /// The bytes must outlive the archive.
    Archive(Bytes &bytes, const Direction direction)
        : packed_(direction == Direction::pack ? &bytes : nullptr), next_(bytes.data()),
          end_(bytes.data() + bytes.size())
    {}
    /// Unpacks bytes that are elsewhere.
    Archive(const char *const begin, const std::size_t size) : next_(begin), end_(begin + size) {}

    template <typename... T> void operator()(T &...values) { (pass(values), ...); }

    bool unpacks() const { return packed_ == nullptr; }

  private:
    /// Copies `size` bytes, one way or the other.
    void pass_bytes(void *const begin, const std::size_t size)
    {
      if (!unpacks())
      {
        const char *const first = static_cast<const char *>(begin);
        packed_->insert(packed_->end(), first, first + size);
        return;
      }
      AssertThrow(size <= static_cast<std::size_t>(end_ - next_),
                  dealii::ExcMessage("more is asked for than was packed"));
      if (size > 0)
        std::memcpy(begin, next_, size);
      next_ += size;
    }

    template <typename T> void pass(T &value)
    {
      if constexpr (consists_of_numbers<T>)
        pass_bytes(&value, sizeof(T));
      else
        value.serialize(*this);
    }
    template <typename Number, int rows, int columns> void pass(Eigen::Matrix<Number, rows, columns> &matrix)
    {
      Eigen::Index n_rows = matrix.rows(), n_columns = matrix.cols();
      (*this)(n_rows, n_columns);
      matrix.resize(n_rows, n_columns); // keeps what is being packed
      pass_bytes(matrix.data(), static_cast<std::size_t>(matrix.size()) * sizeof(Number));
    }
    template <typename T> void pass(std::vector<T> &values) { pass_each(values); }
    void pass(std::string &text) { pass_each(text); }
    void pass(std::vector<bool> &values)
    {
      std::vector<char> bytes(values.begin(), values.end());
      pass(bytes);
      if (unpacks())
        values.assign(bytes.begin(), bytes.end());
    }
    template <typename Container> void pass_each(Container &values)
    {
      using Value = typename Container::value_type;
      std::size_t size = values.size();
      pass(size);
      values.resize(size);
      if constexpr (consists_of_numbers<Value>)
        pass_bytes(values.data(), size * sizeof(Value));
      else
        for (Value &value : values)
          pass(value);
    }
    template <typename T> void pass(std::optional<T> &value)
    {
      bool is_there = value.has_value();
      pass(is_there);
      if (!is_there)
        value.reset();
      else if (!value)
        value.emplace();
      if (value)
        pass(*value);
    }
    template <typename T, std::size_t n> void pass(std::array<T, n> &values)
    {
      for (T &value : values)
        pass(value);
    }
    template <typename A, typename B> void pass(std::pair<A, B> &values)
    {
      (*this)(values.first, values.second);
    }
    template <typename T> void pass(std::map<std::string, T> &values)
    {
      std::vector<std::pair<std::string, T>> entries(values.begin(), values.end());
      pass(entries);
      if (unpacks())
        values = {entries.begin(), entries.end()};
    }

    Bytes *packed_ = nullptr; ///< null: values are taken
    const char *next_;        ///< what is taken next
    const char *end_;
  };

  /// The bytes of values, which are not changed: only unpacking changes what a record lists.
  template <typename... T> Bytes packed(const T &...values)
  {
    Bytes bytes;
    Archive(bytes, Archive::Direction::pack)(const_cast<T &>(values)...);
    return bytes;
  }

  /// Takes a value from the bytes that `packed` has made of one.
  template <typename T> void unpack(Bytes &bytes, T &value)
  {
    Archive(bytes, Archive::Direction::unpack)(value);
  }
} // namespace abut
