// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/scene/default_materials.h>

#include <set>

namespace abut
{
  namespace
  {
    /// The bodies, or their parts, that have a material of their own; Regions may leave nothing of a body's.
    std::vector<std::string> sections_with_material(const std::vector<BodyDescription> &bodies)
    {
      std::vector<std::string> sections;
      for (const BodyDescription &body : bodies)
      {
        for (const BodyDescription &part : body.parts)
          sections.push_back(part.section());
        if (body.parts.empty() && body.regions.empty() && !body.is_rigid)
          sections.push_back(body.section());
      }
      return sections;
    }
  } // namespace

  std::vector<std::string> default_materials(const std::vector<BodyDescription> &bodies,
                                             const std::vector<ParameterLine> &lines)
  {
    std::set<std::string> given;
    for (const ParameterLine &line : lines)
      if (line.sets && line.name == "Young modulus")
        given.insert(line.section());
    std::vector<std::string> left;
    for (const std::string &section : sections_with_material(bodies))
      if (given.count(section) == 0)
        left.push_back(section);
    return given.empty() ? std::vector<std::string>() : left;
  }
} // namespace abut
