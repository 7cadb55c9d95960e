// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/results/results.h>
#include <abut/run/setup.h>

namespace abut
{
  /// What a scene did not need.
  std::vector<std::string> left_out(const Setup &setup, const Solution &solution);
} // namespace abut
