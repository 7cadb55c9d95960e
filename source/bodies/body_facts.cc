// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bodies/body_facts.h>

#include <sstream>

namespace abut
{
  namespace
  {
    void add_sides(const Body &body, const std::vector<std::string> &contact_sides, BodyFacts &facts)
    {
      for (const Condition &condition : body.description().conditions)
        if (!condition.point)
        {
          facts.facets[condition.boundary] = body.facets(condition.boundary);
          if (!is_support(condition.kind))
            facts.lost_loads[condition.boundary] = body.lost_load(condition.boundary);
        }
      for (const std::string &side : contact_sides)
        facts.facets[side] = body.facets(side);
    }
  } // namespace

  BodyFacts facts_of(const Body &body, const std::vector<std::string> &contact_sides)
  {
    BodyFacts facts;
    std::ostringstream description;
    body.describe(description);
    facts.description = description.str();
    facts.mesh_warnings = body.mesh_warnings();
    facts.counts = body.counts();
    facts.counters = body.counters();
    facts.mesh_version = body.mesh_version();
    facts.mesh_quality = body.mesh_quality();
    facts.boundary = body.boundary();
    facts.why_no_bound = body.why_no_bound();
    facts.contact_sides = body.contact_sides();
    for (std::size_t side = 0; side < contact_sides.size(); ++side)
    {
      facts.contact_depths.push_back(body.contact_depth(side));
      facts.materials_behind.push_back(body.material_behind(side));
    }
    facts.prescribed_trace = body.prescribed_trace();
    facts.resultant = body.resultant();
    facts.free_rigid_motions = body.free_rigid_motions();
    facts.is_supported = body.is_supported();
    add_sides(body, contact_sides, facts);
    return facts;
  }
} // namespace abut
