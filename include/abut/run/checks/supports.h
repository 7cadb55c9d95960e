// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/run/model.h>

namespace abut
{
  /// Throws UserError for a body whose supports leave a rigid motion free which the scheme cannot find, or
  /// which contact cannot hold or pushes away, and where supports press both bodies of a pair into each
  /// other.
  void check_supports(const Scene &scene, const Model &model);
} // namespace abut
