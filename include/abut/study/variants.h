// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/scene.h>

#include <string>
#include <vector>

namespace abut
{
  /// The scene of a file with a variant's overrides behind those of the command line. Throws UserError.
  Scene read_variant(const std::string &file, const std::vector<std::string> &overrides,
                     const StudyParameters::Variant &variant);
} // namespace abut
