// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bem/boundary_pieces.h>
#include <abut/bem/cluster_tree.h>
#include <abut/bem/kernel_matrices.h>

#include <algorithm>
#include <map>

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

    /// Rows of a basis, in both components, as those of some elements alone.
    class LocalRows
    {
    public:
      LocalRows(const BoundarySpace &space, const std::vector<std::size_t> &elements)
          : n_(space.n_coefficients()), size_(space.density_degree() + 1),
            local_n_(static_cast<Index>(elements.size()) * size_)
      {
        for (std::size_t i = 0; i < elements.size(); ++i)
          place_[elements[i]] = static_cast<Index>(i);
      }

      std::size_t element(const Index row) const { return static_cast<std::size_t>(row % n_ / size_); }
      /// Whether a column has no entry beside these elements.
      bool has(const LegendreBasis &basis, const Index column) const
      {
        for (LegendreBasis::InnerIterator entry(basis, column); entry; ++entry)
          if (place_.count(element(entry.row())) == 0)
            return false;
        return true;
      }
      LegendreBasis restricted(const LegendreBasis &basis, const std::vector<Index> &columns) const
      {
        std::vector<Eigen::Triplet<double>> entries;
        for (std::size_t j = 0; j < columns.size(); ++j)
          for (LegendreBasis::InnerIterator entry(basis, columns[j]); entry; ++entry)
            entries.emplace_back(static_cast<int>(entry.row() / n_ * local_n_ +
                                                  place_.at(element(entry.row())) * size_ +
                                                  entry.row() % size_),
                                 static_cast<int>(j), entry.value());
        LegendreBasis local(2 * local_n_, static_cast<Index>(columns.size()));
        local.setFromTriplets(entries.begin(), entries.end());
        return local;
      }

    private:
      Index n_, size_, local_n_;
      std::map<std::size_t, Index> place_;
    };

    /// The columns of a basis that lie among some elements.
    std::vector<Index> columns_of(const LegendreBasis &basis, const LocalRows &rows,
                                  const std::vector<Index> &candidates)
    {
      std::vector<Index> columns;
      for (const Index column : candidates)
        if (rows.has(basis, column))
          columns.push_back(column);
      return columns;
    }

    /// The columns that have entries on each element.
    std::vector<std::vector<Index>> columns_at(const LegendreBasis &basis, const LocalRows &rows,
                                               const std::size_t n_elements)
    {
      std::vector<std::vector<Index>> columns(n_elements);
      for (Index j = 0; j < basis.cols(); ++j)
        for (LegendreBasis::InnerIterator entry(basis, j); entry; ++entry)
          columns[rows.element(entry.row())].push_back(j);
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

  BoundaryPieces::BoundaryPieces(const BoundarySpace &space, const BoundaryUnknowns &unknowns,
                                 const double poisson_ratio, const GalerkinRule &rule)
  {
    const LegendreBasis &t = unknowns.tractions();
    const DisplacementBasis &u = unknowns.free();
    motions_.resize(u.values.cols(), unknowns.rigid_motions().cols() + unknowns.hole_motions().cols());
    motions_ << unknowns.displacements().transpose() * unknowns.rigid_motions(),
        unknowns.displacements().transpose() * unknowns.hole_motions();

    const std::vector<std::size_t> piece_of = divide(space);
    const auto elements_of = extended(space, piece_of);
    const LocalRows all(space, {});
    const auto t_at = columns_at(t, all, piece_of.size()), u_at = columns_at(u.values, all, piece_of.size());
    const auto owner = [&](const LegendreBasis &basis, const Index column) {
      return piece_of[all.element(LegendreBasis::InnerIterator(basis, column).row())];
    };
    pieces_.resize(elements_of.size());
    for (std::size_t p = 0; p < pieces_.size(); ++p)
    {
      const LocalRows rows(space, elements_of[p]);
      const std::vector<Index> t_columns = columns_of(t, rows, candidates(t_at, elements_of[p])),
                               u_columns = columns_of(u.values, rows, candidates(u_at, elements_of[p]));
      const auto n_t = static_cast<Index>(t_columns.size()), n_u = static_cast<Index>(u_columns.size());
      std::vector<BoundaryElement> elements;
      for (const std::size_t e : elements_of[p])
        elements.push_back(space.elements()[e]);
      const LayerOperators operators(kernel_matrices(elements, space.density_degree(), rule), poisson_ratio);
      const LegendreBasis local_t = rows.restricted(t, t_columns);
      const DisplacementBasis local_u{rows.restricted(u.values, u_columns),
                                      rows.restricted(u.slopes, u_columns)};
      Eigen::MatrixXd matrix(n_t + n_u, n_t + n_u);
      matrix.topLeftCorner(n_t, n_t) = operators.single_layer(local_t, local_t);
      matrix.topRightCorner(n_t, n_u) = -operators.double_layer(local_t, local_u);
      matrix.bottomLeftCorner(n_u, n_t) = -matrix.topRightCorner(n_t, n_u).transpose();
      const Eigen::MatrixXd w = operators.hypersingular(local_u, local_u);
      if (weight_ == 0. && n_u > 0)
        weight_ = w.diagonal().mean();
      Eigen::MatrixXd motions(n_u, motions_.cols());
      for (Index i = 0; i < n_u; ++i)
        motions.row(i) = motions_.row(u_columns[static_cast<std::size_t>(i)]);
      matrix.bottomRightCorner(n_u, n_u) = w + weight_ * motions * motions.transpose();

      Piece &piece = pieces_[p];
      piece.factor.compute(matrix);
      for (const Index column : t_columns)
      {
        if (owner(t, column) == p)
          piece.own.push_back(static_cast<Index>(piece.unknowns.size()));
        piece.unknowns.push_back(column);
      }
      for (const Index column : u_columns)
      {
        if (owner(u.values, column) == p)
          piece.own.push_back(static_cast<Index>(piece.unknowns.size()));
        piece.unknowns.push_back(t.cols() + column);
      }
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
