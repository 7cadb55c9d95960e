// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/dense_cholesky.h>
#include <abut/bem/holomorphic_series.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    /// Real and imaginary parts of every term, a column for every term.
    Eigen::Map<Eigen::MatrixXd> terms(HolomorphicSeries &series)
    {
      return {reinterpret_cast<double *>(series.data()), 2 * series.cols(), series.rows()};
    }

    /// Multiplies the rows by 1, factor, factor^2, ...
    void scale_by_powers(const Complex factor, HolomorphicSeries &series)
    {
      Complex power = factor;
      for (Index k = 1; k < series.rows(); ++k, power *= factor)
        series.row(k) *= power;
    }

    /// Adds conj(shift) f' to every companion h of an outgoing series.
    void turn_outgoing(const std::vector<SeriesTranslation::Companions> &companions, const Complex shift,
                       const double radius, HolomorphicSeries &series)
    {
      const Complex factor = std::conj(shift) / radius;
      for (const auto &[f, h] : companions)
      {
        series(1, h) += factor * series(0, f);
        for (Index k = 1; k + 1 < series.rows(); ++k)
          series(k + 1, h) -= factor * static_cast<double>(k) * series(k, f);
      }
    }

    /// The same of an incoming series.
    void turn_incoming(const std::vector<SeriesTranslation::Companions> &companions, const Complex shift,
                       const double radius, HolomorphicSeries &series)
    {
      const Complex factor = std::conj(shift) / radius;
      for (const auto &[f, h] : companions)
        for (Index m = 0; m + 1 < series.rows(); ++m)
          series(m, h) += factor * static_cast<double>(m + 1) * series(m + 1, f);
    }
  } // namespace

  SeriesTranslation::SeriesTranslation(const unsigned int order, std::vector<Companions> companions)
      : order_(order), companions_(std::move(companions))
  {
    Assert(order > 0, dealii::ExcMessage("a series has terms"));
    const Index n = order + 1;
    across_ = Eigen::MatrixXd::Zero(n, n);
    across_.col(0).tail(order).setOnes();
    for (Index m = 1; m < n; ++m)
    {
      across_(0, m) = -1. / static_cast<double>(m);
      for (Index k = 1; k < n; ++k)
        across_(k, m) = across_(k, m - 1) * static_cast<double>(k + m - 1) / static_cast<double>(m);
    }
  }

  unsigned int SeriesTranslation::order_for(const double tolerance, const double convergence)
  {
    Assert(tolerance > 0. && convergence > 0. && convergence < 1.,
           dealii::ExcMessage("terms fall towards a tolerance"));
    return static_cast<unsigned int>(
        std::max(4., std::ceil(std::log(tolerance * (1. - convergence)) / std::log(convergence))));
  }

  void SeriesTranslation::out_to_out(const HolomorphicSeries &from, const Disc &from_disc,
                                     const Disc &to_disc, HolomorphicSeries &to) const
  {
    const Complex shift = from_disc.centre - to_disc.centre, step = shift / to_disc.radius;
    HolomorphicSeries series = from;
    scale_by_powers(from_disc.radius / to_disc.radius, series);
    // y_from^-k, relative to the new radius, is (y^-1/(1 - step y^-1))^k: terms j with step^(j-k) (j-1 over
    // k-1).
    for (Index i = order_; i-- > 1;)
      for (Index j = i; j < order_; ++j)
        series.row(j + 1) += step * series.row(j);
    Complex power = step;
    for (Index j = 1; j <= order_; ++j, power *= step)
      series.row(j) -= power / static_cast<double>(j) * from.row(0);
    turn_outgoing(companions_, -shift, to_disc.radius, series);
    to += series;
  }

  void SeriesTranslation::out_to_in(const HolomorphicSeries &from, const Disc &from_disc, const Disc &to_disc,
                                    HolomorphicSeries &to) const
  {
    const Complex shift = to_disc.centre - from_disc.centre;
    Assert(std::abs(shift) > from_disc.radius + to_disc.radius,
           dealii::ExcMessage("the series converges where it is expanded anew"));
    HolomorphicSeries series = from;
    scale_by_powers(from_disc.radius / shift, series);
    terms(series) = blas_product(terms(series), across_);
    series.row(0) += std::log(std::abs(shift)) * from.row(0);
    scale_by_powers(-to_disc.radius / shift, series);
    turn_incoming(companions_, shift, to_disc.radius, series);
    to += series;
  }

  void SeriesTranslation::in_to_in(const HolomorphicSeries &from, const Disc &from_disc, const Disc &to_disc,
                                   HolomorphicSeries &to) const
  {
    const Complex shift = to_disc.centre - from_disc.centre, step = shift / from_disc.radius;
    HolomorphicSeries series = from;
    for (Index i = 0; i < order_; ++i)
      for (Index m = order_; m-- > i;)
        series.row(m) += step * series.row(m + 1);
    scale_by_powers(to_disc.radius / from_disc.radius, series);
    turn_incoming(companions_, shift, to_disc.radius, series);
    to += series;
  }
} // namespace abut
