// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace abut
{
  /// The values that a pattern of deal.II lets pass, in words; empty for `[Anything]`.
  std::string allowed_by(const std::string &pattern);
} // namespace abut
