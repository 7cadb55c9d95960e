// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/processes.h>

/// The only one: MPI begins and ends once.
inline std::shared_ptr<abut::Processes> this_process()
{
  static const auto process = std::make_shared<abut::Processes>(abut::Launch{});
  return process;
}
