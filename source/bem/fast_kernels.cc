// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/dense_cholesky.h>
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

    /// M f and M conj(f) from products of the real and imaginary parts of M (rows, one after the other) with
    /// those of f (two columns).
    template <typename Parts> Eigen::VectorXcd times(const Parts &parts)
    {
      const Index n = parts.rows() / 2;
      Eigen::VectorXcd product(n);
      product.real() = parts.col(0).head(n) - parts.col(1).tail(n);
      product.imag() = parts.col(1).head(n) + parts.col(0).tail(n);
      return product;
    }
    template <typename Parts> Eigen::VectorXcd times_conjugate(const Parts &parts)
    {
      const Index n = parts.rows() / 2;
      Eigen::VectorXcd product(n);
      product.real() = parts.col(0).head(n) + parts.col(1).tail(n);
      product.imag() = parts.col(0).tail(n) - parts.col(1).head(n);
      return product;
    }

    /// What the transposed parts of M take to M^T x + sign conj(M^T y), its real and imaginary parts.
    template <typename X, typename Y, typename Parts>
    void set_factors(const X &x, const Y &y, const double sign, Parts &&factors)
    {
      const Index n = x.size();
      factors.col(0).head(n) = x.real() + sign * y.real();
      factors.col(0).tail(n) = -x.imag() - sign * y.imag();
      factors.col(1).head(n) = x.imag() - sign * y.imag();
      factors.col(1).tail(n) = x.real() - sign * y.real();
    }

    /// Adds a multiple of a complex vector that is given by its parts, two columns.
    template <typename Parts, typename Sum>
    void add_parts(const Complex factor, const Parts &parts, Sum &&sum)
    {
      sum.real() += factor.real() * parts.col(0) - factor.imag() * parts.col(1);
      sum.imag() += factor.real() * parts.col(1) + factor.imag() * parts.col(0);
    }

    /// Real and imaginary parts, two columns.
    template <typename Vector, typename Parts> void set_parts(const Vector &x, Parts &&parts)
    {
      parts.col(0) = x.real();
      parts.col(1) = x.imag();
    }
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
        moments_(kernels.near_.size()), directed_moments_(kernels.near_.size())
  {
    const unsigned int size = kernels.degree_ + 1;
    const Index n = translation_.order() + 1;
    const LegendreRule rule((translation_.order() + size) / 2 + 1, kernels.degree_);
    for (std::size_t i = 0; i < moments_.size(); ++i)
    {
      const ClusterTree::Cluster &leaf = kernels.tree_.clusters()[i];
      if (!leaf.is_leaf())
        continue;
      Eigen::MatrixXd &moments = moments_[i], &directed = directed_moments_[i];
      moments = Eigen::MatrixXd::Zero(4 * n, kernels.n_rows(i));
      directed.resize(2 * n, kernels.n_rows(i));
      for (std::size_t e = 0; e < leaf.size(); ++e)
      {
        const BoundaryElement &element = kernels.elements_[leaf.first + e];
        for (Index j = 0; j < rule.points.size(); ++j)
        {
          const Complex y = (element.point(rule.points[j]) - leaf.disc.centre) / leaf.disc.radius;
          Complex power = .5 * element.length;
          for (Index k = 0; k < n; ++k, power *= y)
          {
            const Complex turned = std::conj(y) * power;
            for (unsigned int m = 0; m < size; ++m)
              moments.col(static_cast<Index>(e * size + m))(Eigen::seqN(k, 4, n)) +=
                  rule.weighted(j, m) *
                  Eigen::Vector4d(power.real(), power.imag(), turned.real(), turned.imag());
          }
        }
        const Complex direction = element.direction / leaf.disc.radius;
        for (unsigned int m = 0; m < size; ++m)
        {
          const auto column = static_cast<Index>(e * size + m);
          const auto real = moments.col(column).head(n), imag = moments.col(column).segment(n, n);
          directed.col(column) << direction.real() * real - direction.imag() * imag,
              direction.real() * imag + direction.imag() * real;
        }
      }
    }
  }

  KernelProducts FastKernels::multiply(const KernelDensities &densities, const Expansions &expansions) const
  {
    return multiply(densities, expansions, true);
  }

  KernelProducts FastKernels::multiply_far(const KernelDensities &densities,
                                           const Expansions &expansions) const
  {
    return multiply(densities, expansions, false);
  }

  KernelProducts FastKernels::multiply(const KernelDensities &densities, const Expansions &expansions,
                                       const bool with_near) const
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
    if (with_near)
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
    const Index row = first_row(leaf), n = n_rows(leaf), n_terms = expansions.translation_.order() + 1;
    Eigen::MatrixXd parts(n, 4), displacement(n, 2);
    set_parts(densities.traction.segment(row, n), parts.leftCols(2));
    set_parts(densities.slope.segment(row, n), parts.rightCols(2));
    set_parts(densities.displacement.segment(row, n), displacement);
    const Eigen::MatrixXd moments = blas_product(expansions.moments_[leaf], parts),
                          directed = blas_product(expansions.directed_moments_[leaf], displacement);
    HolomorphicSeries series = HolomorphicSeries::Zero(n_terms, n_functions);
    for (Index density = 0; density < 2; ++density)
    {
      const auto plain = moments.block(0, 2 * density, 2 * n_terms, 2);
      series.col(2 * density) = times(plain);
      series.col(2 * density + 1) = times_conjugate(plain);
      series.col(turned_traction + density).tail(n_terms - 1) =
          -times(moments.block(2 * n_terms, 2 * density, 2 * n_terms, 2)).head(n_terms - 1);
    }
    for (Index k = 1; k < n_terms; ++k)
      series.row(k).head(4) /= -static_cast<double>(k);
    series.col(cauchy).tail(n_terms - 1) = -times(directed).head(n_terms - 1);
    series.col(cauchy + 1).tail(n_terms - 1) = -times_conjugate(directed).head(n_terms - 1);
    return series;
  }

  void FastKernels::add_incoming(const std::size_t leaf, const HolomorphicSeries &incoming,
                                 const Expansions &expansions, KernelProducts &products) const
  {
    const Index row = first_row(leaf), n = n_rows(leaf), n_terms = incoming.rows();
    Eigen::MatrixXcd slopes = Eigen::MatrixXcd::Zero(n_terms, 4); // radius times those of ln
    for (Index m = 0; m + 1 < n_terms; ++m)
      slopes.row(m) = static_cast<double>(m + 1) * incoming.row(m + 1).head(4);
    const Eigen::VectorXcd none = Eigen::VectorXcd::Zero(n_terms);
    Eigen::MatrixXd factors = Eigen::MatrixXd::Zero(4 * n_terms, 10), directed(2 * n_terms, 2);
    const auto set = [&](const Index column, const double sign) {
      set_factors(incoming.col(column), incoming.col(column + 1), sign,
                  factors.block(0, column, 2 * n_terms, 2));
    };
    set(log_traction, 1.);
    set(log_slope, 1.);
    set(cauchy, -1.);
    for (Index density = 0; density < 2; ++density)
    {
      auto both = factors.middleCols(turned_traction + 2 * density, 2);
      set_factors(incoming.col(turned_traction + density), none, 1., both.topRows(2 * n_terms));
      set_factors(slopes.col(2 * density), none, 1., both.bottomRows(2 * n_terms));
    }
    set_factors(slopes.col(log_traction), slopes.col(log_traction + 1), -1., directed);
    const Eigen::MatrixXd values = transposed_blas_product(expansions.moments_[leaf], factors),
                          reversed = transposed_blas_product(expansions.directed_moments_[leaf], directed);
    const Complex factor = 1. / Complex(0., 4. * M_PI);
    add_parts(.5, values.middleCols(log_traction, 2), products.traction_log.segment(row, n));
    add_parts(.5, values.middleCols(log_slope, 2), products.slope_log.segment(row, n));
    add_parts(-factor, values.middleCols(cauchy, 2), products.double_layer.segment(row, n));
    add_parts(1., values.middleCols(turned_traction, 2), products.traction_even.segment(row, n));
    add_parts(1., values.middleCols(turned_traction + 2, 2), products.slope_even.segment(row, n));
    add_parts(-factor, reversed, products.transposed_double_layer.segment(row, n));
  }
} // namespace abut
