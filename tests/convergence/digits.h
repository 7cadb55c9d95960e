// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <sstream>
#include <string>

/// A number as a parameter file needs it to be the same again.
inline std::string digits_of(const double value)
{
  std::ostringstream text;
  text.precision(17);
  text << value;
  return text.str();
}
