// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/trace/carrier.h>
#include <abut/trace/partition.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace abut
{
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
      const Stretch &stretch = partition.stretch_of(part);
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

    /// What the nodes of the carrying side, each with the part that it lies in, get from the parts.
    class NodeShares
    {
    public:
      NodeShares(const Surface &surface, const std::vector<CommonNormal> &normals, const Partition &partition)
          : surface_(surface), normals_(normals), partition_(partition),
            integrals_(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(partition.parts().size()))),
            moments_(integrals_)
      {
        for (std::size_t i = 0; i < partition.stretches().size(); ++i)
          stretches_.resize(partition.stretches()[i].last, i);
        for (const CarrierNode &node : carrier_nodes(surface, normals, partition.pieces(), stretches_))
          part_of_[{node.is_other, node.side, node.node}] = node.part;
        for (const Piece &piece : partition.pieces())
          add(piece);
        for (Eigen::Index k = 0; k < integrals_.size(); ++k)
          if (integrals_[k] == 0.) // a part without a node
          {
            add_polyline_mean(partition, static_cast<std::size_t>(k), shares_);
            integrals_[k] = 1.;
          }
      }

      /// From loads to reported pressures.
      Eigen::SparseMatrix<double, Eigen::RowMajor> matrix() const
      {
        Eigen::SparseMatrix<double, Eigen::RowMajor> result(integrals_.size(), integrals_.size());
        result.setFromTriplets(shares_.begin(), shares_.end());
        return integrals_.cwiseInverse().asDiagonal() * result;
      }
      /// Along the surface.
      Eigen::VectorXd centroids() const
      {
        Eigen::VectorXd result(integrals_.size());
        for (Eigen::Index k = 0; k < result.size(); ++k)
          result[k] = moments_[k] / integrals_[k] + middle(static_cast<std::size_t>(k));
        return result;
      }

    private:
      void add(const Piece &piece)
      {
        const CarrierSegment carrier = carrier_segment(surface_, piece);
        const Trace &cut = *surface_.cut[surface_.links[piece.link].cut].trace;
        const Segment &segment = cut.segments()[piece.cut_segment];
        const GaussRule rule(carrier.trace->basis().degree() + 2);
        for (Eigen::Index q = 0; q < rule.points.size(); ++q)
        {
          const double s = piece.start + (piece.end - piece.start) * rule.points[q];
          const double weight = rule.weights[q] * (piece.end - piece.start) * cut.tangent(segment, s).norm();
          const double place = carrier.is_other
                                   ? normals_[piece.link].project(piece.cut_segment, s, piece.other_segment).t
                                   : s;
          add(carrier, piece.part, piece.arc + (s - piece.start) * segment.length,
              weight * carrier.trace->basis().values(place));
        }
      }
      /// What the nodes of a segment get at a place of the surface within a part.
      void add(const CarrierSegment &carrier, const std::size_t part, const double arc,
               const Eigen::VectorXd &weights)
      {
        const Segment &segment = carrier.trace->segments()[carrier.segment];
        for (std::size_t i = 0; i < segment.nodes.size(); ++i)
        {
          const auto own = part_of_.find({carrier.is_other, carrier.side, segment.nodes[i]});
          if (own == part_of_.end() || stretches_[own->second] != stretches_[part])
            continue;
          const double share = weights[static_cast<Eigen::Index>(i)];
          const auto row = static_cast<Eigen::Index>(own->second);
          shares_.emplace_back(static_cast<int>(row), static_cast<int>(part), share);
          integrals_[row] += share;
          moments_[row] += share * distance(own->second, part, arc);
        }
      }

      double middle(const std::size_t part) const
      {
        return .5 * (partition_.parts()[part].start + partition_.parts()[part].end);
      }
      /// From the middle of a part to a place within another one of its stretch, the short way round.
      double distance(const std::size_t part, const std::size_t other, const double arc) const
      {
        const Stretch &stretch = partition_.stretch_of(other);
        const double ahead = arc - middle(part);
        return stretch.closed ? std::remainder(ahead, stretch.length) : ahead;
      }

      const Surface &surface_;
      const std::vector<CommonNormal> &normals_;
      const Partition &partition_;
      std::vector<std::size_t> stretches_; ///< of every part
      std::map<std::tuple<bool, std::size_t, unsigned int>, std::size_t> part_of_;
      std::vector<Eigen::Triplet<double>> shares_;
      Eigen::VectorXd integrals_, moments_; ///< moments about the parts' middles
    };
  } // namespace

  Eigen::VectorXd Partition::find_node_shares(const Surface &surface,
                                              const std::vector<CommonNormal> &normals)
  {
    const NodeShares shares(surface, normals, *this);
    node_shares_ = shares.matrix();
    return shares.centroids();
  }

  Eigen::VectorXd Partition::reported_pressures(const Eigen::VectorXd &loads) const
  {
    AssertDimension(loads.size(), static_cast<Eigen::Index>(parts_.size()));
    return (loads.array() > 0.).select((node_shares_ * loads).array().max(0.), 0.);
  }
} // namespace abut
