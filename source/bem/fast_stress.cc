// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/executor.h>
#include <abut/base/vector_versions.h>
#include <abut/bem/fast_stress.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    constexpr double convergence = .4;
    constexpr std::size_t points_together = 4;   // consecutive points that are told apart near elements only
    constexpr std::size_t leaf_members = 16;     // groups of them
    constexpr std::size_t worth_a_thread = 1024; // groups of them
    constexpr Index column_a = 0, column_b = 1;  // of a series

    /// Around consecutive points.
    std::vector<Disc> discs_around(const std::vector<Complex> &points)
    {
      std::vector<Disc> discs;
      discs.reserve(points.size() / points_together + 1);
      for (std::size_t first = 0; first < points.size(); first += points_together)
      {
        const std::size_t last = std::min(points.size(), first + points_together);
        Disc disc;
        for (std::size_t i = first; i < last; ++i)
          disc.centre += points[i] / static_cast<double>(last - first);
        // Never zero: series count in radii.
        disc.radius = std::numeric_limits<double>::epsilon() * (1. + std::abs(disc.centre));
        for (std::size_t i = first; i < last; ++i)
          disc.radius = std::max(disc.radius, std::abs(points[i] - disc.centre));
        discs.push_back(disc);
      }
      return discs;
    }

    /// Points that are told apart near elements only, and their sums.
    struct PointLanes
    {
      double x[points_together], y[points_together];
      double q_imag[points_together], p_real[points_together], p_imag[points_together];
    };

    /// (re + i im) (x + i y) + add
    inline void horner_step(double &re, double &im, const double x, const double y, const double add_re,
                            const double add_im)
    {
      const double product_re = re * x - im * y;
      im = re * y + im * x + add_im;
      re = product_re + add_re;
    }

    /// A and B + conj(y) A' by Horner's scheme; `terms` has real and imaginary parts of both series in turn.
    ABUT_VECTOR_VERSIONS
    void evaluate_series(const double *const terms, const Index n_terms, PointLanes &lanes)
    {
      double x[points_together], y[points_together];
      double a_re[points_together] = {}, a_im[points_together] = {}, slope_re[points_together] = {},
             slope_im[points_together] = {}, b_re[points_together] = {}, b_im[points_together] = {};
      for (std::size_t i = 0; i < points_together; ++i)
      {
        x[i] = lanes.x[i];
        y[i] = lanes.y[i];
      }
      for (Index m = n_terms; m-- > 0;)
      {
        const double term_a_re = terms[4 * m], term_a_im = terms[4 * m + 1], term_b_re = terms[4 * m + 2],
                     term_b_im = terms[4 * m + 3];
        for (std::size_t i = 0; i < points_together; ++i)
        {
          horner_step(slope_re[i], slope_im[i], x[i], y[i], a_re[i], a_im[i]);
          horner_step(a_re[i], a_im[i], x[i], y[i], term_a_re, term_a_im);
          horner_step(b_re[i], b_im[i], x[i], y[i], term_b_re, term_b_im);
        }
      }
      for (std::size_t i = 0; i < points_together; ++i)
      {
        lanes.q_imag[i] = a_im[i];
        lanes.p_real[i] = b_re[i] + x[i] * slope_re[i] + y[i] * slope_im[i];
        lanes.p_imag[i] = b_im[i] + x[i] * slope_im[i] - y[i] * slope_re[i];
      }
    }

    template <typename T> std::vector<T> in_order(const std::vector<T> &values, const ClusterTree &tree)
    {
      std::vector<T> sorted;
      sorted.reserve(values.size());
      for (const std::size_t i : tree.order())
        sorted.push_back(values[i]);
      return sorted;
    }
  } // namespace

  struct FastStress::Targets
  {
    const std::vector<Complex> &points;
    ClusterTree tree;
    std::vector<StressSums> sums;

    /// Calls f(index of a point) for all of a cluster.
    template <typename Visitor> void visit(const std::size_t cluster, const Visitor &visitor) const
    {
      const ClusterTree::Cluster &members = tree.clusters()[cluster];
      for (std::size_t member = members.first; member < members.last; ++member)
      {
        const std::size_t first = tree.order()[member] * points_together;
        for (std::size_t i = first; i < std::min(points.size(), first + points_together); ++i)
          visitor(i);
      }
    }
  };

  FastStress::FastStress(const std::vector<BoundaryElement> &elements, const BoundaryValues &values,
                         const double shear_modulus, const double poisson_ratio, const double tolerance)
      : poisson_ratio_(poisson_ratio), rules_(checked_degree(elements.size(), values), tolerance),
        translation_(SeriesTranslation::order_for(tolerance, convergence), {{column_a, column_b}}),
        moments_rule_((translation_.order() + rules_.degree) / 2 + 1, rules_.degree),
        tree_(discs_of(elements), StressGroup::max_size)
  {
    Assert(shear_modulus > 0., dealii::ExcMessage("a body has a stiffness"));
    collect(in_order(elements, tree_),
            in_order(stress_densities(values, shear_modulus, poisson_ratio), tree_));
  }

  void FastStress::collect(const std::vector<BoundaryElement> &elements,
                           const std::vector<StressDensity> &densities)
  {
    const auto &clusters = tree_.clusters();
    const HolomorphicSeries zero = HolomorphicSeries::Zero(translation_.order() + 1, 2);
    outgoing_.assign(clusters.size(), zero);
    group_of_.assign(clusters.size(), 0);
    for (std::size_t i = clusters.size(); i-- > 0;)
    {
      const ClusterTree::Cluster &cluster = clusters[i];
      if (cluster.is_leaf())
      {
        for (std::size_t e = cluster.first; e < cluster.last; ++e)
          outgoing_[i] += outgoing(elements[e], densities[e], cluster.disc);
        group_of_[i] = groups_.size();
        groups_.emplace_back(&elements[cluster.first], &densities[cluster.first],
                             static_cast<unsigned int>(cluster.size()), rules_);
      }
      else
        for (const std::size_t child : {cluster.children, cluster.children + 1})
          translation_.out_to_out(outgoing_[child], clusters[child].disc, cluster.disc, outgoing_[i]);
    }
  }

  HolomorphicSeries FastStress::outgoing(const BoundaryElement &element, const StressDensity &density,
                                         const Disc &disc) const
  {
    HolomorphicSeries series = HolomorphicSeries::Zero(translation_.order() + 1, 2);
    const double scale = .5 * element.length / disc.radius;
    for (Index j = 0; j < moments_rule_.points.size(); ++j)
    {
      const Complex y = (element.point(moments_rule_.points[j]) - disc.centre) / disc.radius;
      Complex q = 0., p = 0.;
      for (unsigned int n = 0; n <= rules_.degree; ++n)
      {
        q += scale * moments_rule_.weighted(j, n) * density.q[n];
        p += scale * moments_rule_.weighted(j, n) * density.p[n];
      }
      Complex power = 1., last_power = 0.; // y^(k-1), y^(k-2)
      for (Index k = 1; k < series.rows(); ++k)
      {
        series(k, column_a) -= q * power;
        series(k, column_b) -= p * power + static_cast<double>(k - 1) * std::conj(y) * q * last_power;
        last_power = power;
        power *= y;
      }
    }
    return series;
  }

  std::vector<Stress> FastStress::at(const std::vector<Complex> &points) const
  {
    std::vector<Stress> stresses(points.size());
    if (points.empty())
      return stresses;
    Targets targets{points, ClusterTree(discs_around(points), leaf_members),
                    std::vector<StressSums>(points.size())};
    descend(targets, 0, HolomorphicSeries::Zero(translation_.order() + 1, 2), {0});
    for (std::size_t i = 0; i < points.size(); ++i)
      stresses[i] = interior_stress(targets.sums[i], poisson_ratio_);
    return stresses;
  }

  void FastStress::descend(Targets &targets, const std::size_t cluster, HolomorphicSeries incoming,
                           const std::vector<std::size_t> &sources) const
  {
    const ClusterTree::Cluster &target = targets.tree.clusters()[cluster];
    std::vector<std::size_t> pending = sources, near;
    while (!pending.empty())
    {
      const std::size_t i = pending.back();
      const ClusterTree::Cluster &source = tree_.clusters()[i];
      pending.pop_back();
      if (are_apart(source.disc, target.disc, convergence))
        translation_.out_to_in(outgoing_[i], source.disc, target.disc, incoming);
      else if (source.is_leaf() || (!target.is_leaf() && source.disc.radius < target.disc.radius))
        near.push_back(i);
      else
        pending.insert(pending.end(), {source.children, source.children + 1});
    }
    if (target.is_leaf())
    {
      add_incoming(targets, cluster, incoming);
      add_near(targets, cluster, near);
      return;
    }
    const auto child = [&](const std::size_t k) {
      const Disc &disc = targets.tree.clusters()[target.children + k].disc;
      HolomorphicSeries inside = HolomorphicSeries::Zero(incoming.rows(), incoming.cols());
      translation_.in_to_in(incoming, target.disc, disc, inside);
      descend(targets, target.children + k, std::move(inside), near);
    };
    if (target.size() > worth_a_thread)
      for_each(2, child);
    else
      for (const std::size_t k : {0, 1})
        child(k);
  }

  void FastStress::add_incoming(Targets &targets, const std::size_t cluster,
                                const HolomorphicSeries &incoming) const
  {
    const ClusterTree::Cluster &members = targets.tree.clusters()[cluster];
    for (std::size_t member = members.first; member < members.last; ++member)
    {
      const std::size_t first = targets.tree.order()[member] * points_together,
                        n = std::min(points_together, targets.points.size() - first);
      PointLanes lanes;
      for (std::size_t i = 0; i < points_together; ++i)
      {
        const Complex y =
            (targets.points[first + std::min(i, n - 1)] - members.disc.centre) / members.disc.radius;
        lanes.x[i] = y.real();
        lanes.y[i] = y.imag();
      }
      evaluate_series(reinterpret_cast<const double *>(incoming.data()), incoming.rows(), lanes);
      for (std::size_t i = 0; i < n; ++i)
      {
        StressSums &sums = targets.sums[first + i];
        sums.q_imag += lanes.q_imag[i];
        sums.p_real += lanes.p_real[i];
        sums.p_imag += lanes.p_imag[i];
      }
    }
  }

  void FastStress::add_near(Targets &targets, const std::size_t cluster,
                            const std::vector<std::size_t> &sources) const
  {
    for (const std::size_t source : sources)
      targets.visit(cluster, [&](const std::size_t point) {
        groups_[group_of_[source]].add(rules_, targets.points[point], targets.sums[point]);
      });
  }
} // namespace abut
