// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace abut
{
  struct Scene;

  /// Writes a file into a scene's folder of results, whole or not at all; returns its path. Throws UserError.
  std::string write_result(const Scene &scene, const std::string &name, const std::string &content);
} // namespace abut
