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

    /// Real and imaginary parts of vectors, as columns.
    template <typename... Vectors> Eigen::MatrixXd as_parts(const Vectors &...vectors)
    {
      const Index rows = std::max({vectors.size()...});
      Eigen::MatrixXd parts(rows, 2 * static_cast<Index>(sizeof...(vectors)));
      Index column = 0;
      const auto add = [&](const auto &vector) {
        parts.col(column++) = vector.real();
        parts.col(column++) = vector.imag();
      };
      (add(vectors), ...);
      return parts;
    }
    Eigen::VectorXcd from_parts(const Eigen::MatrixXd &parts, const Index vector)
    {
      Eigen::VectorXcd x(parts.rows());
      x.real() = parts.col(2 * vector);
      x.imag() = parts.col(2 * vector + 1);
      return x;
    }
  } // namespace

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
    for (Eigen::MatrixXd *matrix : {&rows.log, &rows.even_real, &rows.even_imag, &rows.double_layer})
      matrix->resize(n_rows(target), columns);
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
    const Eigen::MatrixXd t_g = as_parts(densities.traction, densities.slope),
                          u = as_parts(densities.displacement);
    Eigen::MatrixXd transposed = Eigen::MatrixXd::Zero(u.rows(), 2);
    for (std::size_t i = 0; i < near_.size(); ++i)
    {
      const NearRows &rows = near_[i];
      if (rows.leaves.empty())
        continue;
      const Index row = first_row(i), n = n_rows(i);
      Eigen::MatrixXd near_t_g(rows.log.cols(), 4), near_u(rows.log.cols(), 2);
      for (std::size_t k = 0; k < rows.leaves.size(); ++k)
      {
        const Index first = first_row(rows.leaves[k]), count = n_rows(rows.leaves[k]);
        near_t_g.middleRows(rows.columns[k], count) = t_g.middleRows(first, count);
        near_u.middleRows(rows.columns[k], count) = u.middleRows(first, count);
      }
      const Eigen::MatrixXd log = rows.log * near_t_g, real = rows.even_real * near_t_g,
                            imag = rows.even_imag * near_t_g, layer = rows.double_layer * near_u,
                            back = rows.double_layer.transpose() * t_g.block(row, 0, n, 2);
      const Complex unit(0., 1.);
      products.traction_log.segment(row, n) += from_parts(log, 0);
      products.slope_log.segment(row, n) += from_parts(log, 1);
      products.traction_even.segment(row, n) += from_parts(real, 0) + unit * from_parts(imag, 0);
      products.slope_even.segment(row, n) += from_parts(real, 1) + unit * from_parts(imag, 1);
      products.double_layer.segment(row, n) += from_parts(layer, 0);
      for (std::size_t k = 0; k < rows.leaves.size(); ++k)
        transposed.middleRows(first_row(rows.leaves[k]), n_rows(rows.leaves[k])) +=
            back.middleRows(rows.columns[k], n_rows(rows.leaves[k]));
    }
    products.transposed_double_layer += from_parts(transposed, 0);
  }
} // namespace abut
