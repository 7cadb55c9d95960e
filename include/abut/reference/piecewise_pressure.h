// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/reference/mirror_rest.h>
#include <abut/reference/periodic_pressure.h>
#include <abut/reference/pole_sum.h>

#include <array>
#include <vector>

namespace abut
{
  /// p = sum_j coefficients[j] t^j with t = (x - start)/(end - start): force per area.
  struct PressurePiece
  {
    double start;
    double end;
    std::array<double, 4> coefficients;
  };

  /**
   * A pressure made of polynomials of the third degree or less, zero between them; it may jump from piece to
   * piece and have either sign.
   *
   * Every piece is expanded in Legendre polynomials P_n. The periodic kernel is split into the poles (for the
   * potential: logarithms) at s and at its mirror images -s and 2l - s, whose integrals against P_n are the
   * functions Q_n of legendre_second_kind, and the smooth MirrorRest. Errors are
   * some 1e-14 of the largest pressure at any depth and for pieces of any width. Where the pressure jumps,
   * G has the mean of both sides and a large finite number instead of its infinite imaginary part.
   */
  class PiecewisePressure : public PeriodicPressure
  {
  public:
    /// The pieces in any order. Throws UserError when they overlap, are empty or leave [0, length], or for
    /// numbers that are not finite.
    PiecewisePressure(double length, const std::vector<PressurePiece> &pieces);

    double length() const override { return length_; }
    /// Where it jumps, the value of the piece that begins there.
    double value(double x) const override;
    double force() const override;
    double l2_norm() const override;
    /// By double exponential quadrature on every piece: f may have kinks or logarithms at their ends.
    double integrate_against(const std::function<double(double)> &f) const override;
    Eigen::VectorXd modes(Eigen::Index n_modes) const override;
    double potential(double x) const override;
    /// Costs little more for many pieces than for a few.
    Potential complex_potential(double x, double depth) const override;

  private:
    double length_;
    std::vector<PressurePiece> pieces_; // those that are not zero, from left to right
    PoleSum poles_;                     // of pieces and their images
    MirrorRest rest_;
  };
} // namespace abut
