// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/expression.h>
#include <abut/scene/parameter_file.h>

#include <string>
#include <vector>

namespace abut
{
  /// What has to be known of a file before the sections of its bodies and contacts can be declared.
  struct Preamble
  {
    std::vector<std::string> bodies;
    std::vector<std::string> contacts;
    Constants constants;

    static void declare(dealii::ParameterHandler &prm);
    /// Passes over everything else in the file. Throws UserError.
    static Preamble read(const ParameterFile &input);
  };
} // namespace abut
