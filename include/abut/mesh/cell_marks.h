// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/archive.h>
#include <abut/base/processes.h>
#include <abut/base/vector2.h>

#include <cstddef>
#include <vector>

namespace dealii
{
  template <int, int> class Triangulation;
}

namespace abut
{
  /// A place where the stress is not smooth, and how much more often than marked the cells there are split:
  /// each time those that touch it.
  struct Grading
  {
    Vector2 place; ///< on a side, or a vertex of the mesh; world frame, undeformed
    unsigned int further;

    void serialize(Archive &archive) { archive(place, further); }
  };

  /// Which cells an adaptation step splits and which it may merge, by active cell index,
  /// that of all processes' cells where these share the mesh.
  struct CellMarks
  {
    std::vector<bool> refine;
    std::vector<bool> coarsen;
    std::vector<Grading> gradings;

    /// Whether some cell is to be split or merged.
    bool any() const;

    void serialize(Archive &archive) { archive(refine, coarsen, gradings); }
  };

  /// No cell marked.
  CellMarks no_marks(std::size_t n_cells);
  CellMarks no_marks(const dealii::Triangulation<2, 2> &triangulation);

  /**
   * Sets the triangulation's flags from the marks; where it is refined, deal.II splits more cells so that
   * none of two levels' difference share an edge. Cells of level 30, 1e-9 of the initial ones, are not split
   * any further: their coordinates run out of digits. Those of `first_level` are never merged, nor are
   * triangles, which deal.II 9.4 cannot do.
   */
  void set_flags(dealii::Triangulation<2, 2> &triangulation, const CellMarks &marks,
                 unsigned int first_level = 0);

  /**
   * Completes the flags, so that none of two levels' difference will share an edge. Where borders between
   * materials are `curved` their cells are split on both sides, and not merged: an edge between a cell and
   * finer ones is straight (CellCharts), a chord that would take area from one material and give it to the
   * other.
   */
  void complete_flags(dealii::Triangulation<2, 2> &triangulation, bool curved_borders);

  /// Splits cells as gradings say, where those that marks name have been split; borders as above.
  /// `processes` share the mesh.
  void grade(dealii::Triangulation<2, 2> &triangulation, const std::vector<Grading> &gradings,
             bool curved_borders = false, const std::shared_ptr<Processes> &processes = nullptr);
} // namespace abut
