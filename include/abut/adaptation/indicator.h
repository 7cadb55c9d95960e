// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/elasticity/body.h>
#include <abut/scene/adaptation_parameters.h>

#include <memory>
#include <vector>

namespace abut
{
  /// What an indicator looks at: one body and its present solution.
  struct BodySolution
  {
    const Body &body;
    const Eigen::VectorXd &deformation;    ///< all unknowns, less the rigid motion
    const Eigen::VectorXd &contact_forces; ///< trace vector
    /// The same, apart for every segment of each contact side (InterfaceProblem::segment_forces); may be
    /// empty for indicators that do not ask for it.
    std::vector<Eigen::VectorXd> segment_forces = {};
  };

  /// Estimated errors of a body's stress sigma_F, by active cell index.
  struct CellErrors
  {
    Eigen::VectorXd stress; ///< L2 norm over the cell, of xx, yy, zz and twice xy
    Eigen::VectorXd energy; ///< energy norm over the cell
    Eigen::VectorXd areas;
    double stress_norm = 0.; ///< L2 norm of the better stress (or of sigma_F) over the body
    double energy_norm = 0.; ///< and its energy norm
  };

  /// Estimates the error of a body's stress in each cell from the body's solution alone.
  class Indicator
  {
  public:
    virtual ~Indicator() = default;
    virtual CellErrors estimate(const BodySolution &solution) const = 0;
  };

  /// The indicator that a scene asks for; none for `EstimatorKind::none`.
  std::unique_ptr<Indicator> make_indicator(EstimatorKind kind);

  /**
   * eta of each cell, relative to the mean stress of the body: with `rms`
   *   eta = sqrt((||e||^2_cell / |cell|) / (||sigma||^2 / |body|)),
   * with `printed`, (27) of the paper to the letter,
   *   eta = (||e||_cell / |cell|) / (||sigma|| / |body|).
   * Zero for a body without stress.
   */
  Eigen::VectorXd relative_errors(const CellErrors &errors, Normalisation normalisation);
} // namespace abut
