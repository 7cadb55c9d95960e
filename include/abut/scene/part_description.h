// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/body_description.h>

namespace abut
{
  /// The entries for the material of a body or part: constants and regions.
  void declare_material(dealii::ParameterHandler &prm);
  /// Throws UserError, beginning with `where`; also for what a rigid body does not have.
  void parse_material(const dealii::ParameterHandler &prm, BodyDescription &body, const Materials &materials,
                      const std::string &where);

  /// The entries for what a body is glued of.
  void declare_glued_parts(dealii::ParameterHandler &prm);
  /// Throws UserError, beginning with `where`, for names without a section.
  void parse_glued_parts(const dealii::ParameterHandler &prm, BodyDescription &body, const Parts &parts,
                         const std::string &where);

  /// The section `Part <name>`: shape, place and material.
  void declare_part(dealii::ParameterHandler &prm);
  /// Reads the section the handler stands in. Throws UserError.
  BodyDescription parse_part(const dealii::ParameterHandler &prm, const std::string &name,
                             const BodyContext &context);
} // namespace abut
