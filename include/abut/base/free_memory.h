// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/processes.h>

namespace abut
{
  /// Bytes that a process may still take, the same number in all of them: what its machine has available by
  /// the processes there, the least of all machines. Infinite where a machine does not say.
  double free_memory(Processes &processes);
} // namespace abut
