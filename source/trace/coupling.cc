// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/trace/coupling.h>
#include <abut/trace/displacement_entries.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;
    using Triplets = std::vector<Eigen::Triplet<double>>;

    class Coupler
    {
    public:
      Coupler(const Surface &surface, const CommonNormal &normal, const SurfaceLink &link,
              const GapFunction &gap, const std::size_t n_parts)
          : cut_(*surface.cut[link.cut].trace), other_(*surface.others[link.other].trace), normal_(normal),
            gap_(gap), rule_(std::max(cut_.basis().degree(), other_.basis().degree()) + 3)
      {
        result_.weights = result_.gap = Eigen::VectorXd::Zero(static_cast<Index>(n_parts));
      }

      void add(const Piece &piece)
      {
        const Segment &segment = cut_.segments()[piece.cut_segment],
                      &opposite_segment = other_.segments()[piece.other_segment];
        for (Index q = 0; q < rule_.points.size(); ++q)
        {
          const double s = piece.start + (piece.end - piece.start) * rule_.points[q];
          const double weight =
              (piece.end - piece.start) * rule_.weights[q] * cut_.tangent(segment, s).norm();
          const Opposite opposite = normal_.project(piece.cut_segment, s, piece.other_segment);
          add_gap(piece.part, weight, cut_.point(segment, s), opposite);
          add_rows(piece.part, -weight, cut_.basis().values(s), segment, opposite.normal, of_cut_);
          add_rows(piece.part, weight, other_.basis().values(opposite.t), opposite_segment, opposite.normal,
                   of_other_);
        }
      }

      Coupling result()
      {
        for (std::size_t d = 0; d < n_directions; ++d)
        {
          result_.cut[d] = assemble(of_cut_[d], cut_);
          result_.other[d] = assemble(of_other_[d], other_);
        }
        return std::move(result_);
      }

    private:
      void add_gap(const std::size_t part, const double weight, const Vector2 &point,
                   const Opposite &opposite)
      {
        const double gap = gap_(point, opposite);
        result_.weights[static_cast<Index>(part)] += weight;
        result_.gap[static_cast<Index>(part)] += weight * gap;
        result_.covered_length += weight;
        if (gap < result_.smallest_gap)
        {
          result_.smallest_gap = gap;
          result_.distance_at_smallest = opposite.gap;
        }
        result_.largest_gap = std::max(result_.largest_gap, gap);
        result_.deepest = std::max(result_.deepest, -opposite.gap);
      }

      using ByDirection = std::array<Triplets, n_directions>;

      static void add_rows(const std::size_t part, const double weight, const Eigen::VectorXd &values,
                           const Segment &segment, const Vector2 &normal, ByDirection &triplets)
      {
        const std::array<Vector2, n_directions> directions = {{normal, Vector2(-normal.y(), normal.x())}};
        for (std::size_t d = 0; d < n_directions; ++d)
          add_displacement(static_cast<Index>(part), weight, segment, values, directions[d], triplets[d]);
      }

      PartRows assemble(const Triplets &triplets, const Trace &columns) const
      {
        PartRows matrix(result_.weights.size(), static_cast<Index>(2 * columns.n_nodes()));
        matrix.setFromTriplets(triplets.begin(), triplets.end());
        return matrix;
      }

      const Trace &cut_, &other_;
      const CommonNormal &normal_;
      const GapFunction &gap_;
      const GaussRule rule_;
      ByDirection of_cut_, of_other_;
      Coupling result_;
    };
  } // namespace

  Coupling couple(const Surface &surface, const CommonNormal &normal, const std::vector<Piece> &pieces,
                  const std::size_t n_parts, const std::size_t link, const GapFunction &gap)
  {
    AssertIndexRange(link, surface.links.size());
    Coupler coupler(surface, normal, surface.links[link], gap, n_parts);
    for (const Piece &piece : pieces)
      coupler.add(piece);
    return coupler.result();
  }
} // namespace abut
