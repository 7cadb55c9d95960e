// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/contact/contact_surface.h>
#include <abut/decomposition/pressure_operator.h>

#include <memory>
#include <vector>

namespace abut
{
  /// What the parts of a surface press on one body.
  struct PressedBody
  {
    double young_modulus;
    double depth;            ///< c_a = H_a/2, beyond which it does not yield
    Eigen::VectorXd weights; ///< D_ia, by parts
  };

  /// C on the parts of one stretch, from the sides' places and the bodies' depths and moduli alone.
  class StretchModel
  {
  public:
    /// (C + theta D) on an active set, inverted.
    class Inverse
    {
    public:
      virtual ~Inverse() = default;
      /// For right sides in columns.
      virtual Eigen::MatrixXd solve(const Eigen::MatrixXd &right_sides) const = 0;
    };

    virtual ~StretchModel() = default;
    virtual Eigen::Index size() const = 0;
    /// C p.
    virtual Eigen::VectorXd respond(const Eigen::VectorXd &pressures) const = 0;
    /// `active`: positions in the stretch, in increasing order; `penalties`: theta D of these.
    virtual std::unique_ptr<Inverse> inverse(const ActiveSet &active,
                                             const Eigen::VectorXd &penalties) const = 0;
    /// Whether inverse() is that of respond(), and not only near it.
    virtual bool is_exact() const = 0;
  };

  /**
   * As a dense matrix:
   *
   *     C_ij = sum_a D_ia D_ja 1/(pi E_a) log(1 + (c_a/r_ij)^2),
   *
   * the half-planes' logarithm near by and nothing beyond the depths of the bodies. The symbol of a body is
   * 2/E_a (1 - exp(-c_a |k|))/|k| > 0: 2/(E_a |k|), a half-plane's, for short waves, H_a/E_a, a layer's, for
   * long ones. Throws ComputationError where the numbers leave the machine's range.
   */
  std::unique_ptr<StretchModel> make_logarithmic_model(const std::vector<Part> &parts, const Stretch &stretch,
                                                       const std::vector<PressedBody> &bodies);

  /**
   * By tridiagonal solves (see HalfLaplacian), for stretches of so many parts that a matrix is no choice: the
   * symbol is 2/E (k^2 + c^-2)^-1/2, with the same limits for short and long waves. Several bodies are taken
   * as one: 1/E is the sum of their (D_ia/D_i)^2/E_a, c their mean depth by these terms. Distances are those
   * along the surface; a closed stretch is cut. A contact that is interrupted goes on beyond the gap, as if
   * its sides were straight there.
   */
  std::unique_ptr<StretchModel> make_half_laplacian_model(const std::vector<Part> &parts,
                                                          const Stretch &stretch,
                                                          const std::vector<PressedBody> &bodies);
} // namespace abut
