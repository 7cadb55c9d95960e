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

    /// Multiplies the rows by 1, factor, factor^2, ... Without std::complex, which looks for overflow in
    /// every product.
    void scale_by_powers(const Complex factor, HolomorphicSeries &series)
    {
      const double factor_re = factor.real(), factor_im = factor.imag();
      double re = factor_re, im = factor_im;
      for (Index k = 1; k < series.rows(); ++k)
      {
        auto *const term = reinterpret_cast<double *>(series.data() + k * series.cols());
        for (Index i = 0; i < 2 * series.cols(); i += 2)
        {
          const double term_re = term[i];
          term[i] = re * term_re - im * term[i + 1];
          term[i + 1] = re * term[i + 1] + im * term_re;
        }
        const double last_re = re;
        re = re * factor_re - im * factor_im;
        im = im * factor_re + last_re * factor_im;
      }
    }

    /// Of unit length.
    Complex direction(const Complex step)
    {
      return step == 0. ? 1. : step / std::abs(step);
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
    binomials_ = Eigen::MatrixXd::Zero(n, n);
    for (Index k = 0; k < n; ++k)
    {
      binomials_(k, 0) = 1.;
      for (Index m = 1; m <= k; ++m)
        binomials_(k, m) = binomials_(k, m - 1) * static_cast<double>(k - m + 1) / static_cast<double>(m);
    }
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

  Eigen::MatrixXd SeriesTranslation::shifted_binomials(const double step) const
  {
    const Index n = binomials_.rows();
    Eigen::VectorXd powers(n);
    powers[0] = 1.;
    for (Index k = 1; k < n; ++k)
      powers[k] = step * powers[k - 1];
    Eigen::MatrixXd shifted(n, n);
    for (Index m = 0; m < n; ++m)
    {
      shifted.col(m).head(m).setZero();
      shifted.col(m).tail(n - m) = binomials_.col(m).tail(n - m).cwiseProduct(powers.head(n - m));
    }
    return shifted;
  }

  void SeriesTranslation::out_to_out(const HolomorphicSeries &from, const Disc &from_disc,
                                     const Disc &to_disc, HolomorphicSeries &to) const
  {
    const Complex shift = from_disc.centre - to_disc.centre, step = shift / to_disc.radius;
    const Complex turn = direction(step);
    HolomorphicSeries series = from;
    scale_by_powers(from_disc.radius / to_disc.radius * std::conj(turn), series);
    // y_from^-k, relative to the new radius, is (y^-1/(1 - step y^-1))^k: terms j with step^(j-k) (j-1 over
    // k-1). Turned, the step is real.
    const Index n = series.rows();
    Eigen::MatrixXd shift_terms = Eigen::MatrixXd::Zero(n, n);
    shift_terms(0, 0) = 1.;
    shift_terms.bottomRightCorner(order_, order_) =
        shifted_binomials(std::abs(step)).topLeftCorner(order_, order_).transpose();
    terms(series) = blas_product(terms(series), shift_terms);
    scale_by_powers(turn, series);
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
    const Complex turn = direction(step);
    HolomorphicSeries series = from;
    scale_by_powers(turn, series);
    terms(series) = blas_product(terms(series), shifted_binomials(std::abs(step)));
    scale_by_powers(to_disc.radius / from_disc.radius * std::conj(turn), series);
    turn_incoming(companions_, shift, to_disc.radius, series);
    to += series;
  }
} // namespace abut
