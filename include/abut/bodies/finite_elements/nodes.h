// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/finite_elements/space.h>
#include <abut/bodies/prescribed.h>

namespace abut
{
  Nodes all_nodes(const Space &space);
  /// Those that are free to move: all but those that others determine.
  Nodes free_nodes(const Space &space);
} // namespace abut
