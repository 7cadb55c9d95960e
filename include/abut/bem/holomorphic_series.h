// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bem/cluster_tree.h>

#include <Eigen/Core>

#include <vector>

namespace abut
{
  /**
   * Coefficients of several holomorphic functions, a column each; with y = (z - centre)/radius of a disc
   *
   *   outgoing, outside the disc:   f = c_0 ln|z - centre| + sum_k c_k y^-k,   k = 1 ... order,
   *   incoming, inside the disc:    f = sum_m c_m y^m,                         m = 0 ... order.
   *
   * The logarithm stands for the real part of ln(z - centre): the imaginary part, which has no single value,
   * must cancel in what is made of the functions.
   */
  using HolomorphicSeries = Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  /**
   * Moves the series of discs to others [GreengardRokhlin1987]. Functions may come in companions (f, h),
   * of which h + conj(z - centre) f' is what matters, and does not depend on the centre:
   * h becomes h + conj(new centre - centre) f'.
   */
  class SeriesTranslation
  {
  public:
    struct Companions
    {
      Eigen::Index f, h;
    };

    SeriesTranslation(unsigned int order, std::vector<Companions> companions);

    unsigned int order() const { return order_; }
    /// The order from which on the rest of a series is below `tolerance`, where terms fall by `convergence`.
    static unsigned int order_for(double tolerance, double convergence);

    /// Adds an outgoing series to that of a disc around it.
    void out_to_out(const HolomorphicSeries &from, const Disc &from_disc, const Disc &to_disc,
                    HolomorphicSeries &to) const;
    /// Adds an outgoing series, as an incoming one, in a disc apart from it.
    void out_to_in(const HolomorphicSeries &from, const Disc &from_disc, const Disc &to_disc,
                   HolomorphicSeries &to) const;
    /// Adds an incoming series to that of a disc inside.
    void in_to_in(const HolomorphicSeries &from, const Disc &from_disc, const Disc &to_disc,
                  HolomorphicSeries &to) const;

  private:
    /// k over m times step^(k-m), a row for every k.
    Eigen::MatrixXd shifted_binomials(double step) const;

    unsigned int order_;
    std::vector<Companions> companions_;
    Eigen::MatrixXd binomials_; ///< k over m
    Eigen::MatrixXd across_;    ///< incoming (columns) from outgoing terms, in units of radius by distance
  };
} // namespace abut
