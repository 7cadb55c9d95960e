// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/report/deformed.h>
#include <abut/run/simulation.h>

#include <string>
#include <vector>

namespace abut
{
  /// One pass of a run as figures show it. The body of interest is the last one that adapts, else the last.
  struct ObservedPass
  {
    PassRecord record;
    Counts counts;                       ///< of the body of interest
    std::size_t boundary_unknowns = 0;   ///< of its boundary elements
    std::size_t boundary_elements = 0;   ///< their number
    std::size_t all_unknowns = 0;        ///< finite and boundary elements of all bodies
    double estimate_seconds = 0.;        ///< of this pass
    DrawnBody drawing;                   ///< the body, undeformed
    std::vector<unsigned int> levels;    ///< how often each of its cells was split
    Polyline contact_displacement;       ///< (x, u_n) of the last iterate at the nodes of its contact sides
    Polyline pressure;                   ///< (x, p) at the nodes of the first pair's slave side
    Vector2 monitored = Vector2::Zero(); ///< its displacement at the point that was asked for
  };

  struct ObservedRun
  {
    std::string name;                    ///< for tables and legends
    std::vector<std::string> parameters; ///< see StudyParameters::Variant; empty for the scene itself
    AdaptationParameters adaptation;     ///< that it ran with
    std::size_t body = 0;                ///< the one of interest
    std::vector<ObservedPass> passes;
    bool converged = false; ///< has reached what it was asked for

    const ObservedPass &last() const { return passes.back(); }
  };

  /// Runs a scene and keeps what figures show; `name` and `parameters` are those of the caller. `monitored`:
  /// a point of the body of interest. Throws UserError (also where the point lies outside) and
  /// ComputationError.
  ObservedRun observe_run(const Scene &scene, const Vector2 &monitored);
} // namespace abut
