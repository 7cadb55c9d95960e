// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/lagrange_basis.h>
#include <abut/trace/gap_pieces.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    constexpr int most_halvings = 6;

    class GapResolver
    {
    public:
      GapResolver(const Surface &surface, const CommonNormal &normal, const std::size_t link,
                  const GapFunction &gap)
          : cut_(*surface.cut[surface.links[link].cut].trace), normal_(normal), gap_(gap), basis_(4)
      {}

      void add(const Piece &piece, const int halvings = 0)
      {
        if (is_polynomial(piece))
        {
          result_.pieces.push_back(piece);
          return;
        }
        if (halvings == most_halvings)
        {
          result_.pieces.push_back(piece);
          add_step(piece);
          return;
        }
        Piece first = piece, second = piece;
        first.end = second.start = .5 * (piece.start + piece.end);
        second.arc += arc_length(cut_, cut_.segments()[piece.cut_segment], first.start, first.end);
        add(first, halvings + 1);
        add(second, halvings + 1);
      }

      GapPieces result() { return std::move(result_); }

    private:
      double gap_at(const Piece &piece, const double share) const
      {
        const double s = piece.start + share * (piece.end - piece.start);
        return gap_(cut_.point(cut_.segments()[piece.cut_segment], s),
                    normal_.project(piece.cut_segment, s, piece.other_segment));
      }

      Eigen::VectorXd nodal_gaps(const Piece &piece) const
      {
        Eigen::VectorXd gaps(basis_.nodes().size());
        for (Index i = 0; i < gaps.size(); ++i)
          gaps[i] = gap_at(piece, basis_.nodes()[i]);
        return gaps;
      }

      /// What round-off is of.
      double size_of(const Piece &piece, const Eigen::VectorXd &gaps) const
      {
        return std::max(cut_.segments()[piece.cut_segment].length, gaps.cwiseAbs().maxCoeff());
      }

      /// Whether the polynomial through the nodes meets the gap between them, where they are not equidistant:
      /// a wave that looks the same in all of these is none.
      bool is_polynomial(const Piece &piece) const
      {
        constexpr double near = .05, round_off = 1e-12;
        const Eigen::VectorXd gaps = nodal_gaps(piece),
                              off_line = gaps - (gaps.tail(1)[0] - gaps[0]) * basis_.nodes();
        const double allowed =
            near * (off_line.maxCoeff() - off_line.minCoeff()) + round_off * size_of(piece, gaps);
        for (const double share : {.07, .26, .41, .66, .93})
          if (std::abs(basis_.values(share).dot(gaps) - gap_at(piece, share)) > allowed)
            return false;
        return true;
      }

      /// Halves the interval between the two nodes with the largest difference until nothing but a step is
      /// left of it.
      void add_step(const Piece &piece)
      {
        constexpr int n_halvings = 20;
        constexpr double kept = .5, round_off = 1e-9;
        const Eigen::VectorXd gaps = nodal_gaps(piece);
        const Index n = gaps.size() - 1;
        Index steepest = 0;
        (gaps.tail(n) - gaps.head(n)).cwiseAbs().maxCoeff(&steepest);
        double from = basis_.nodes()[steepest], to = basis_.nodes()[steepest + 1], low = gaps[steepest],
               high = gaps[steepest + 1];
        const double height = std::abs(high - low);
        for (int k = 0; k < n_halvings; ++k)
        {
          const double middle = .5 * (from + to), value = gap_at(piece, middle);
          const bool in_first = std::abs(value - low) > std::abs(high - value);
          (in_first ? to : from) = middle;
          (in_first ? high : low) = value;
        }
        if (!(std::abs(high - low) > std::max(kept * height, round_off * size_of(piece, gaps))))
          return;
        const double s = piece.start + from * (piece.end - piece.start);
        result_.steps.push_back(
            {cut_.point(cut_.segments()[piece.cut_segment], s), std::abs(high - low), piece.part});
      }

      const Trace &cut_;
      const CommonNormal &normal_;
      const GapFunction &gap_;
      const LagrangeBasis basis_;
      GapPieces result_;
    };
  } // namespace

  GapPieces pieces_of_link(const Partition &partition, const std::size_t link)
  {
    GapPieces result;
    for (const Piece &piece : partition.pieces())
      if (piece.link == link)
        result.pieces.push_back(piece);
    return result;
  }

  GapPieces resolved_pieces(const Surface &surface, const CommonNormal &normal, const Partition &partition,
                            const std::size_t link, const GapFunction &gap)
  {
    AssertIndexRange(link, surface.links.size());
    GapResolver resolver(surface, normal, link, gap);
    for (const Piece &piece : pieces_of_link(partition, link).pieces)
      resolver.add(piece);
    return resolver.result();
  }
} // namespace abut
