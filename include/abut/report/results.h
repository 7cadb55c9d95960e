// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/contact/contact_pair.h>
#include <abut/decomposition/scheme.h>
#include <abut/elasticity/body.h>
#include <abut/scene/scene.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace abut
{
  /// Wall-clock seconds by task.
  struct Times
  {
    double mesh = 0., assemble = 0., factorise = 0., solve = 0., interface = 0., output = 0.;
  };

  struct BodyResult
  {
    const Body *body = nullptr;
    Eigen::VectorXd displacement; ///< all unknowns
    Eigen::VectorXd deformation;  ///< the same less the body's rigid motion: stresses come from this one
    double energy = 0.;           ///< strain energy
    double max_von_mises = 0.;    ///< over the Gauss points
    Reactions reactions;
  };

  struct PairResult
  {
    const ContactPair *pair = nullptr;
    const Trace *slave = nullptr;
    Eigen::VectorXd
        gaps; ///< weighted gap of every slave node, negative: penetration; infinite where nothing faces it
    Eigen::VectorXd pressures;       ///< of every slave node, >= 0, in balance with the displacement
    Vector2 force = Vector2::Zero(); ///< resultant on the slave side
    double normal_force = 0.;        ///< sum of D_i p_i
    double max_pressure = 0.;
    double contact_length = 0.;  ///< sum of D_i over the nodes with a negative gap
    double max_penetration = 0.; ///< largest -g_i, 0 without contact
    double min_gap = 0.;         ///< smallest g_i
  };

  /// Relative errors against the exact solution that the scene names.
  struct TrueErrors
  {
    std::optional<double> energy, stress, pressure, force;
  };

  /// How far the displacement stands from the limit of the iteration, where that limit is known.
  struct LimitDistance
  {
    double displacement = 0.;  ///< contact displacement, largest over the bodies, relative, discrete norm
    double energy = 0.;        ///< energy norm, relative
    double peak_pressure = 0.; ///< the limit's, for comparison
  };

  /// Everything a run has found, for those who write it down.
  struct Results
  {
    const Scene *scene = nullptr;
    std::vector<BodyResult> bodies;
    std::vector<PairResult> pairs;
    SchemeResult iteration;
    std::optional<LimitDistance> limit_distance;
    double rigid_displacement = 0.; ///< of the side that carries a given resultant
    bool compliance_is_dense = false;
    TrueErrors true_errors;
    Times times;
    std::vector<std::string> left_out; ///< what this scene did not need
  };
} // namespace abut
