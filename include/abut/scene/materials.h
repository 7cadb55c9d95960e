// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/material.h>

#include <map>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace abut
{
  /// Of the sections `Material <name>`.
  using Materials = std::map<std::string, Material>;

  /// The material of a region of a mesh file, a physical surface by its name or number.
  struct RegionMaterial
  {
    std::string region;
    Material material;
  };

  /// The constants of a material, in a section of its own or a body's.
  void declare_elasticity(dealii::ParameterHandler &prm);
  /// Throws UserError, beginning with `where`.
  Material parse_elasticity(const dealii::ParameterHandler &prm, const std::string &where);

  /// `core: steel; lining: rubber`. Throws UserError, beginning with `where`.
  std::vector<RegionMaterial> parse_regions(const std::string &text, const Materials &materials,
                                            const std::string &where);
} // namespace abut
