// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

#include <vector>

namespace abut
{
  /**
   * The law between the gaps g of an interface's parts and their multipliers p, the tractions that act on
   * both bodies along the frame of the common normal (see Direction): the pressure, positive in compression,
   * then, where the law has them, tangential components. With the set K of admissible multipliers and the
   * projection P on it
   *
   *     p = P(p - (g + theta p) / r)   for every r > 0,
   *
   * exact for theta = 0; with a penalty theta (length / stress) that is p = P(-g / theta). Vectors: part by
   * part, the components of each part one after the other (see MultiplierLayout).
   */
  class ContactLaw
  {
  public:
    virtual ~ContactLaw() = default;

    /// k, at least 1: components of the multiplier of a part.
    virtual Eigen::Index n_components() const = 0;
    /// P p, the admissible multipliers nearest to p.
    virtual Eigen::VectorXd project(const Eigen::VectorXd &multipliers) const = 0;
    /// The multipliers at which P is the identity, also near by: the unknowns of the smooth branch that an
    /// active-set method stands on. Of a pressure: where it presses.
    virtual std::vector<bool> active(const Eigen::VectorXd &multipliers) const = 0;
    /// Whether all components are one, p >= 0: with linear bodies a linear complementarity problem.
    virtual bool is_linear_complementarity() const = 0;

    /// The penalised law P(-g / theta). `penalties`: theta > 0 of every multiplier.
    Eigen::VectorXd penalised(const Eigen::VectorXd &gaps, const Eigen::VectorXd &penalties) const;
    /// p - P(p - (g + theta p) / (theta + beta)), zero where the law holds; beta (length / stress) scales it.
    /// theta + beta > 0.
    Eigen::VectorXd residual(const Eigen::VectorXd &multipliers, const Eigen::VectorXd &gaps,
                             const Eigen::VectorXd &penalties, const Eigen::VectorXd &beta) const;
  };

  /**
   * Frictionless contact, a pressure p_k >= 0. Exact (theta = 0): p_k >= 0, g_k >= 0, p_k g_k = 0. With a
   * penalty p_k = max(0, -g_k) / theta, the gradient of (1 / 2 theta) sum_k D_k (g_k^-)^2, the discrete
   * penalty of (15)-(16).
   */
  class FrictionlessLaw : public ContactLaw
  {
  public:
    Eigen::Index n_components() const override { return 1; }
    Eigen::VectorXd project(const Eigen::VectorXd &multipliers) const override;
    std::vector<bool> active(const Eigen::VectorXd &multipliers) const override;
    bool is_linear_complementarity() const override { return true; }
  };
} // namespace abut
