// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/text.h>
#include <abut/scene/part_description.h>
#include <abut/scene/shape_entry.h>
#include <abut/scene/shape_parameters.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <limits>
#include <regex>
#include <utility>

namespace abut
{
  namespace Patterns = dealii::Patterns;

  namespace
  {
    /// Refuses what only bodies that deform, or have a mesh, have.
    Material rigid_material(const dealii::ParameterHandler &prm, const std::string &where)
    {
      for (const auto &[entry, unused] : {std::pair("Young modulus", "1"),
                                          {"Poisson ratio", "0.3"},
                                          {"Degree", "0"},
                                          {"Adapt", "false"},
                                          {"Cells", "8, 8"},
                                          {"Cell type", "quadrilaterals"},
                                          {"Body force", ""}})
        if (prm.get(entry) != unused)
          throw UserError(
              where + entry + ": received `" + prm.get(entry) +
              "`, but a rigid body neither deforms nor has a mesh or a mass; leave the entry out");
      return {std::numeric_limits<double>::infinity(), 0.};
    }
  } // namespace

  void declare_material(dealii::ParameterHandler &prm)
  {
    declare_elasticity(prm);
    prm.declare_entry(
        "Regions", "", Patterns::Anything(),
        "Mesh files: regions of another material than the body's, core: steel; lining: rubber. A "
        "region is a physical surface of the file (name or number), a material a section "
        "`Material <name>` of the list Materials.");
  }

  void parse_material(const dealii::ParameterHandler &prm, BodyDescription &body, const Materials &materials,
                      const std::string &where)
  {
    const Material material = body.is_rigid ? rigid_material(prm, where) : parse_elasticity(prm, where);
    body.young_modulus = material.young_modulus;
    body.poisson_ratio = material.poisson_ratio;
    body.regions = parse_regions(prm.get("Regions"), materials, where + "Regions");
    if (!body.regions.empty() && body.mesh_file.empty())
      throw UserError(where + "Regions: received `" + prm.get("Regions") +
                      "`, only bodies from a mesh file have regions");
  }

  void declare_glued_parts(dealii::ParameterHandler &prm)
  {
    prm.declare_entry("Parts", "", Patterns::List(Patterns::Anything()),
                      "Shape glued parts: their names; each has a section `Part <name>` with shape, place in "
                      "the body's own frame and material. The side top of a part base is base.top.");
    prm.declare_entry(
        "Glue", "", Patterns::Anything(),
        "Which sides of the body are glued where they coincide, by mortar: automatic (all of different "
        "pieces of the mesh), none, or pairs, `slave - master; ...`. A slave has to be covered by its "
        "master. "
        "Empty: automatic for glued parts, else none.");
  }

  namespace
  {
    /// The constants of the stiffest part stand for the whole body where one number is asked for.
    void take_materials_of_parts(const dealii::ParameterHandler &prm, BodyDescription &body,
                                 const std::string &where)
    {
      for (const auto &[entry, unused] : {std::pair("Young modulus", "1"), {"Poisson ratio", "0.3"}})
        if (prm.get(entry) != unused)
          throw UserError(where + entry + ": received `" + prm.get(entry) +
                          "`, but each of the glued parts has its own; leave the entry out");
      body.regions.clear();
      body.young_modulus = 0.;
      for (const BodyDescription &part : body.parts)
      {
        body.regions.push_back({part.name, {part.young_modulus, part.poisson_ratio}});
        for (const RegionMaterial &region : part.regions)
          body.regions.push_back({part.name + "." + region.region, region.material});
        if (part.young_modulus > body.young_modulus)
        {
          body.young_modulus = part.young_modulus;
          body.poisson_ratio = part.poisson_ratio;
        }
      }
    }
  } // namespace

  void parse_glued_parts(const dealii::ParameterHandler &prm, BodyDescription &body, const Parts &parts,
                         const std::string &where)
  {
    body.joints.glue = parse_glue(prm.get("Glue"), where + "Glue");
    const auto names = dealii::Utilities::split_string_list(prm.get("Parts"));
    if (shape_of(body).takes_parts ? names.size() < 2 : !names.empty())
      throw UserError(where + "Parts: received `" + prm.get("Parts") +
                      "`, the shape glued parts and no other has parts, two at least");
    if (names.empty())
      return;
    for (const auto &[entry, unused] :
         {std::pair("Size", "1, 1"), {"Cells", "8, 8"}, {"Mesh size", "0"}, {"Corner angle", "20"}})
      if (prm.get(entry) != unused)
        throw UserError(where + entry + ": received `" + prm.get(entry) +
                        "`, but each of the glued parts has its own; leave the entry out");
    for (const std::string &name : names)
    {
      const auto found =
          std::find_if(parts.begin(), parts.end(), [&](const BodyDescription &p) { return p.name == name; });
      static const std::regex allowed("[A-Za-z0-9_-]+");
      if (!std::regex_match(name, allowed))
        throw UserError(where + "Parts: received the name `" + name +
                        "`, allowed are letters, digits, underscores and hyphens");
      if (std::any_of(body.parts.begin(), body.parts.end(),
                      [&](const BodyDescription &p) { return p.name == name; }))
        throw UserError(where + "Parts: the name `" + name + "` is given twice, once is allowed");
      if (found == parts.end())
        throw UserError(where + "Parts: `" + name + "` needs a section `Part " + name + "`, there is none");
      if (found->cell_type != body.cell_type)
        throw UserError("Part " + name + "/Cell type: " + where +
                        "Cell type is another one, all parts of a body need the same");
      body.parts.push_back(*found);
      body.parts.back().degree = body.degree;
    }
    take_materials_of_parts(prm, body, where);
    body.joints.glue.automatic = body.joints.glue.automatic || prm.get("Glue").empty();
  }

  void declare_part(dealii::ParameterHandler &prm)
  {
    declare_shape_parameters(prm);
    declare_placement(prm);
    declare_material(prm);
  }

  BodyDescription parse_part(const dealii::ParameterHandler &prm, const std::string &name,
                             const BodyContext &context)
  {
    const std::string where = "Part " + name + "/";
    BodyDescription part;
    part.name = name;
    part.is_part = true;
    parse_shape_parameters(prm, part, context.constants, where, context.directory);
    if (part.is_rigid || shape_of(part).takes_parts)
      throw UserError(where + "Shape: received `" + part.shape +
                      "`, a part deforms and has a mesh of its own");
    part.placement = parse_placement(prm, where);
    parse_material(prm, part, context.materials, where);
    return part;
  }

  std::vector<Material> BodyDescription::materials() const
  {
    std::vector<Material> all{{young_modulus, poisson_ratio}};
    for (const RegionMaterial &region : regions)
      all.push_back(region.material);
    return all;
  }

  double BodyDescription::largest_poisson_ratio() const
  {
    double largest = poisson_ratio;
    for (const RegionMaterial &region : regions)
      largest = std::max(largest, region.material.poisson_ratio);
    return largest;
  }

  bool BodyDescription::has_inner_interfaces() const
  {
    if (parts.empty())
      return !regions.empty();
    return std::any_of(parts.begin(), parts.end(),
                       [](const BodyDescription &part) { return !part.regions.empty(); });
  }
} // namespace abut
