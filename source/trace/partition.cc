// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/trace/atoms.h>
#include <abut/trace/carrier.h>
#include <abut/trace/partition.h>
#include <abut/trace/run.h>
#include <abut/trace/surface_line.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    constexpr double round_off = 1e-9; // of a box

    /// The boxes between atoms [first, last).
    std::vector<Run> boxes(const std::vector<Atom> &atoms, const std::size_t first, const std::size_t last)
    {
      std::vector<Run> runs;
      for (std::size_t i = first; i < last; ++i)
      {
        if (i == first || atoms[i].cut_before)
          runs.emplace_back();
        runs.back().atoms.push_back(i);
      }
      return runs;
    }
  } // namespace

  Partition::Partition(const Surface &surface, const std::vector<CommonNormal> &normals)
  {
    AssertDimension(normals.size(), surface.links.size());
    std::vector<Atom> atoms = cut_into_atoms(surface, normals);
    const SurfaceLine line(surface);
    RunMerger merger(surface, normals, atoms);
    const auto row_of = [&](const Atom &atom) {
      return line.place(surface.links[atom.piece.link].cut, atom.piece.cut_segment).row;
    };
    for (std::size_t first = 0; first < atoms.size();)
    {
      std::size_t last = first + 1;
      while (last < atoms.size() && atoms[last - 1].joined && row_of(atoms[last]) == row_of(atoms[first]))
        ++last;
      std::optional<double> period; // the end of a row is joined with its start only where it is closed
      if (atoms[last - 1].joined)
        period = line.row(row_of(atoms[first])).length;
      const std::vector<Run> runs = merger.merge(boxes(atoms, first, last), period);
      first = last;
      // Else sides end where the others begin, but for round-off.
      if (runs.size() > 1 || runs[0].length > round_off * runs[0].whole_box)
        add_stretch(runs, atoms, period);
    }
    const Eigen::VectorXd centroids = find_node_shares(surface, normals);
    place_parts(surface, centroids);
  }

  void Partition::add_stretch(const std::vector<Run> &runs, const std::vector<Atom> &atoms,
                              const std::optional<double> &period)
  {
    stretches_.push_back(
        {parts_.size(), parts_.size() + runs.size(), period.has_value(), period.value_or(0.)});
    for (const Run &run : runs)
    {
      for (const std::size_t i : run.atoms)
      {
        pieces_.push_back(atoms[i].piece);
        pieces_.back().part = parts_.size();
      }
      Part part;
      part.start = atoms[run.atoms.front()].piece.arc;
      part.end = atoms[run.atoms.back()].end_arc;
      part.length = run.length;
      parts_.push_back(part);
    }
  }

  void Partition::place_parts(const Surface &surface, const Eigen::VectorXd &centroids)
  {
    for (std::size_t k = 0; k < parts_.size(); ++k)
      parts_[k].place_arc =
          std::clamp(centroids[static_cast<Eigen::Index>(k)], parts_[k].start, parts_[k].end);
    for (const Stretch &stretch : stretches_)
      if (!stretch.closed && stretch.last - stretch.first > 1)
      {
        parts_[stretch.first].place_arc = parts_[stretch.first].start;
        parts_[stretch.last - 1].place_arc = parts_[stretch.last - 1].end;
      }
    std::size_t piece = 0;
    for (std::size_t k = 0; k < parts_.size(); ++k)
    {
      Part &part = parts_[k];
      const std::size_t first = piece;
      while (piece < pieces_.size() && pieces_[piece].part == k)
        ++piece;
      const PlaceOnSide middle = place_on_side(surface, first, piece, .5 * (part.start + part.end)),
                        place = place_on_side(surface, first, piece, part.place_arc);
      part.middle = middle.point;
      part.place = place.point;
      part.side = place.side;
      part.segment = place.segment;
      part.s = place.s;
      part.arc_length = place.arc_length;
    }
  }

  Partition::PlaceOnSide Partition::place_on_side(const Surface &surface, const std::size_t first,
                                                  const std::size_t last, const double arc) const
  {
    std::size_t i = first;
    while (i + 1 < last && pieces_[i + 1].arc <= arc)
      ++i;
    const Piece &piece = pieces_[i];
    const std::size_t side = surface.links[piece.link].cut;
    const Trace &cut = *surface.cut[side].trace;
    const Segment &segment = cut.segments()[piece.cut_segment];
    const double s = std::clamp(piece.start + (arc - piece.arc) / segment.length, piece.start, piece.end);
    return {side, piece.cut_segment, s, segment.arc_start + s * segment.length, cut.point(segment, s)};
  }

  const Stretch &Partition::stretch_of(const std::size_t part) const
  {
    AssertIndexRange(part, parts_.size());
    return *std::find_if(stretches_.begin(), stretches_.end(),
                         [&](const Stretch &stretch) { return part < stretch.last; });
  }

  std::vector<std::vector<std::size_t>> Partition::neighbours() const
  {
    std::vector<std::vector<std::size_t>> result(parts_.size());
    const auto connect = [&](const std::size_t a, const std::size_t b) {
      result[a].push_back(b);
      result[b].push_back(a);
    };
    for (const Stretch &stretch : stretches_)
    {
      for (std::size_t k = stretch.first; k + 1 < stretch.last; ++k)
        connect(k, k + 1);
      if (stretch.closed && stretch.last - stretch.first > 2)
        connect(stretch.last - 1, stretch.first);
    }
    return result;
  }
} // namespace abut
