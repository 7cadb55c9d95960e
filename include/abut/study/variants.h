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

  /// The name of a variant without its load case and swept values; empty where it is nothing but these.
  std::string choice_of(const StudyParameters::Variant &variant);

  /// The value of a parameter that is swept; empty for another one.
  std::string swept_value(const StudyParameters::Variant &variant, const std::string &parameter);
} // namespace abut
