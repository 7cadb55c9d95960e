// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bodies/finite_elements/glue_partners.h>

#include <algorithm>
#include <set>

namespace abut
{
  namespace
  {
    /// The place on a segment next to a point.
    Vector2 nearest_place(const Trace &side, const Segment &segment, const Vector2 &point)
    {
      constexpr int steps = 4; // of Newton: segments are nearly straight
      const Vector2 chord = segment.points.back() - segment.points.front();
      double s = std::clamp((point - segment.points.front()).dot(chord) / chord.squaredNorm(), 0., 1.);
      if (segment.points.size() > 2)
        for (int i = 0; i < steps; ++i)
        {
          const Vector2 tangent = side.tangent(segment, s);
          s = std::clamp(s + (point - side.point(segment, s)).dot(tangent) / tangent.squaredNorm(), 0., 1.);
        }
      return side.point(segment, s);
    }
  } // namespace

  GluePartners::GluePartners(const Space &space) : space_(space)
  {
    for (const GluedSides &pair : space.glued_sides())
    {
      others_[pair.slave].push_back({space.trace(pair.master), pair.reach});
      others_[pair.master].push_back({space.trace(pair.slave), pair.reach});
    }
    if (!others_.empty())
      for (const auto &cell : space.dof_handler().active_cell_iterators())
        cells_.push_back(cell);
  }

  std::optional<GluePartner> GluePartners::opposite(const dealii::types::boundary_id boundary,
                                                    const Vector2 &place) const
  {
    std::optional<GluePartner> partner;
    double smallest = 0.;
    for (const Other &other : others_.at(boundary))
      for (const Segment &segment : other.side.segments())
      {
        const Vector2 there = nearest_place(other.side, segment, place);
        const double distance = (there - place).norm();
        if (distance <= other.reach && (!partner || distance < smallest))
        {
          smallest = distance;
          partner = {cells_[segment.cell], {}, there};
        }
      }
    if (partner)
      partner->unit = space_.mapping().transform_real_to_unit_cell(
          partner->cell, dealii::Point<2>(partner->place.x(), partner->place.y()));
    return partner;
  }

  unsigned int GluePartners::n_opposite(const Cell &cell, const unsigned int face,
                                        const unsigned int n_points) const
  {
    if (!cell->at_boundary(face) || !is_glued(cell->face(face)->boundary_id()))
      return 0;
    std::set<unsigned int> cells;
    const dealii::ReferenceCell reference = cell->reference_cell();
    const auto corner = [&](const unsigned int end) {
      return reference.vertex<2>(reference.face_to_cell_vertices(face, end, 1));
    };
    const auto place = space_.mesh().geometry(space_.mesh().curved ? 4 : 1);
    for (unsigned int i = 0; i < n_points; ++i)
    {
      const double s = (i + .5) / n_points;
      const Vector2 point = place(cell, dealii::Point<2>(corner(0) + s * (corner(1) - corner(0))));
      if (const auto partner = opposite(cell->face(face)->boundary_id(), point))
        cells.insert(partner->cell->active_cell_index());
    }
    return static_cast<unsigned int>(cells.size());
  }
} // namespace abut
