// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/warning.h>

namespace abut
{
  const std::vector<WarningCode> &all_warning_codes()
  {
    static const std::vector<WarningCode> all = {WarningCode::large_strain,
                                                 WarningCode::singular_stress,
                                                 WarningCode::sideways_displacement,
                                                 WarningCode::side_leaves_master,
                                                 WarningCode::large_overlap,
                                                 WarningCode::nothing_touches,
                                                 WarningCode::narrow_contact,
                                                 WarningCode::rough_pressure,
                                                 WarningCode::missed_contact,
                                                 WarningCode::hidden_pair,
                                                 WarningCode::dropped_load,
                                                 WarningCode::load_on_support,
                                                 WarningCode::repeated_parameter,
                                                 WarningCode::unused_parameter,
                                                 WarningCode::estimator_sees_a_part,
                                                 WarningCode::rough_estimator,
                                                 WarningCode::cells_cut,
                                                 WarningCode::one_material,
                                                 WarningCode::facets,
                                                 WarningCode::coarse_curve,
                                                 WarningCode::coarse_data,
                                                 WarningCode::far_motion,
                                                 WarningCode::default_material,
                                                 WarningCode::point_support,
                                                 WarningCode::singular_pressure,
                                                 WarningCode::lost_volume,
                                                 WarningCode::unpaired_overlap,
                                                 WarningCode::body_without_contact,
                                                 WarningCode::coarse_mesh,
                                                 WarningCode::idle_processes,
                                                 WarningCode::checkpoint_not_saved,
                                                 WarningCode::coarse_gap,
                                                 WarningCode::soft_penalty,
                                                 WarningCode::between_materials};
    return all;
  }

  std::string to_string(const WarningCode code)
  {
    switch (code)
    {
    case WarningCode::large_strain:
      return "large-strain";
    case WarningCode::singular_stress:
      return "singular-stress";
    case WarningCode::sideways_displacement:
      return "sideways-displacement";
    case WarningCode::side_leaves_master:
      return "side-leaves-master";
    case WarningCode::large_overlap:
      return "large-overlap";
    case WarningCode::nothing_touches:
      return "nothing-touches";
    case WarningCode::narrow_contact:
      return "narrow-contact";
    case WarningCode::rough_pressure:
      return "rough-pressure";
    case WarningCode::missed_contact:
      return "missed-contact";
    case WarningCode::hidden_pair:
      return "hidden-pair";
    case WarningCode::dropped_load:
      return "dropped-load";
    case WarningCode::load_on_support:
      return "load-on-support";
    case WarningCode::repeated_parameter:
      return "repeated-parameter";
    case WarningCode::unused_parameter:
      return "unused-parameter";
    case WarningCode::estimator_sees_a_part:
      return "estimator-sees-a-part";
    case WarningCode::rough_estimator:
      return "rough-estimator";
    case WarningCode::cells_cut:
      return "cells-cut";
    case WarningCode::one_material:
      return "one-material";
    case WarningCode::facets:
      return "facets";
    case WarningCode::coarse_curve:
      return "coarse-curve";
    case WarningCode::coarse_data:
      return "coarse-data";
    case WarningCode::far_motion:
      return "far-motion";
    case WarningCode::default_material:
      return "default-material";
    case WarningCode::point_support:
      return "point-support";
    case WarningCode::singular_pressure:
      return "singular-pressure";
    case WarningCode::lost_volume:
      return "lost-volume";
    case WarningCode::unpaired_overlap:
      return "unpaired-overlap";
    case WarningCode::body_without_contact:
      return "body-without-contact";
    case WarningCode::coarse_mesh:
      return "coarse-mesh";
    case WarningCode::idle_processes:
      return "idle-processes";
    case WarningCode::checkpoint_not_saved:
      return "checkpoint-not-saved";
    case WarningCode::coarse_gap:
      return "coarse-gap";
    case WarningCode::soft_penalty:
      return "soft-penalty";
    case WarningCode::between_materials:
      return "between-materials";
    }
    return "unknown";
  }
} // namespace abut
