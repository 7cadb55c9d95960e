// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bem/block_operators.h>
#include <abut/bem/near_system.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;
    using Elements = std::vector<std::size_t>;

    /// A basis by its rows, of which those of some elements are taken.
    class BasisRows
    {
    public:
      BasisRows(const LegendreBasis &basis, const BoundarySpace &space)
          : rows_(basis), n_(space.n_coefficients()), size_(space.density_degree() + 1),
            place_(static_cast<std::size_t>(basis.cols()))
      {}

      /// The columns that have entries there.
      std::vector<Index> columns(const Elements &elements) const
      {
        std::vector<Index> found;
        for_each_entry(elements, [&](Index, const Index column, double) { found.push_back(column); });
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
      }
      /// In these columns, which are all that have entries there.
      LegendreBasis restricted(const Elements &elements, const std::vector<Index> &columns)
      {
        for (std::size_t j = 0; j < columns.size(); ++j)
          place_[static_cast<std::size_t>(columns[j])] = static_cast<int>(j);
        std::vector<Eigen::Triplet<double>> entries;
        for_each_entry(elements, [&](const Index row, const Index column, const double value) {
          entries.emplace_back(static_cast<int>(row), place_[static_cast<std::size_t>(column)], value);
        });
        LegendreBasis basis(2 * static_cast<Index>(elements.size()) * size_,
                            static_cast<Index>(columns.size()));
        basis.setFromTriplets(entries.begin(), entries.end());
        return basis;
      }

    private:
      /// Calls visit(row among those of the elements, column, value).
      template <typename Visitor> void for_each_entry(const Elements &elements, const Visitor &visit) const
      {
        Index local = 0;
        for (Index component = 0; component < 2; ++component)
          for (const std::size_t element : elements)
            for (Index k = 0; k < size_; ++k, ++local)
              for (RowMajor::InnerIterator entry(rows_,
                                                 component * n_ + static_cast<Index>(element) * size_ + k);
                   entry; ++entry)
                visit(local, entry.col(), entry.value());
      }

      using RowMajor = Eigen::SparseMatrix<double, Eigen::RowMajor>;
      RowMajor rows_;
      Index n_, size_;
      std::vector<int> place_;
    };

    Elements elements_of(const ClusterTree &tree, const std::vector<std::size_t> &leaves)
    {
      Elements elements;
      for (const std::size_t leaf : leaves)
        for (std::size_t i = tree.clusters()[leaf].first; i < tree.clusters()[leaf].last; ++i)
          elements.push_back(tree.order()[i]);
      return elements;
    }
  } // namespace

  NearSystem::NearSystem(const FastKernels &kernels, const BoundaryUnknowns &unknowns,
                         const double poisson_ratio)
      : elastic_(poisson_ratio), n_tractions_(unknowns.tractions().cols()),
        blocks_of_(static_cast<std::size_t>(unknowns.size()))
  {
    find_charges(kernels, unknowns);
    BasisRows t(unknowns.tractions(), unknowns.space()), values(unknowns.free().values, unknowns.space()),
        slopes(unknowns.free().slopes, unknowns.space());
    for (std::size_t i = 0; i < kernels.near().size(); ++i)
    {
      const FastKernels::NearRows &near = kernels.near()[i];
      if (near.leaves.empty())
        continue;
      const Elements own = elements_of(kernels.tree(), {i}),
                     others = elements_of(kernels.tree(), near.leaves);
      Block block{t.columns(own), values.columns(own), t.columns(others), values.columns(others), {}, {}, {}};
      const BlockOperators operators(near, poisson_ratio);
      const LegendreBasis left = t.restricted(own, block.tractions);
      block.v =
          operators.symmetric(operators.elastic().single, left, t.restricted(others, block.column_tractions));
      const DisplacementBasis u{values.restricted(others, block.column_displacements),
                                slopes.restricted(others, block.column_displacements)};
      block.k = operators.double_layer(left, u);
      block.w = operators.symmetric(operators.elastic().hypersingular,
                                    slopes.restricted(own, block.displacements), u.slopes);
      for (std::vector<Index> *displacements : {&block.displacements, &block.column_displacements})
        for (Index &unknown : *displacements)
          unknown += n_tractions_;
      for (const std::vector<Index> *rows : {&block.tractions, &block.displacements})
        for (const Index row : *rows)
          blocks_of_[static_cast<std::size_t>(row)].push_back(blocks_.size());
      blocks_.push_back(std::move(block));
    }
  }

  void NearSystem::find_charges(const FastKernels &kernels, const BoundaryUnknowns &unknowns)
  {
    const BoundarySpace &space = unknowns.space();
    elements_.resize(space.elements().size());
    for (std::size_t i = 0; i < kernels.near().size(); ++i)
      for (const std::size_t element : elements_of(kernels.tree(), {i}))
        if (!kernels.near()[i].leaves.empty())
        {
          elements_[element].midpoint = space.elements()[element].point(0.);
          elements_[element].leaf = i;
          elements_[element].near = &kernels.near()[i].leaves;
        }
    const Index size = space.density_degree() + 1, n = space.n_coefficients();
    const auto add = [&](const LegendreBasis &basis, const Index first) {
      for (Index j = 0; j < basis.cols(); ++j)
        for (LegendreBasis::InnerIterator entry(basis, j); entry; ++entry)
          if (entry.row() % size == 0)
          {
            const auto element = static_cast<std::size_t>(entry.row() % n / size);
            const double value = entry.value() * space.elements()[element].length;
            elements_[element].charges.push_back(
                {first + j, entry.row() < n ? Complex(value) : Complex(0., value)});
          }
    };
    add(unknowns.tractions(), 0);
    add(unknowns.free().slopes, n_tractions_);
    integrals_ = unknowns.integrals(unknowns.tractions());
  }

  void NearSystem::add_product(const Eigen::VectorXd &x, Eigen::VectorXd &result) const
  {
    for (const Block &block : blocks_)
    {
      const Eigen::VectorXd t = x(block.column_tractions), u = x(block.column_displacements),
                            own_t = x(block.tractions);
      result(block.tractions) += block.v * t - block.k * u;
      result(block.displacements) += block.w * u;
      result(block.column_displacements) += block.k.transpose() * own_t;
    }
  }

  Eigen::MatrixXd NearSystem::principal(const std::vector<Index> &unknowns, const Elements &elements) const
  {
    constexpr Index none = -1;
    std::vector<Index> place(blocks_of_.size(), none);
    std::vector<std::size_t> blocks;
    for (std::size_t i = 0; i < unknowns.size(); ++i)
    {
      const auto unknown = static_cast<std::size_t>(unknowns[i]);
      place[unknown] = static_cast<Index>(i);
      blocks.insert(blocks.end(), blocks_of_[unknown].begin(), blocks_of_[unknown].end());
    }
    std::sort(blocks.begin(), blocks.end());
    blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
    const auto n = static_cast<Index>(unknowns.size());
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
    // Calls add(row, column, value) for what a block has of these unknowns.
    const auto visit = [&](const std::vector<Index> &rows, const std::vector<Index> &columns,
                           const Eigen::MatrixXd &values, const auto &add) {
      for (std::size_t j = 0; j < columns.size(); ++j)
        if (const Index column = place[static_cast<std::size_t>(columns[j])]; column != none)
          for (std::size_t i = 0; i < rows.size(); ++i)
            if (const Index row = place[static_cast<std::size_t>(rows[i])]; row != none)
              add(row, column, values(static_cast<Index>(i), static_cast<Index>(j)));
    };
    const auto add = [&](const Index row, const Index column, const double value) {
      matrix(row, column) += value;
    };
    for (const std::size_t index : blocks)
    {
      const Block &block = blocks_[index];
      visit(block.tractions, block.column_tractions, block.v, add);
      visit(block.displacements, block.column_displacements, block.w, add);
      visit(block.tractions, block.column_displacements, block.k,
            [&](const Index row, const Index column, const double value) {
              matrix(row, column) -= value;
              matrix(column, row) += value;
            });
    }
    add_far(elements, place, matrix);
    const std::vector<Index> tractions(unknowns.begin(),
                                       std::lower_bound(unknowns.begin(), unknowns.end(), n_tractions_));
    const auto n_t = static_cast<Index>(tractions.size());
    const Eigen::MatrixX2d integrals = integrals_(tractions, Eigen::all);
    matrix.topLeftCorner(n_t, n_t) += elastic_.single.even * integrals * integrals.transpose();
    return matrix;
  }

  void NearSystem::add_far(const Elements &elements, const std::vector<Index> &place,
                           Eigen::MatrixXd &matrix) const
  {
    for (const std::size_t e : elements)
      for (const std::size_t f : elements)
      {
        const Element &first = elements_[e], &second = elements_[f];
        if (std::find(first.near->begin(), first.near->end(), second.leaf) != first.near->end())
          continue;
        const Complex w = second.midpoint - first.midpoint;
        const double log = std::log(std::abs(w));
        const Complex even = std::conj(w) / w;
        const auto between = [&](const ElasticKernels::Kernel &kernel, const Complex p, const Complex q) {
          return kernel.log * log * (std::conj(p) * q).real() + kernel.even * (p * q * even).real();
        };
        for (const Charge &p : first.charges)
          for (const Charge &q : second.charges)
          {
            const Index row = place[static_cast<std::size_t>(p.unknown)],
                        column = place[static_cast<std::size_t>(q.unknown)];
            if (row < 0 || column < 0)
              continue;
            const bool of_traction = p.unknown < n_tractions_, by_traction = q.unknown < n_tractions_;
            const Complex i(0., 1.); // K turns slopes
            if (of_traction == by_traction)
              matrix(row, column) +=
                  between(of_traction ? elastic_.single : elastic_.hypersingular, p.value, q.value);
            else
              matrix(row, column) += of_traction ? -between(elastic_.rotated, p.value, i * q.value)
                                                 : between(elastic_.rotated, i * p.value, q.value);
          }
      }
  }
} // namespace abut
