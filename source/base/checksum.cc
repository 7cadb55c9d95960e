// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/checksum.h>
#include <abut/base/user_error.h>

#include <cstdint>
#include <fstream>
#include <iterator>
#include <sstream>

namespace abut
{
  std::string checksum(const char *const begin, const std::size_t size)
  {
    std::uint64_t value = 14695981039346656037ULL;
    for (std::size_t i = 0; i < size; ++i)
      value = (value ^ static_cast<unsigned char>(begin[i])) * 1099511628211ULL;
    std::ostringstream text;
    text << std::hex << value;
    return text.str();
  }

  std::string file_checksum(const std::string &path)
  {
    std::ifstream file(path, std::ios::binary);
    const std::string content((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    if (!file)
      throw UserError("the file " + path + " cannot be read");
    return checksum(content.data(), content.size());
  }
} // namespace abut
