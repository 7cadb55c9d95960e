// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/text.h>
#include <abut/base/user_error.h>
#include <abut/scene/materials.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>

namespace abut
{
  void declare_elasticity(dealii::ParameterHandler &prm)
  {
    namespace Patterns = dealii::Patterns;
    prm.declare_entry("Young modulus", "1", Patterns::Double(0.), "E, above 0. Stress.");
    prm.declare_entry("Poisson ratio", "0.3", Patterns::Double(-1., 0.5),
                      "nu, between -1 and 0.5, both excluded. No unit.");
  }

  Material parse_elasticity(const dealii::ParameterHandler &prm, const std::string &where)
  {
    const Material material{prm.get_double("Young modulus"), prm.get_double("Poisson ratio")};
    if (!(material.young_modulus > 0.))
      throw UserError(where + "Young modulus: received `" + prm.get("Young modulus") +
                      "`, allowed are numbers above 0");
    if (!(material.poisson_ratio > -1. && material.poisson_ratio < .5))
      throw UserError(where + "Poisson ratio: received `" + prm.get("Poisson ratio") +
                      "`, allowed are numbers between -1 and 0.5, both excluded");
    return material;
  }

  namespace
  {
    std::string names_of(const Materials &materials)
    {
      std::string names;
      for (const auto &[name, material] : materials)
        names += (names.empty() ? "" : ", ") + name;
      return names;
    }
  } // namespace

  std::vector<RegionMaterial> parse_regions(const std::string &text, const Materials &materials,
                                            const std::string &where)
  {
    std::vector<RegionMaterial> regions;
    for (const std::string &piece : split_outside_parentheses(text, ';'))
    {
      if (piece.empty())
        continue;
      const auto colon = piece.find(':');
      const std::string region = trim(piece.substr(0, colon));
      if (colon == std::string::npos || region.empty())
        throw UserError(where + ": received `" + piece + "`, a region is written region: material");
      const auto material = materials.find(trim(piece.substr(colon + 1)));
      if (material == materials.end())
        throw UserError(where + ": received `" + piece +
                        "`, allowed are the materials of the list Materials, which " +
                        (materials.empty() ? "is empty" : "has " + names_of(materials)));
      if (std::any_of(regions.begin(), regions.end(), [&](const auto &r) { return r.region == region; }))
        throw UserError(where + ": the region `" + region + "` is given twice, once is allowed");
      regions.push_back({region, material->second});
    }
    return regions;
  }
} // namespace abut
