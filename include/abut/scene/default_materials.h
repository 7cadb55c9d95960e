// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/body_description.h>
#include <abut/scene/parameter_lines.h>

namespace abut
{
  /// The sections of bodies and parts that leave the Young modulus at its default while another one is given:
  /// "Body steel". Where none is given, all stresses are in units of the default.
  std::vector<std::string> default_materials(const std::vector<BodyDescription> &bodies,
                                             const std::vector<ParameterLine> &lines);
} // namespace abut
