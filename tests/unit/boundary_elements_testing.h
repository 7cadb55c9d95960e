// SPDX-License-Identifier: LGPL-2.1-or-later
// The four ways to get boundary elements' stress, and what to compare it with.
#pragma once

#include <abut/adaptation/fe_be.h>

#include "adaptation_testing.h"

namespace abut
{
  inline const BoundarySolution all_boundary_solutions[] = {
      BoundarySolution::trace_space, BoundarySolution::constant_traction, BoundarySolution::reference_quality,
      BoundarySolution::finite_element_trace};

  inline std::string name_of(const BoundarySolution kind)
  {
    const std::string names[] = {"trace space", "constant traction", "reference quality",
                                 "finite element trace"};
    return names[static_cast<int>(kind)];
  }

  /// The accuracy of the integrals: of GalerkinRule::estimating() where it is used.
  inline double accuracy(const BoundarySolution kind)
  {
    return kind == BoundarySolution::reference_quality || kind == BoundarySolution::finite_element_trace
               ? 1e-10
               : 1e-4;
  }

  inline CellErrors estimate(FiniteElementBody &body, const Indicator &indicator)
  {
    body.prepare();
    const Eigen::VectorXd forces = Eigen::VectorXd::Zero(body.trace_size());
    const Eigen::VectorXd deformation = body.deformation(forces, 0.);
    return indicator.estimate({body, deformation, forces});
  }
  inline CellErrors estimate(FiniteElementBody &body, const BoundarySolution kind)
  {
    return estimate(body, FEBEIndicator(kind));
  }

  /// Relative errors in the mean, at the comparison points, against a stress in the own frame that
  /// `turned_plate` turns.
  struct StressErrors
  {
    double boundary_elements, finite_elements;
  };
  using OwnStress = std::function<Eigen::Matrix2d(const Vector2 &own_point)>;
  inline StressErrors stress_errors(const FiniteElementBody &body, const Eigen::VectorXd &deformation,
                                    const CellErrors &errors, const OwnStress &exact)
  {
    const Placement &placement = body.description().placement;
    Eigen::Matrix2d turn;
    turn << placement.direction_to_world(Vector2::UnitX()), placement.direction_to_world(Vector2::UnitY());
    double square = 0., square_b = 0., square_f = 0.;
    auto next = errors.better.begin();
    visit_gradients(
        body.space(), sample_rule(body.space(), SamplePoints::comparison), deformation,
        [&](const Vector2 &point, const double weight, const Vector2 &, const Eigen::Matrix2d &gradient) {
          const Eigen::Matrix2d s = turn * exact(placement.point_to_own(point)) * turn.transpose();
          const Stress stress{s(0, 0), s(1, 1), s(0, 1), body.material().poisson_ratio * s.trace()};
          square += weight * stress.square();
          square_b += weight * (*next++ - stress).square();
          square_f += weight * (body.material().stress(gradient) - stress).square();
        });
    EXPECT_TRUE(next == errors.better.end());
    return {std::sqrt(square_b / square), std::sqrt(square_f / square)};
  }
} // namespace abut
