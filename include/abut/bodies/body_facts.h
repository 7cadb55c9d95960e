// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/body.h>

#include <map>

namespace abut
{
  /**
   * What a body tells of itself on one mesh to those who do not have the mesh: enough to join it with others,
   * to check a scene and to report on it. Members are what the functions of Body with their names return.
   */
  struct BodyFacts
  {
    std::string description; ///< what `describe` writes
    std::vector<Warning> mesh_warnings;
    Counts counts;
    BodyCounters counters;
    unsigned int mesh_version = 0;
    MeshQuality mesh_quality{};
    std::vector<BoundarySide> boundary;
    std::string why_no_bound;

    std::vector<Trace> contact_sides;
    std::vector<double> contact_depths;     ///< of every contact side
    std::vector<Material> materials_behind; ///< likewise
    Eigen::VectorXd prescribed_trace;
    std::optional<Resultant> resultant;
    std::vector<std::string> free_rigid_motions;
    bool is_supported = false;
    std::map<std::string, LostLoad> lost_loads;              ///< of the sides with loads
    std::map<std::string, std::optional<SideFacets>> facets; ///< of the sides that the scene names

    void serialize(Archive &archive)
    {
      archive(description, mesh_warnings, counts, counters, mesh_version, mesh_quality, boundary,
              why_no_bound, contact_sides, contact_depths, materials_behind, prescribed_trace, resultant,
              free_rigid_motions, is_supported, lost_loads, facets);
    }
  };

  /// `contact_sides`: their names.
  BodyFacts facts_of(const Body &body, const std::vector<std::string> &contact_sides);
} // namespace abut
