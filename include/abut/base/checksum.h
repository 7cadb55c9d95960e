// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace abut
{
  /// FNV-1a of 64 bits, in hexadecimal digits: tells whether bytes are those they were, not who wrote them.
  std::string checksum(const char *begin, std::size_t size);

  /// Of a file. Throws UserError, without a parameter's name, where it cannot be read.
  std::string file_checksum(const std::string &path);
} // namespace abut
