// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/trace/carrier.h>
#include <abut/trace/partition.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace abut
{
  namespace
  {
    /// The polyline through values at the places of one stretch.
    class PlacePolyline
    {
    public:
      PlacePolyline(const Partition &partition, const Eigen::VectorXd &values, const std::size_t part)
          : partition_(partition), values_(values)
      {
        stretch_ = *std::find_if(partition.stretches().begin(), partition.stretches().end(),
                                 [&](const Stretch &stretch) { return part < stretch.last; });
      }

      /// The value at `arc`, which lies between the places of the neighbours of `part`.
      double at(const std::size_t part, const double arc) const
      {
        const bool before = arc < place(part, 0);
        const auto other = neighbour(part, before ? -1 : 1);
        if (!other)
          return value(part);
        const double here = place(part, 0), there = place(other->first, other->second);
        const double share = there != here ? (arc - here) / (there - here) : 0.;
        return (1. - share) * value(part) + share * value(other->first);
      }

    private:
      /// The next part in a direction, and how often the stretch was gone round.
      std::optional<std::pair<std::size_t, int>> neighbour(const std::size_t part, const int direction) const
      {
        if (direction < 0 && part > stretch_.first)
          return std::pair(part - 1, 0);
        if (direction > 0 && part + 1 < stretch_.last)
          return std::pair(part + 1, 0);
        if (!stretch_.closed || stretch_.last - stretch_.first < 2)
          return {};
        return std::pair(direction < 0 ? stretch_.last - 1 : stretch_.first, direction);
      }
      double place(const std::size_t part, const int rounds) const
      {
        return partition_.parts()[part].place_arc + rounds * stretch_.length;
      }
      double value(const std::size_t part) const { return values_[static_cast<Eigen::Index>(part)]; }

      const Partition &partition_;
      const Eigen::VectorXd &values_;
      Stretch stretch_;
    };
  } // namespace

  double Partition::along(const Eigen::VectorXd &values, const std::size_t part, const double arc) const
  {
    return PlacePolyline(*this, values, part).at(part, arc);
  }

  namespace
  {
    /// The shares in a part's mean of the polyline through the loads, which stand at the parts' middles and
    /// the ends of stretches.
    void add_polyline_mean(const Partition &partition, const std::size_t part,
                           std::vector<Eigen::Triplet<double>> &shares)
    {
      const Part &here = partition.parts()[part];
      const double length = here.end - here.start;
      double own = 1.;
      // Half of what lies between here and the neighbour within the part, by the neighbour's share at its
      // end.
      const auto add = [&](const std::size_t neighbour, const double place, const double other_place,
                           const double end) {
        const double share = .5 * std::abs(end - place) / length * (end - place) / (other_place - place);
        shares.emplace_back(static_cast<int>(part), static_cast<int>(neighbour), share);
        own -= share;
      };
      const Stretch &stretch = *std::find_if(partition.stretches().begin(), partition.stretches().end(),
                                             [&](const Stretch &s) { return part < s.last; });
      const auto place = [&](const std::size_t k) {
        const Part &at = partition.parts()[k];
        const bool alone = stretch.last - stretch.first == 1;
        if (!stretch.closed && !alone && k == stretch.first)
          return at.start;
        return !stretch.closed && !alone && k + 1 == stretch.last ? at.end : .5 * (at.start + at.end);
      };
      if (part > stretch.first)
        add(part - 1, place(part), place(part - 1), here.start);
      else if (stretch.closed && stretch.last - stretch.first > 1)
        add(stretch.last - 1, place(part), place(stretch.last - 1) - stretch.length, here.start);
      if (part + 1 < stretch.last)
        add(part + 1, place(part), place(part + 1), here.end);
      else if (stretch.closed && stretch.last - stretch.first > 1)
        add(stretch.first, place(part), place(stretch.first) + stretch.length, here.end);
      shares.emplace_back(static_cast<int>(part), static_cast<int>(part), own);
    }
  } // namespace

  Eigen::VectorXd Partition::find_node_shares(const Surface &surface,
                                              const std::vector<CommonNormal> &normals)
  {
    const auto middle = [&](const std::size_t k) { return .5 * (parts_[k].start + parts_[k].end); };
    // From the middle of part k to a place within another part of its stretch, the short way round.
    const auto distance = [&](const std::size_t k, const std::size_t other, const double arc) {
      const double ahead = arc - middle(k);
      const auto stretch = std::find_if(stretches_.begin(), stretches_.end(),
                                        [&](const Stretch &s) { return other < s.last; });
      return stretch->closed ? std::remainder(ahead, stretch->length) : ahead;
    };
    std::vector<std::size_t> stretches;
    for (std::size_t i = 0; i < stretches_.size(); ++i)
      stretches.resize(stretches_[i].last, i);
    std::map<std::tuple<bool, std::size_t, unsigned int>, std::size_t> part_of;
    for (const CarrierNode &node : carrier_nodes(surface, normals, pieces_, stretches))
      part_of[{node.is_other, node.side, node.node}] = node.part;

    const auto n = static_cast<Eigen::Index>(parts_.size());
    Eigen::VectorXd integrals = Eigen::VectorXd::Zero(n), moments = integrals; // about the parts' middles
    std::vector<Eigen::Triplet<double>> shares;
    for (const Piece &piece : pieces_)
    {
      const CarrierSegment carrier = carrier_segment(surface, piece);
      const Segment &segment = carrier.trace->segments()[carrier.segment];
      const Trace &cut = *surface.cut[surface.links[piece.link].cut].trace;
      const GaussRule rule(carrier.trace->basis().degree() + 2);
      for (Eigen::Index q = 0; q < rule.points.size(); ++q)
      {
        const double s = piece.start + (piece.end - piece.start) * rule.points[q];
        const double weight = rule.weights[q] * (piece.end - piece.start) *
                              cut.tangent(cut.segments()[piece.cut_segment], s).norm();
        const double place =
            carrier.is_other ? normals[piece.link].project(piece.cut_segment, s, piece.other_segment).t : s;
        const Eigen::VectorXd values = carrier.trace->basis().values(place);
        for (std::size_t i = 0; i < segment.nodes.size(); ++i)
        {
          const auto part = part_of.find({carrier.is_other, carrier.side, segment.nodes[i]});
          if (part == part_of.end() || stretches[part->second] != stretches[piece.part])
            continue;
          const double share = weight * values[static_cast<Eigen::Index>(i)];
          const auto row = static_cast<Eigen::Index>(part->second);
          shares.emplace_back(static_cast<int>(row), static_cast<int>(piece.part), share);
          integrals[row] += share;
          moments[row] +=
              share * distance(part->second, piece.part,
                               piece.arc + (s - piece.start) * cut.segments()[piece.cut_segment].length);
        }
      }
    }
    for (Eigen::Index k = 0; k < n; ++k)
      if (integrals[k] == 0.) // a part without a node
      {
        add_polyline_mean(*this, static_cast<std::size_t>(k), shares);
        integrals[k] = 1.;
      }
    node_shares_.resize(n, n);
    node_shares_.setFromTriplets(shares.begin(), shares.end());
    node_shares_ = integrals.cwiseInverse().asDiagonal() * node_shares_;
    for (Eigen::Index k = 0; k < n; ++k)
      moments[k] = moments[k] / integrals[k] + middle(static_cast<std::size_t>(k));
    return moments;
  }

  Eigen::VectorXd Partition::reported_pressures(const Eigen::VectorXd &loads) const
  {
    return (loads.array() > 0.).select((node_shares_ * loads).array().max(0.), 0.);
  }
} // namespace abut
