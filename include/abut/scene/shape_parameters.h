// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/body_description.h>

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace abut
{
  /// The entries of a section `Body <name>` that say what the body looks like and how it is meshed.
  void declare_shape_parameters(dealii::ParameterHandler &prm);

  /// Reads them. Throws UserError, beginning with `where`. `directory` is that of the parameter file.
  void parse_shape_parameters(const dealii::ParameterHandler &prm, BodyDescription &body,
                              const Constants &constants, const std::string &where,
                              const std::string &directory);

  /// The numbers of a list.
  std::vector<double> numbers_of(const dealii::ParameterHandler &prm, const std::string &entry);
} // namespace abut
