// SPDX-License-Identifier: LGPL-2.1-or-later
// Pairs of elements that are close to each other.
#include <abut/bem/fast_kernels.h>
#include <abut/bem/pair_integrator.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

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
    const Index size = degree_ + 1;
    PairIntegrator integrator(elements_, degree_, rule);
    std::vector<std::size_t> leaf_of(elements_.size());
    for (std::size_t i = 0; i < near_.size(); ++i)
      if (tree_.clusters()[i].is_leaf())
        for (std::size_t e = tree_.clusters()[i].first; e < tree_.clusters()[i].last; ++e)
          leaf_of[e] = i;
    // The block of two elements in the rows of the first's leaf.
    const auto set = [&](const std::size_t first, const std::size_t second, const PairBlock &log,
                         const PairBlock &even_real, const PairBlock &even_imag,
                         const PairBlock &double_layer) {
      NearRows &rows = near_[leaf_of[first]];
      const std::size_t leaf = leaf_of[second];
      const auto place = static_cast<std::size_t>(std::find(rows.leaves.begin(), rows.leaves.end(), leaf) -
                                                  rows.leaves.begin());
      AssertIndexRange(place, rows.leaves.size());
      const Index row = static_cast<Index>(first) * size - first_row(leaf_of[first]),
                  column = static_cast<Index>(second) * size - first_row(leaf) + rows.columns[place];
      rows.log.block(row, column, size, size) = log;
      rows.even_real.block(row, column, size, size) = even_real;
      rows.even_imag.block(row, column, size, size) = even_imag;
      rows.double_layer.block(row, column, size, size) = double_layer;
    };
    const auto visit = [&](const std::size_t first, const std::size_t second,
                           const PairIntegrals &integrals) {
      set(first, second, integrals.log, integrals.even_real, integrals.even_imag, integrals.double_layer);
      if (first != second)
        set(second, first, integrals.log.transpose(), integrals.even_real.transpose(),
            integrals.even_imag.transpose(), integrals.reversed.transpose());
    };
    for (std::size_t e = 0; e < elements_.size(); ++e)
      for (const std::size_t leaf : near_[leaf_of[e]].leaves)
      {
        const ClusterTree::Cluster &other = tree_.clusters()[leaf];
        if (other.last > e)
          integrator.integrate(e, std::max(e, other.first), other.last, visit);
      }
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
