// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/results/results.h>
#include <abut/scene/scene.h>

#include <optional>

namespace abut
{
  /// Whether a scene with a Tolerance has reached it with the last pass, or cannot by more cells; empty where
  /// the next mesh may.
  std::optional<AdaptationEnd> tolerance_end(const Scene &scene, const std::vector<PassRecord> &passes);

  /// What to tell where a run with a Tolerance ends without it. `cause`: how the sentence begins; `way`: how
  /// it ends, but where the largest part of the error needs another remedy.
  std::string missed_tolerance(const Scene &scene, const PassRecord &last, const std::string &cause,
                               const std::string &way);
} // namespace abut
