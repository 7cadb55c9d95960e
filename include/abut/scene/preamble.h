// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/expression.h>
#include <abut/scene/parameter_sections.h>

#include <string>
#include <vector>

namespace abut
{
  /// What has to be known of a file before the sections of its bodies and contacts can be declared.
  struct Preamble
  {
    std::vector<std::string> bodies;
    std::vector<std::string> contacts; ///< empty where they are found
    bool finds_contacts = false;
    std::vector<std::string> materials;
    Constants constants;

    /// Of the section Constants.
    static void declare_constants(dealii::ParameterHandler &prm);
    /// Of the entries outside all sections.
    static void declare_lists(dealii::ParameterHandler &prm);
    /// From the declared sections. Throws UserError.
    static Preamble parse(const ParameterSections &sections);
  };
} // namespace abut
