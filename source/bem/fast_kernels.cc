// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bem/fast_kernels.h>

#include <deal.II/base/exceptions.h>

#include <cmath>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    constexpr std::size_t kernel_leaf = 32; // elements

    /// Blocks of elements in the order of the tree, or back.
    Eigen::VectorXcd into_tree(const Eigen::VectorXcd &x, const ClusterTree &tree, const Index size)
    {
      Eigen::VectorXcd sorted(x.size());
      for (std::size_t i = 0; i < tree.order().size(); ++i)
        sorted.segment(static_cast<Index>(i) * size, size) =
            x.segment(static_cast<Index>(tree.order()[i]) * size, size);
      return sorted;
    }
    Eigen::VectorXcd out_of_tree(const Eigen::VectorXcd &sorted, const ClusterTree &tree, const Index size)
    {
      Eigen::VectorXcd x(sorted.size());
      for (std::size_t i = 0; i < tree.order().size(); ++i)
        x.segment(static_cast<Index>(tree.order()[i]) * size, size) =
            sorted.segment(static_cast<Index>(i) * size, size);
      return x;
    }

    // Functions of a series; a density and its conjugate follow each other.
    enum : Index
    {
      log_traction = 0,
      log_slope = 2,
      cauchy = 4,
      turned_traction = 6,
      turned_slope = 7,
      n_functions = 8
    };
  } // namespace

  FastKernels::FastKernels(const std::vector<BoundaryElement> &elements, const unsigned int degree,
                           const GalerkinRule &rule)
      : degree_(degree), tree_(discs_of(elements), kernel_leaf), apart_(tree_.clusters().size()),
        near_(tree_.clusters().size())
  {
    for (const std::size_t i : tree_.order())
      elements_.push_back(elements[i]);
    find_neighbours(0, {0});
    integrate_near(rule);
  }

  Index FastKernels::first_row(const std::size_t cluster) const
  {
    return static_cast<Index>(tree_.clusters()[cluster].first) * (degree_ + 1);
  }

  Index FastKernels::n_rows(const std::size_t cluster) const
  {
    return static_cast<Index>(tree_.clusters()[cluster].size()) * (degree_ + 1);
  }

  FastKernels::Expansions::Expansions(const FastKernels &kernels, const double tolerance)
      : translation_(SeriesTranslation::order_for(tolerance, convergence),
                     {{log_traction, turned_traction}, {log_slope, turned_slope}}),
        moments_(kernels.near_.size()), turned_moments_(kernels.near_.size())
  {
    const unsigned int size = kernels.degree_ + 1;
    const Index n = translation_.order() + 1;
    const LegendreRule rule((translation_.order() + size) / 2 + 1, kernels.degree_);
    for (std::size_t i = 0; i < moments_.size(); ++i)
    {
      const ClusterTree::Cluster &leaf = kernels.tree_.clusters()[i];
      if (!leaf.is_leaf())
        continue;
      moments_[i] = turned_moments_[i] = Eigen::MatrixXcd::Zero(n, kernels.n_rows(i));
      for (std::size_t e = 0; e < leaf.size(); ++e)
      {
        const BoundaryElement &element = kernels.elements_[leaf.first + e];
        for (Index j = 0; j < rule.points.size(); ++j)
        {
          const Complex y = (element.point(rule.points[j]) - leaf.disc.centre) / leaf.disc.radius;
          Complex power = .5 * element.length;
          for (Index k = 0; k < n; ++k, power *= y)
            for (unsigned int m = 0; m < size; ++m)
            {
              const Index column = static_cast<Index>(e * size + m);
              moments_[i](k, column) += rule.weighted(j, m) * power;
              turned_moments_[i](k, column) += rule.weighted(j, m) * std::conj(y) * power;
            }
        }
      }
    }
  }

  KernelProducts FastKernels::multiply(const KernelDensities &densities, const Expansions &expansions) const
  {
    const Index size = degree_ + 1, n = static_cast<Index>(elements_.size()) * size;
    AssertDimension(densities.traction.size(), n);
    AssertDimension(densities.displacement.size(), n);
    AssertDimension(densities.slope.size(), n);
    const KernelDensities sorted{into_tree(densities.traction, tree_, size),
                                 into_tree(densities.displacement, tree_, size),
                                 into_tree(densities.slope, tree_, size)};
    const Eigen::VectorXcd zero = Eigen::VectorXcd::Zero(n);
    KernelProducts products{zero, zero, zero, zero, zero, zero};
    add_near(sorted, products);
    add_far(sorted, expansions, products);
    for (Eigen::VectorXcd *product :
         {&products.traction_log, &products.traction_even, &products.slope_log, &products.slope_even,
          &products.double_layer, &products.transposed_double_layer})
      *product = out_of_tree(*product, tree_, size);
    return products;
  }

  void FastKernels::add_far(const KernelDensities &densities, const Expansions &expansions,
                            KernelProducts &products) const
  {
    const auto &clusters = tree_.clusters();
    const SeriesTranslation &translation = expansions.translation_;
    const HolomorphicSeries zero = HolomorphicSeries::Zero(translation.order() + 1, n_functions);
    std::vector<HolomorphicSeries> out(clusters.size(), zero), in(clusters.size(), zero);
    for (std::size_t i = clusters.size(); i-- > 0;)
      if (clusters[i].is_leaf())
        out[i] = outgoing(i, densities, expansions);
      else
        for (const std::size_t child : {clusters[i].children, clusters[i].children + 1})
          translation.out_to_out(out[child], clusters[child].disc, clusters[i].disc, out[i]);
    for (std::size_t i = 0; i < clusters.size(); ++i)
    {
      for (const std::size_t source : apart_[i])
        translation.out_to_in(out[source], clusters[source].disc, clusters[i].disc, in[i]);
      if (clusters[i].is_leaf())
        add_incoming(i, in[i], expansions, products);
      else
        for (const std::size_t child : {clusters[i].children, clusters[i].children + 1})
          translation.in_to_in(in[i], clusters[i].disc, clusters[child].disc, in[child]);
    }
  }

  HolomorphicSeries FastKernels::outgoing(const std::size_t leaf, const KernelDensities &densities,
                                          const Expansions &expansions) const
  {
    const Index row = first_row(leaf), n = n_rows(leaf), size = degree_ + 1;
    const double radius = tree_.clusters()[leaf].disc.radius;
    Eigen::MatrixXcd f(n, 6); // as the first six functions
    f.col(log_traction) = densities.traction.segment(row, n);
    f.col(log_slope) = densities.slope.segment(row, n);
    f.col(cauchy) = densities.displacement.segment(row, n);
    for (const Index column : {log_traction, log_slope, cauchy})
      f.col(column + 1) = f.col(column).conjugate();
    for (Index i = 0; i < n; ++i)
      f.row(i).tail(2) *= elements_[static_cast<std::size_t>((row + i) / size)].direction / radius;
    const Eigen::MatrixXcd moments = expansions.moments_[leaf] * f;
    Eigen::MatrixXcd both(n, 2);
    both << f.col(log_traction), f.col(log_slope);
    const Eigen::MatrixXcd turned = expansions.turned_moments_[leaf] * both;
    HolomorphicSeries series = HolomorphicSeries::Zero(moments.rows(), n_functions);
    series.row(0).head(4) = moments.row(0).head(4);
    for (Index k = 1; k < series.rows(); ++k)
    {
      series.row(k).head(4) = -moments.row(k).head(4) / static_cast<double>(k);
      series.row(k).segment(cauchy, 2) = -moments.row(k - 1).segment(cauchy, 2);
      series.row(k).tail(2) = -turned.row(k - 1);
    }
    return series;
  }

  void FastKernels::add_incoming(const std::size_t leaf, const HolomorphicSeries &incoming,
                                 const Expansions &expansions, KernelProducts &products) const
  {
    const Index row = first_row(leaf), n = n_rows(leaf), size = degree_ + 1, order = incoming.rows() - 1;
    const double radius = tree_.clusters()[leaf].disc.radius;
    Eigen::MatrixXcd slopes = Eigen::MatrixXcd::Zero(order + 1, 4); // radius times those of ln
    for (Index m = 0; m < order; ++m)
      slopes.row(m) = static_cast<double>(m + 1) * incoming.row(m + 1).head(4);
    const Eigen::MatrixXcd values = expansions.moments_[leaf].transpose() * incoming,
                           cauchy_of_traction =
                               expansions.moments_[leaf].transpose() * slopes.leftCols(2) / -radius,
                           turned = expansions.turned_moments_[leaf].transpose() * slopes;
    const Complex factor = 1. / Complex(0., 4. * M_PI);
    products.traction_log.segment(row, n) +=
        .5 * (values.col(log_traction) + values.col(log_traction + 1).conjugate());
    products.slope_log.segment(row, n) +=
        .5 * (values.col(log_slope) + values.col(log_slope + 1).conjugate());
    products.traction_even.segment(row, n) += values.col(turned_traction) + turned.col(log_traction);
    products.slope_even.segment(row, n) += values.col(turned_slope) + turned.col(log_slope);
    products.double_layer.segment(row, n) -=
        factor * (values.col(cauchy) - values.col(cauchy + 1).conjugate());
    for (Index i = 0; i < n; ++i)
    {
      const Complex direction = elements_[static_cast<std::size_t>((row + i) / size)].direction;
      products.transposed_double_layer[row + i] +=
          factor * (direction * cauchy_of_traction(i, 0) - std::conj(direction * cauchy_of_traction(i, 1)));
    }
  }
} // namespace abut
