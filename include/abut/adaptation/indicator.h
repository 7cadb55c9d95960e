// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/body_solution.h>
#include <abut/bodies/boundary_elements/boundary_cost.h>
#include <abut/scene/adaptation_parameters.h>

#include <memory>
#include <string>
#include <vector>

namespace abut
{
  /// Estimated errors of a body's stress sigma_F, by active cell index.
  struct CellErrors
  {
    Eigen::VectorXd stress; ///< L2 norm over the cell, of xx, yy, zz and twice xy: sqrt(int e : e)
    Eigen::VectorXd energy; ///< energy norm over the cell: sqrt(int e : C^-1 e)
    Eigen::VectorXd areas;
    double stress_norm = 0.; ///< L2 norm of the better stress (or of sigma_F) over the body
    double energy_norm = 0.; ///< and its energy norm
    /// The better stress at SamplePoints::comparison, point by point as Body::visit_stress goes; empty for
    /// kelly, which has none.
    std::vector<Stress> better;
    std::vector<Stress> better_at_corners; ///< and at Body::visit_corner_stress's; fe-be
    BoundaryCost boundary;                 ///< of fe-be

    /// Without the better stress, which stays where the body lives.
    void serialize(Archive &archive) { archive(stress, energy, areas, stress_norm, energy_norm, boundary); }
  };

  /// Estimates the error of a body's stress in each cell from the body's solution alone.
  class Indicator
  {
  public:
    virtual ~Indicator() = default;
    virtual CellErrors estimate(const BodySolution &solution) const = 0;
    /// Its word in the parameter file, or that of the estimator that it takes where it can.
    virtual std::string name() const = 0;
    /// That of what estimates the errors of a body: some indicators take others for what they are not made
    /// for.
    virtual std::string name_for(const Body &) const { return name(); }
    /// Throws UserError, beginning with `description().section()` of the body, for one that the indicator is
    /// not made for.
    virtual void check(const Body &) const {}
    /// Why the estimate of a body is not that of boundary elements, which bound the error: one sentence,
    /// without the full stop; empty where it is.
    virtual std::string why_uncertified(const Body &) const { return "it compares the body with itself"; }
  };

  /// What estimates again where the goal is near; null but for `automatic`.
  std::unique_ptr<Indicator> make_certifier(const AdaptationParameters &parameters);

  /// The indicator that a scene asks for; null where nothing is estimated.
  std::unique_ptr<Indicator> make_indicator(const AdaptationParameters &parameters);

  /**
   * eta of each cell, relative to the mean stress of the body: with `rms`
   *   eta = sqrt((||e||^2_cell / |cell|) / (||sigma||^2 / |body|)),
   * with `printed`, (27) of the paper to the letter,
   *   eta = (||e||_cell / |cell|) / (||sigma|| / |body|).
   * Zero for a body without stress.
   */
  Eigen::VectorXd relative_errors(const CellErrors &errors, Normalisation normalisation);
} // namespace abut
