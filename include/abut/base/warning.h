// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/archive.h>

#include <string>
#include <vector>

namespace abut
{
  /// What a warning is about. The names (to_string) stand in summary.json and in doc/warnings.md: scripts
  /// rely on them.
  enum class WarningCode
  {
    large_strain,
    singular_stress,
    sideways_displacement,
    side_leaves_master,
    large_overlap,
    nothing_touches,
    narrow_contact,
    rough_pressure,
    missed_contact,
    hidden_pair,
    dropped_load,
    load_on_support,
    repeated_parameter,
    unused_parameter,
    estimator_sees_a_part,
    rough_estimator,
    cells_cut,
    one_material,
    facets,
    coarse_curve,
    coarse_data,
    far_motion,
    default_material,
    point_support,
    singular_pressure,
    lost_volume,
    unpaired_overlap,
    body_without_contact,
    coarse_mesh,
    idle_processes,
    checkpoint_not_saved,
    coarse_gap,
    soft_penalty,
    between_materials
  };

  /// All of them, in the order above.
  const std::vector<WarningCode> &all_warning_codes();

  /// "large-strain", ...
  std::string to_string(WarningCode code);

  /// Something that the user should know of the input or of the results.
  struct Warning
  {
    WarningCode code;
    std::string text; ///< one sentence: what, with the numbers, and the way out

    void serialize(Archive &archive) { archive(code, text); }
  };
} // namespace abut
