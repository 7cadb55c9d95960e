// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/trace/atoms.h>

namespace abut
{
  /// A part in the making: its atoms in their order.
  struct Run
  {
    std::vector<std::size_t> atoms;
    double length = 0., whole_box = 0.;
    bool touches_held = false; ///< supports hold a point of it on both sides
    bool is_held = false;      ///< all of it
    bool settled = false;
  };

  /// Joins short runs of a stretch, and those at held points, to their neighbours (see Partition).
  class RunMerger
  {
  public:
    /// All must outlive the object; atoms that come to lie across the end of a closed stretch are moved on.
    RunMerger(const Surface &surface, const std::vector<CommonNormal> &normals, std::vector<Atom> &atoms);

    /// With a period, the last run is followed by the first, that much further along.
    std::vector<Run> merge(std::vector<Run> runs, const std::optional<double> &period);

  private:
    void join_short();
    void join_held();
    void measure(Run &run) const;
    /// The whole box of the carrier at a place of a run.
    double box_at(const Run &run, double arc) const;
    /// Whether supports hold both bodies along the normal at a point.
    bool is_held(const Piece &piece, double s) const;
    /// The run that is shortest for its box, if it is too short.
    std::optional<std::size_t> shortest() const;
    std::size_t shorter_neighbour(std::size_t k) const;
    void join(std::size_t a, std::size_t b);

    const Surface &surface_;
    const std::vector<CommonNormal> &normals_;
    std::vector<Atom> &atoms_;
    const bool backwards_;
    std::optional<double> period_;
    std::vector<Run> runs_;
  };
} // namespace abut
