// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/trace/carrier.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace abut
{
  namespace
  {
    constexpr double equal = 1e-6; // relative difference of lengths and moduli that are taken as equal

    bool is_less(const double a, const double b)
    {
      return a < b * (1. - equal);
    }

    /// How much stiffer for its size the finer side may be.
    double largest_stiffness(const unsigned int degree)
    {
      return degree == 1 ? 1.5 : 4.;
    }

    bool is_first(const SurfaceSide &a, const SurfaceSide &b)
    {
      return std::pair(a.body, a.side) < std::pair(b.body, b.side);
    }

    /// A side with the length of one of its segments by degree.
    struct Candidate
    {
      const SurfaceSide &side;
      double h;
    };

    bool carries(const Candidate &fine, const Candidate &coarse)
    {
      const double tau = largest_stiffness(fine.side.trace->basis().degree());
      return !is_less(tau * coarse.side.plane_modulus * fine.h, fine.side.plane_modulus * coarse.h);
    }
  } // namespace

  std::vector<double> box_bounds(const Trace &side)
  {
    const Eigen::VectorXd weights = side.basis().integrals();
    std::vector<double> bounds;
    double sum = 0.;
    for (Eigen::Index i = 0; i + 1 < weights.size(); ++i)
      bounds.push_back(sum += weights[i]);
    return bounds;
  }

  double whole_box(const Trace &side, const std::size_t segment, const double s)
  {
    AssertIndexRange(segment, side.segments().size());
    Assert(s > -1e-9 && s < 1. + 1e-9, dealii::ExcMessage("a place of a segment lies in [0, 1]"));
    std::vector<double> bounds = {0.};
    for (const double bound : box_bounds(side))
      bounds.push_back(bound);
    bounds.push_back(1.);
    const auto after = std::upper_bound(bounds.begin() + 1, bounds.end() - 1, s);
    const double share = *after - *(after - 1);
    double length = share * side.segments()[segment].length;
    const auto add = [&](const std::optional<std::size_t> &neighbour) {
      if (neighbour)
        length += bounds[1] * side.segments()[*neighbour].length;
    };
    if (after == bounds.begin() + 1)
      add(side.preceding(segment));
    if (after + 1 == bounds.end())
      add(side.following(segment));
    return length;
  }

  bool other_carries(const Surface &surface, const Piece &piece)
  {
    AssertIndexRange(piece.link, surface.links.size());
    const SurfaceLink &link = surface.links[piece.link];
    if (link.carrier != Carrier::automatic)
      return link.carrier == Carrier::other;
    const auto candidate = [](const SurfaceSide &side, const std::size_t segment) {
      return Candidate{side, side.trace->segments()[segment].length / side.trace->basis().degree()};
    };
    const Candidate cut = candidate(surface.cut[link.cut], piece.cut_segment),
                    other = candidate(surface.others[link.other], piece.other_segment);
    if (is_less(cut.h, other.h))
      return !carries(cut, other);
    if (is_less(other.h, cut.h))
      return carries(other, cut);
    if (is_less(cut.side.plane_modulus, other.side.plane_modulus))
      return false;
    if (is_less(other.side.plane_modulus, cut.side.plane_modulus))
      return true;
    return is_first(other.side, cut.side);
  }

  CarrierSegment carrier_segment(const Surface &surface, const Piece &piece)
  {
    AssertIndexRange(piece.link, surface.links.size());
    const SurfaceLink &link = surface.links[piece.link];
    if (other_carries(surface, piece))
      return {true, link.other, surface.others[link.other].trace, piece.other_segment};
    return {false, link.cut, surface.cut[link.cut].trace, piece.cut_segment};
  }

  namespace
  {
    constexpr double at_end = 1e-7; // of a segment: places that near to the ends of a piece lie on it

    /// The place in s of the cut segment opposite a place of the carrier's segment, if it lies on the piece.
    std::optional<double> place_on_piece(const CommonNormal &normal, const Piece &piece, const bool is_other,
                                         const double place)
    {
      if (!is_other)
        return place > piece.start - at_end && place < piece.end + at_end ? std::optional<double>(place)
                                                                          : std::nullopt;
      const double from = normal.project(piece.cut_segment, piece.start, piece.other_segment).t,
                   to = normal.project(piece.cut_segment, piece.end, piece.other_segment).t;
      if (std::abs(place - from) < at_end)
        return piece.start;
      if (std::abs(place - to) < at_end)
        return piece.end;
      if ((place - from) * (place - to) < 0.)
        return normal.place_opposite(piece.cut_segment, piece.other_segment, place);
      return {};
    }
  } // namespace

  namespace
  {
    /// A side and one of its nodes.
    using NodeId = std::tuple<bool, std::size_t, unsigned int>;

    /// The length of the segments around every node, in all and as far as the side carries there, by stretch.
    struct Lengths
    {
      double whole = 0.;
      std::map<std::size_t, double> carried;
    };

    std::map<NodeId, Lengths> lengths_around_nodes(const Surface &surface,
                                                   const std::vector<CommonNormal> &normals,
                                                   const std::vector<Piece> &pieces,
                                                   const std::vector<std::size_t> &stretches)
    {
      std::map<NodeId, Lengths> lengths;
      const auto add_whole = [&](const std::vector<SurfaceSide> &sides, const bool is_other) {
        for (std::size_t side = 0; side < sides.size(); ++side)
          for (const Segment &segment : sides[side].trace->segments())
            for (const unsigned int node : segment.nodes)
              lengths[{is_other, side, node}].whole += segment.length;
      };
      add_whole(surface.cut, false);
      add_whole(surface.others, true);
      for (const Piece &piece : pieces)
      {
        const CarrierSegment carrier = carrier_segment(surface, piece);
        const Segment &segment = carrier.trace->segments()[carrier.segment];
        double share = piece.end - piece.start;
        if (carrier.is_other)
        {
          const auto place = [&](const double s) {
            return normals[piece.link].project(piece.cut_segment, s, piece.other_segment).t;
          };
          share = std::abs(place(piece.end) - place(piece.start));
        }
        for (const unsigned int node : segment.nodes)
          lengths[{carrier.is_other, carrier.side, node}].carried[stretches[piece.part]] +=
              share * segment.length;
      }
      return lengths;
    }
  } // namespace

  std::vector<CarrierNode> carrier_nodes(const Surface &surface, const std::vector<CommonNormal> &normals,
                                         const std::vector<Piece> &pieces,
                                         const std::vector<std::size_t> &stretches)
  {
    AssertDimension(normals.size(), surface.links.size());
    constexpr double all_of_it = 1. - 1e-6;
    std::map<NodeId, Lengths> lengths = lengths_around_nodes(surface, normals, pieces, stretches);
    std::vector<CarrierNode> nodes;
    for (const Piece &piece : pieces)
    {
      const CarrierSegment carrier = carrier_segment(surface, piece);
      const Segment &segment = carrier.trace->segments()[carrier.segment];
      const Segment &cut = surface.cut[surface.links[piece.link].cut].trace->segments()[piece.cut_segment];
      for (std::size_t i = 0; i < segment.nodes.size(); ++i)
      {
        Lengths &around = lengths[{carrier.is_other, carrier.side, segment.nodes[i]}];
        double &carried = around.carried[stretches[piece.part]];
        if (!(carried > all_of_it * around.whole))
          continue;
        const auto s = place_on_piece(normals[piece.link], piece, carrier.is_other,
                                      carrier.trace->basis().nodes()[static_cast<Eigen::Index>(i)]);
        if (!s)
          continue;
        nodes.push_back({carrier.is_other, carrier.side, segment.nodes[i], piece.part,
                         piece.arc + (*s - piece.start) * cut.length});
        carried = 0.; // found
      }
    }
    return nodes;
  }
} // namespace abut
