// SPDX-License-Identifier: LGPL-2.1-or-later
// Pairs of elements that are close to each other.
#include <abut/bem/fast_kernels.h>
#include <abut/bem/pair_integrator.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <tuple>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;
  }

  bool FastKernels::is_larger(const std::size_t a, const std::size_t b) const
  {
    const double radius_a = tree_.clusters()[a].disc.radius, radius_b = tree_.clusters()[b].disc.radius;
    return radius_a > radius_b || (radius_a == radius_b && a > b);
  }

  void FastKernels::find_neighbours(const std::size_t target, const std::vector<std::size_t> &sources)
  {
    const ClusterTree::Cluster &own = tree_.clusters()[target];
    std::vector<std::size_t> pending = sources, near;
    while (!pending.empty())
    {
      const std::size_t i = pending.back();
      const ClusterTree::Cluster &source = tree_.clusters()[i];
      pending.pop_back();
      if (are_apart(source.disc, own.disc, convergence))
        apart_[target].push_back(i);
      else if (source.is_leaf() || (!own.is_leaf() && !is_larger(i, target)))
        near.push_back(i);
      else
        pending.insert(pending.end(), {source.children, source.children + 1});
    }
    if (!own.is_leaf())
    {
      for (const std::size_t child : {own.children, own.children + 1})
        find_neighbours(child, near);
      return;
    }
    NearRows &rows = near_[target];
    Index columns = 0;
    for (const std::size_t leaf : near)
    {
      rows.leaves.push_back(leaf);
      rows.columns.push_back(columns);
      columns += n_rows(leaf);
    }
    rows.resize(n_rows(target), columns);
  }

  void FastKernels::integrate_near(const GalerkinRule &rule)
  {
    PairIntegrator integrator(elements_, degree_, rule);
    for (std::size_t i = 0; i < near_.size(); ++i)
      for (const std::size_t other : near_[i].leaves)
        if (tree_.clusters()[other].first >= tree_.clusters()[i].first)
          integrate_near(i, other, integrator);
  }

  void FastKernels::integrate_near(const std::size_t leaf, const std::size_t other,
                                   PairIntegrator &integrator)
  {
    const auto column_of = [&](const std::size_t row_leaf, const std::size_t column_leaf) {
      const NearRows &rows = near_[row_leaf];
      const auto place = std::find(rows.leaves.begin(), rows.leaves.end(), column_leaf) - rows.leaves.begin();
      AssertIndexRange(static_cast<std::size_t>(place), rows.leaves.size());
      return rows.columns[static_cast<std::size_t>(place)];
    };
    const ClusterTree::Cluster &own = tree_.clusters()[leaf], &others = tree_.clusters()[other];
    const Index size = degree_ + 1, column_of_other = column_of(leaf, other),
                column_of_own = column_of(other, leaf);
    // Where the block of an element as the row and another one as the column begins.
    const auto place = [&](const std::size_t first, const std::size_t second) {
      const bool is_own = first < own.last;
      return std::make_tuple(is_own ? leaf : other,
                             static_cast<Index>(first - (is_own ? own : others).first) * size,
                             (is_own ? column_of_other : column_of_own) +
                                 static_cast<Index>(second - (is_own ? others : own).first) * size);
    };
    const auto visit = [&](const std::size_t first, const std::size_t second,
                           const PairIntegrals &integrals) {
      const auto [leaf_of_first, row, column] = place(first, second);
      near_[leaf_of_first].set(row, column, integrals);
      if (first == second)
        return;
      const auto [leaf_of_second, reversed_row, reversed_column] = place(second, first);
      near_[leaf_of_second].set_reversed(reversed_row, reversed_column, integrals);
    };
    for (std::size_t e = own.first; e < own.last; ++e)
      integrator.integrate(e, std::max(e, others.first), others.last, visit);
  }

  void FastKernels::add_near(const KernelDensities &densities, KernelProducts &products) const
  {
    for (std::size_t i = 0; i < near_.size(); ++i)
    {
      const NearRows &rows = near_[i];
      if (rows.leaves.empty())
        continue;
      const Index row = first_row(i), n = n_rows(i);
      const Eigen::VectorXcd blank(rows.log.cols());
      KernelDensities near{blank, blank, blank};
      for (std::size_t k = 0; k < rows.leaves.size(); ++k)
      {
        const Index first = first_row(rows.leaves[k]), column = rows.columns[k],
                    count = n_rows(rows.leaves[k]);
        near.traction.segment(column, count) = densities.traction.segment(first, count);
        near.displacement.segment(column, count) = densities.displacement.segment(first, count);
        near.slope.segment(column, count) = densities.slope.segment(first, count);
      }
      const KernelProducts found = rows.multiply(near, densities.traction.segment(row, n));
      products.traction_log.segment(row, n) += found.traction_log;
      products.traction_even.segment(row, n) += found.traction_even;
      products.slope_log.segment(row, n) += found.slope_log;
      products.slope_even.segment(row, n) += found.slope_even;
      products.double_layer.segment(row, n) += found.double_layer;
      for (std::size_t k = 0; k < rows.leaves.size(); ++k)
        products.transposed_double_layer.segment(first_row(rows.leaves[k]), n_rows(rows.leaves[k])) +=
            found.transposed_double_layer.segment(rows.columns[k], n_rows(rows.leaves[k]));
    }
  }
} // namespace abut
