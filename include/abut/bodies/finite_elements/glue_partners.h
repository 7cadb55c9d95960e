// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/finite_elements/space.h>

#include <map>
#include <optional>

namespace abut
{
  /// What lies opposite a point of a glued side.
  struct GluePartner
  {
    Cell cell;
    dealii::Point<2> unit; ///< on its reference cell
    Vector2 place;
  };

  /// Finds what lies opposite on glued sides of the present mesh. The space must outlive the object.
  class GluePartners
  {
  public:
    explicit GluePartners(const Space &space);

    bool is_glued(const dealii::types::boundary_id boundary) const { return others_.count(boundary) > 0; }
    /// None where the other side has ended.
    std::optional<GluePartner> opposite(dealii::types::boundary_id boundary, const Vector2 &place) const;
    /// How many cells lie opposite an edge of a glued side, as far as points spread over it tell; 0 for
    /// others.
    unsigned int n_opposite(const Cell &cell, unsigned int face, unsigned int n_points = 32) const;

  private:
    struct Other
    {
      Trace side;
      double reach;
    };

    const Space &space_;
    std::map<dealii::types::boundary_id, std::vector<Other>> others_; // of each glued side
    std::vector<Cell> cells_;                                         // by active index
  };
} // namespace abut
