// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/scene.h>

namespace abut
{
  /// Refuses (UserError) what the scheme of a scene cannot do.
  void check_scheme(const Scene &scene);
} // namespace abut
