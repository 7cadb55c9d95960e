// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/finite_elements/finite_element_body.h>
#include <abut/decomposition/interface_problem.h>
#include <abut/scene/scene.h>

#include <memory>

namespace abut
{
  /// prm/two-layers.prm with overrides, prepared, up to its interface problem.
  class TwoLayers
  {
  public:
    explicit TwoLayers(const std::vector<std::string> &overrides = {});

    const InterfaceProblem &problem() const { return *problem_; }
    const DecompositionParameters &parameters() const { return scene_.decomposition; }
    const InterfaceProblem::Loads &loads() const { return loads_; }
    const std::vector<std::unique_ptr<FiniteElementBody>> &bodies() const { return bodies_; }

    /// ||u||_A of the displacements that answer the loads and pressures, from the bodies' stiffness.
    double energy_norm(const Eigen::VectorXd &pressures) const;

  private:
    Scene scene_;
    std::vector<std::unique_ptr<FiniteElementBody>> bodies_;
    std::vector<ContactSurface> surfaces_;
    std::unique_ptr<InterfaceProblem> problem_;
    InterfaceProblem::Loads loads_;
  };

  /// Z as a matrix, a column for every multiplier, from solves.
  Eigen::MatrixXd compliance_matrix(const InterfaceProblem &problem);

  /**
   * The pressures of u_theta, independent of any scheme: on the nodes in contact D theta p + C p + g_L = 0,
   * with the set of those nodes found by repetition.
   */
  Eigen::VectorXd limit_pressures(const InterfaceProblem &problem, const Eigen::MatrixXd &compliance,
                                  const InterfaceProblem::Loads &loads);

  /// sqrt(d . C d): the energy norm of the difference of the displacements that pressures make.
  double energy_distance(const Eigen::MatrixXd &compliance, const Eigen::VectorXd &difference);
} // namespace abut
