// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bem/boundary_pieces.h>
#include <abut/bem/cluster_tree.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    constexpr std::size_t piece_elements = 32;
    constexpr unsigned int overlap = 2; // elements on either side

    /// The piece of every element.
    std::vector<std::size_t> divide(const BoundarySpace &space)
    {
      const ClusterTree tree(discs_of(space.elements()), piece_elements);
      std::vector<std::size_t> piece_of(space.elements().size());
      std::size_t piece = 0;
      for (const ClusterTree::Cluster &cluster : tree.clusters())
        if (cluster.is_leaf())
        {
          for (std::size_t i = cluster.first; i < cluster.last; ++i)
            piece_of[tree.order()[i]] = piece;
          ++piece;
        }
      return piece_of;
    }

    /// The elements of every piece and a few neighbours.
    std::vector<std::vector<std::size_t>> extended(const BoundarySpace &space,
                                                   const std::vector<std::size_t> &piece_of)
    {
      const std::size_t n = piece_of.size();
      std::vector<std::size_t> previous(n);
      for (std::size_t e = 0; e < n; ++e)
        previous[space.next(e)] = e;
      std::vector<std::vector<std::size_t>> pieces(1 + *std::max_element(piece_of.begin(), piece_of.end()));
      for (std::size_t e = 0; e < n; ++e)
      {
        std::size_t before = e, behind = e;
        std::vector<std::size_t> &piece = pieces[piece_of[e]];
        piece.push_back(e);
        for (unsigned int i = 0; i < overlap; ++i)
        {
          before = previous[before];
          behind = space.next(behind);
          piece.insert(piece.end(), {before, behind});
        }
      }
      for (std::vector<std::size_t> &piece : pieces)
      {
        std::sort(piece.begin(), piece.end());
        piece.erase(std::unique(piece.begin(), piece.end()), piece.end());
      }
      return pieces;
    }

    /// The element of a row of a basis.
    std::size_t element_of(const BoundarySpace &space, const Index row)
    {
      return static_cast<std::size_t>(row % space.n_coefficients() / (space.density_degree() + 1));
    }

    /// The columns that have entries on each element.
    std::vector<std::vector<Index>> columns_at(const BoundarySpace &space, const LegendreBasis &basis)
    {
      std::vector<std::vector<Index>> columns(space.elements().size());
      for (Index j = 0; j < basis.cols(); ++j)
        for (LegendreBasis::InnerIterator entry(basis, j); entry; ++entry)
          columns[element_of(space, entry.row())].push_back(j);
      return columns;
    }

    std::vector<Index> candidates(const std::vector<std::vector<Index>> &columns_at,
                                  const std::vector<std::size_t> &elements)
    {
      std::vector<Index> columns;
      for (const std::size_t e : elements)
        columns.insert(columns.end(), columns_at[e].begin(), columns_at[e].end());
      std::sort(columns.begin(), columns.end());
      columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
      return columns;
    }
  } // namespace

  BoundaryPieces::BoundaryPieces(const BoundaryUnknowns &unknowns, const NearSystem &near)
      : motions_(unknowns.motions())
  {
    const BoundarySpace &space = unknowns.space();
    const LegendreBasis &t = unknowns.tractions(), &u = unknowns.free().values;
    const std::vector<std::size_t> piece_of = divide(space);
    const auto elements_of = extended(space, piece_of);
    const auto t_at = columns_at(space, t), u_at = columns_at(space, u);
    pieces_.resize(elements_of.size());
    std::vector<std::size_t> last_piece(piece_of.size(), pieces_.size()); // that had the element
    for (std::size_t p = 0; p < pieces_.size(); ++p)
    {
      for (const std::size_t e : elements_of[p])
        last_piece[e] = p;
      Piece &piece = pieces_[p];
      const auto add_unknowns = [&](const LegendreBasis &basis, const std::vector<std::vector<Index>> &at,
                                    const Index first) {
        for (const Index column : candidates(at, elements_of[p]))
        {
          bool is_inside = true;
          for (LegendreBasis::InnerIterator entry(basis, column); entry; ++entry)
            is_inside = is_inside && last_piece[element_of(space, entry.row())] == p;
          if (!is_inside)
            continue;
          if (piece_of[element_of(space, LegendreBasis::InnerIterator(basis, column).row())] == p)
            piece.own.push_back(static_cast<Index>(piece.unknowns.size()));
          piece.unknowns.push_back(first + column);
        }
        return static_cast<Index>(piece.unknowns.size());
      };
      const Index n_t = add_unknowns(t, t_at, 0), n_u = add_unknowns(u, u_at, t.cols()) - n_t;
      Eigen::MatrixXd matrix = near.principal(piece.unknowns, elements_of[p]);
      auto w = matrix.bottomRightCorner(n_u, n_u);
      if (weight_ == 0. && n_u > 0)
        weight_ = w.diagonal().mean();
      Eigen::MatrixXd motions(n_u, motions_.cols());
      for (Index i = 0; i < n_u; ++i)
        motions.row(i) = motions_.row(piece.unknowns[static_cast<std::size_t>(n_t + i)] - t.cols());
      w += weight_ * motions * motions.transpose();
      piece.factor.compute(matrix);
    }
  }

  Eigen::VectorXd BoundaryPieces::solve(const Eigen::VectorXd &right_side) const
  {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(right_side.size());
    for (const Piece &piece : pieces_)
    {
      const Eigen::VectorXd local = piece.factor.solve(right_side(piece.unknowns));
      for (const Index i : piece.own)
        result[piece.unknowns[static_cast<std::size_t>(i)]] = local[i];
    }
    return result;
  }

  Eigen::VectorXd BoundaryPieces::hold_motions(const Eigen::VectorXd &displacements) const
  {
    return weight_ * motions_ * (motions_.transpose() * displacements);
  }
} // namespace abut
