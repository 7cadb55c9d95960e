// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/trace/mortar.h>

#include <deal.II/base/exceptions.h>

#include <Eigen/LU>
#include <Eigen/SparseLU>

#include <algorithm>
#include <cmath>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;
    using Triplets = std::vector<Eigen::Triplet<double>>;

    constexpr unsigned int extra_points = 3; // of quadrature, for curved sides

    /// Segments between two ends, in their order.
    struct MortarRun
    {
      std::vector<std::size_t> segments;
      bool closed = false;
    };

    std::vector<MortarRun> runs_of(const Trace &side)
    {
      const std::size_t n = side.segments().size();
      const auto goes_on = [&](const std::size_t k) { return side.is_smooth_after(k); };
      const auto is_first = [&](const std::size_t k) {
        const auto before = side.preceding(k);
        return !before || !goes_on(*before);
      };
      std::vector<MortarRun> runs;
      std::vector<bool> taken(n, false);
      const auto follow = [&](std::size_t k) {
        runs.emplace_back();
        for (; !taken[k]; k = *side.following(k))
        {
          taken[k] = true;
          runs.back().segments.push_back(k);
          if (!goes_on(k))
            return;
        }
        runs.back().closed = true;
      };
      for (std::size_t k = 0; k < n; ++k)
        if (is_first(k))
          follow(k);
      for (std::size_t k = 0; k < n; ++k) // what is left is closed
        if (!taken[k])
          follow(k);
      return runs;
    }

    /// The multipliers of a segment as combinations of its shape functions: a row for each node, zero for
    /// ends.
    Eigen::MatrixXd multipliers_of(const Trace &side, const Segment &segment, const bool starts,
                                   const bool ends, const MortarMultipliers kind)
    {
      const LagrangeBasis &basis = side.basis();
      const auto n = static_cast<Index>(basis.degree()) + 1;
      const Index first = starts ? 1 : 0, last = ends ? n - 1 : n, n_kept = last - first;
      Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n, n);
      if (n_kept <= 0)
        return result;
      // Lagrange polynomials through the nodes that are kept: their values at the others.
      auto kept = result.middleRows(first, n_kept);
      for (Index i = first; i < last; ++i)
      {
        result(i, i) = 1.;
        for (const Index end : {Index(0), n - 1})
          if (end < first || end >= last)
          {
            double value = 1.;
            for (Index j = first; j < last; ++j)
              if (j != i)
                value *= (basis.nodes()[end] - basis.nodes()[j]) / (basis.nodes()[i] - basis.nodes()[j]);
            result(i, end) = value;
          }
      }
      if (kind == MortarMultipliers::standard)
        return result;
      const GaussRule rule(basis.degree() + 1 + extra_points);
      Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(n, n);
      for (Index q = 0; q < rule.points.size(); ++q)
      {
        const Eigen::VectorXd values = basis.values(rule.points[q]);
        mass += rule.weights[q] * side.tangent(segment, rule.points[q]).norm() * values * values.transpose();
      }
      const Eigen::VectorXd weights = mass.rowwise().sum();
      const Eigen::MatrixXd moments = kept * mass.middleCols(first, n_kept);
      kept = (weights.segment(first, n_kept).asDiagonal() * moments.inverse() * kept).eval();
      return result;
    }

    /// Integrals of the multipliers against both sides' shape functions.
    class MortarIntegrals
    {
    public:
      MortarIntegrals(const SideOverlap &overlap, const MortarMultipliers kind)
          : slave_(*overlap.surface.cut[0].trace), master_(*overlap.surface.others[0].trace),
            normal_(overlap.normals[0]), multipliers_(slave_.segments().size()),
            is_end_(slave_.n_nodes(), false)
      {
        for (const MortarRun &run : runs_of(slave_))
          add_run(run, kind);
        for (const Piece &piece : overlap.pieces)
          add_piece(piece);
      }

      Mortar result(const MortarMultipliers kind)
      {
        Mortar mortar;
        std::vector<Index> row_of(slave_.n_nodes(), -1);
        for (unsigned int node = 0; node < slave_.n_nodes(); ++node)
          if (!is_end_[node])
          {
            row_of[node] = static_cast<Index>(mortar.slaves.size());
            mortar.slaves.push_back(node);
          }
        const auto n = static_cast<Index>(mortar.slaves.size());
        Triplets d, e, m;
        for (const auto &[node, column, value] : of_slave_)
          if (is_end_[column])
            e.emplace_back(row_of[node], column, -value);
          else if (kind == MortarMultipliers::standard || node == column)
            d.emplace_back(row_of[node], row_of[column], value);
        for (const auto &[node, column, value] : of_master_)
          m.emplace_back(row_of[node], column, value);
        Eigen::SparseMatrix<double> own(n, n), ends(n, static_cast<Index>(slave_.n_nodes())),
            others(n, static_cast<Index>(master_.n_nodes()));
        own.setFromTriplets(d.begin(), d.end());
        ends.setFromTriplets(e.begin(), e.end());
        others.setFromTriplets(m.begin(), m.end());
        mortar.of_slave_side = solved(own, ends, kind);
        mortar.of_master_side = solved(own, others, kind);
        return mortar;
      }

    private:
      struct Entry
      {
        unsigned int row, column;
        double value;
      };

      void add_run(const MortarRun &run, const MortarMultipliers kind)
      {
        const std::size_t n = run.segments.size();
        for (std::size_t i = 0; i < n; ++i)
        {
          const Segment &segment = slave_.segments()[run.segments[i]];
          const bool starts = !run.closed && i == 0, ends = !run.closed && i + 1 == n;
          multipliers_[run.segments[i]] = multipliers_of(slave_, segment, starts, ends, kind);
          if (starts)
            is_end_[segment.nodes.front()] = true;
          if (ends)
            is_end_[segment.nodes.back()] = true;
        }
      }

      void add_piece(const Piece &piece)
      {
        const Segment &own = slave_.segments()[piece.cut_segment],
                      &other = master_.segments()[piece.other_segment];
        const GaussRule rule(std::max(slave_.basis().degree(), master_.basis().degree()) + 1 + extra_points);
        const auto n = static_cast<Index>(own.nodes.size()), n_other = static_cast<Index>(other.nodes.size());
        Eigen::MatrixXd with_own = Eigen::MatrixXd::Zero(n, n),
                        with_other = Eigen::MatrixXd::Zero(n, n_other);
        for (Index q = 0; q < rule.points.size(); ++q)
        {
          const double s = piece.start + (piece.end - piece.start) * rule.points[q];
          const Opposite opposite = normal_.project(piece.cut_segment, s, piece.other_segment);
          const double length = (piece.end - piece.start) * rule.weights[q] * slave_.tangent(own, s).norm();
          const Eigen::VectorXd values = slave_.basis().values(s),
                                psi = multipliers_[piece.cut_segment] * values;
          with_own += length * psi * values.transpose();
          with_other += length * psi * master_.basis().values(opposite.t).transpose();
        }
        for (Index i = 0; i < n; ++i)
        {
          const unsigned int row = own.nodes[static_cast<std::size_t>(i)];
          if (multipliers_[piece.cut_segment].row(i).isZero(0.))
            continue;
          for (Index j = 0; j < n; ++j)
            of_slave_.push_back({row, own.nodes[static_cast<std::size_t>(j)], with_own(i, j)});
          for (Index j = 0; j < n_other; ++j)
            of_master_.push_back({row, other.nodes[static_cast<std::size_t>(j)], with_other(i, j)});
        }
      }

      /// D^-1 times a matrix.
      static Mortar::Matrix solved(const Eigen::SparseMatrix<double> &own,
                                   const Eigen::SparseMatrix<double> &right_sides,
                                   const MortarMultipliers kind)
      {
        constexpr double nothing = 1e-17; // what the inverse has decayed to, of its largest entries
        if (own.rows() == 0 || right_sides.cols() == 0)
          return right_sides;
        if (kind == MortarMultipliers::dual)
          return Eigen::VectorXd(own.diagonal().cwiseInverse()).asDiagonal() * right_sides;
        Eigen::SparseLU<Eigen::SparseMatrix<double>> factor(own);
        const Eigen::MatrixXd solution = factor.solve(Eigen::MatrixXd(right_sides));
        return Mortar::Matrix(solution.sparseView(1., nothing));
      }

      const Trace &slave_, &master_;
      const CommonNormal &normal_;
      std::vector<Eigen::MatrixXd> multipliers_; // of every segment
      std::vector<bool> is_end_;
      std::vector<Entry> of_slave_, of_master_;
    };
  } // namespace

  SideOverlap overlap_of(const Trace &side, const Trace &other, const double reach)
  {
    Assert(reach > 0., dealii::ExcMessage("sides that are glued lie next to each other"));
    SideOverlap overlap{
        {{{&side, 1., 0, 0}}, {{&other, 1., 0, 1}}, {{0, 0, reach, Carrier::cut}}}, {}, {}, 0., 0.};
    overlap.normals = common_normals(overlap.surface);
    double length = 0.;
    for (const Piece &piece : common_refinement(overlap.surface, overlap.normals))
    {
      double farthest = 0.;
      for (const double share : {1e-6, .25, .5, .75, 1. - 1e-6})
        farthest = std::max(farthest, std::abs(overlap.normals[0]
                                                   .project(piece.cut_segment,
                                                            piece.start + share * (piece.end - piece.start),
                                                            piece.other_segment)
                                                   .gap));
      if (farthest > reach)
        continue;
      overlap.pieces.push_back(piece);
      overlap.farthest = std::max(overlap.farthest, farthest);
      length += arc_length(side, side.segments()[piece.cut_segment], piece.start, piece.end);
    }
    overlap.share = length / side.length();
    return overlap;
  }

  std::size_t fewest_inner_nodes(const Trace &side)
  {
    std::size_t fewest = side.n_nodes();
    for (const MortarRun &run : runs_of(side))
      fewest = std::min(fewest, run.segments.size() * side.basis().degree() - (run.closed ? 0 : 1));
    return fewest;
  }

  Mortar make_mortar(const SideOverlap &overlap, const MortarMultipliers multipliers)
  {
    Assert(overlap.share > 1. - 1e-6, dealii::ExcMessage("the master covers its slave"));
    return MortarIntegrals(overlap, multipliers).result(multipliers);
  }
} // namespace abut
