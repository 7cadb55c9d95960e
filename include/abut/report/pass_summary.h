// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/report/json.h>
#include <abut/results/results.h>

namespace abut
{
  /// An entry of `pass_table` in summary.json.
  Json pass_summary(const PassRecord &pass);
} // namespace abut
