// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/adaptation/indicator.h>
#include <abut/base/counts.h>
#include <abut/base/warning.h>
#include <abut/bodies/body.h>
#include <abut/contact/contact_surface.h>
#include <abut/decomposition/scheme.h>
#include <abut/mesh/quality.h>
#include <abut/results/error_budget.h>
#include <abut/results/estimator_quality.h>
#include <abut/results/goal_record.h>
#include <abut/results/peaks.h>
#include <abut/results/point_result.h>
#include <abut/results/times.h>
#include <abut/scene/scene.h>
#include <abut/trace/pressure_curve.h>
#include <abut/trace/pressure_error.h>

#include <deal.II/base/exceptions.h>

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace abut
{
  /// What a summary says of the cells of a body.
  struct CellsSummary
  {
    unsigned int min_level = 0, max_level = 0; ///< how often they were split
    std::size_t n_at_glue = 0;                 ///< that have a glued edge

    void serialize(Archive &archive) { archive(min_level, max_level, n_at_glue); }
  };

  struct BodyResult
  {
    const Body *body = nullptr;
    Eigen::VectorXd displacement;    ///< all unknowns
    Eigen::VectorXd deformation;     ///< the same less the body's rigid motion: stresses come from this one
    Eigen::VectorXd contact_forces;  ///< a trace vector, in balance with the displacement
    Eigen::VectorXd estimate_forces; ///< a trace vector: those that the estimated error refers to
    double energy = 0.;              ///< strain energy
    BodyPeaks peaks;
    double condition = std::numeric_limits<double>::quiet_NaN(); ///< see Body::condition; where asked for
    BodyCounters counters;
    CellsSummary cells;
    unsigned int n_processes = 1;   ///< in which it lives
    unsigned int n_meshes = 1;      ///< processes that have its mesh at the end of the run
    double rigid_displacement = 0.; ///< of the side that carries a given resultant
    Reactions reactions;
    Eigen::VectorXd eta;        ///< of each cell, where estimated
    std::vector<Stress> better; ///< the estimator's better stress (CellErrors::better); may be empty

    /// All but the body, and what is known at the end of a run.
    void serialize(Archive &archive)
    {
      archive(displacement, deformation, contact_forces, estimate_forces, energy, rigid_displacement,
              reactions, eta, better);
    }
  };

  /// Vectors have an entry for every part of the surface, also of those that do not belong to the pair.
  struct PairResult
  {
    const ContactPair *pair = nullptr;
    const ContactSurface *surface = nullptr;
    std::vector<std::size_t> parts;              ///< of the pair, along the cut side
    Eigen::VectorXd gaps;                        ///< mean gap of every part, negative: penetration
    Eigen::VectorXd loads;                       ///< p_k >= 0, in balance with the displacement
    double round_off = 0.;                       ///< a load that is none, beside those of all pairs
    Eigen::VectorXd pressures;                   ///< as reported, at the parts' places (see PressureCurve)
    std::optional<PressureCurve> curve;          ///< the same between them
    std::optional<PressureError> pressure_error; ///< of the reported pressures; none with a penalty
    Vector2 force = Vector2::Zero();             ///< resultant on the slave side
    double normal_force = 0.;                    ///< sum of D_k p_k
    double max_pressure = 0.;                    ///< largest reported pressure
    double contact_length =
        0.; ///< sum of D_k over the parts with a load, or that penetrate, up to the ends that `curve` knows
    double max_penetration = 0.; ///< largest -g_k, 0 without contact
    double min_gap = 0.;         ///< smallest g_k
    NearestPoint nearest;        ///< smallest gap at a point
    Eigen::VectorXd sliding;     ///< mean of every part, see ContactPair::sliding
    double max_sliding = 0.;     ///< largest size over the parts that press
    /// The gaps and the sliding that the bodies' rigid motions alone make.
    Eigen::VectorXd rigid_gaps, rigid_sliding;
    /// Overlap far from any part that presses: contact smaller than a part.
    std::vector<MissedContact> missed;
    /// (arc length on the cut side, pressure) of the exact solution that the scene names, along the pair;
    /// empty where none is known.
    std::vector<Vector2> exact_pressures;

    const Part &part(const std::size_t k) const
    {
      AssertIndexRange(k, surface->partition().parts().size());
      return surface->partition().parts()[k];
    }
    bool presses(const std::size_t k) const
    {
      AssertIndexRange(k, static_cast<std::size_t>(loads.size()));
      return loads[static_cast<Eigen::Index>(k)] > round_off;
    }
  };

  /// Relative errors against the exact solution that the scene names.
  struct TrueErrors
  {
    std::optional<double> energy, stress, pressure, force;

    void serialize(Archive &archive) { archive(energy, stress, pressure, force); }
  };

  /// How far the displacement stands from the limit of the iteration, where that limit is known.
  struct LimitDistance
  {
    double displacement = 0.;  ///< contact displacement, largest over the bodies, relative, discrete norm
    double energy = 0.;        ///< energy norm, relative
    double peak_pressure = 0.; ///< the limit's largest load p_k, for comparison
  };

  /// What one pass, a mesh with its solution, has found. Errors are relative.
  struct PassRecord
  {
    unsigned int pass = 0;
    Counts counts;                                               ///< of all bodies
    unsigned int steps = 0;                                      ///< of the decomposition in this pass
    double increment = std::numeric_limits<double>::quiet_NaN(); ///< of the last of them
    double iteration = std::numeric_limits<double>::quiet_NaN(); ///< see SchemeResult::iteration_error
    std::optional<double> eta_max; ///< over the cells of the adapted bodies (of all, where none adapts)
    std::optional<double> discretisation; ///< estimated, energy norm
    std::optional<double> stress;         ///< the same in L2 over xx, yy, zz and twice xy
    std::optional<double> pressure; ///< of the reported pressures, L2 over all contacts, see PressureError
    std::optional<double> total;    ///< root of the squares of discretisation and iteration; with fe-be
                                    ///< the bound of both together (Estimation::bound)
    std::optional<GoalRecord> goal; ///< where the scene has a goal of its own
    ErrorBudget budget;             ///< what the error is made of
    std::optional<double> staying;  ///< the part of the estimated error in bodies that do not adapt
    bool is_certified = false;      ///< by boundary elements, in all bodies
    std::string estimator;          ///< whose word the estimate is: fe-be, kelly, ...
    std::string estimate_reason;    ///< why `total` is an estimate and no bound; empty where it is one
    TrueErrors true_errors;
    std::optional<EstimatorQuality> quality; ///< of the indicator, where sigma* is known
    std::optional<double> effectivity_total; ///< total by true_errors.energy
    /// Energy norm of the difference from the solution of the pass before, by that of the solution.
    std::optional<double> change;
    double strain_energy = 0.;                   ///< of all bodies
    double normal_force = 0., max_pressure = 0.; ///< sum and largest over the pairs
    std::size_t n_missed = 0;                    ///< pieces of missed contact
    std::vector<MeshQuality> meshes;             ///< body by body
    PassCost cost;
    double seconds =
        0.; ///< since the run began, without comparing with the exact solution and showing passes

    /// What has to be below the tolerance: the bound, or the estimate with what it has been too small by.
    /// Infinite where nothing is estimated.
    double error_for_tolerance() const
    {
      constexpr double safety = 1.25;
      if (goal)
        return goal->total().value_or(std::numeric_limits<double>::infinity());
      if (!total || (!is_certified && !change)) // a mesh that compares with itself may be blind
        return std::numeric_limits<double>::infinity();
      return error_is_bound() ? *total : safety * *total;
    }
    bool error_is_bound() const { return total && estimate_reason.empty(); }
    /// Estimated stress error by that against sigma*.
    std::optional<double> effectivity() const
    {
      return quality ? std::optional<double>(quality->whole.effectivity()) : std::nullopt;
    }

    void serialize(Archive &archive)
    {
      archive(pass, counts, steps, increment, iteration, eta_max, discretisation, stress, pressure, total,
              goal, budget, staying, is_certified, estimator, estimate_reason, true_errors, quality,
              effectivity_total, change, strain_energy, normal_force, max_pressure, n_missed, meshes, cost,
              seconds);
    }
  };

  /// Why no further mesh was made, in a scene that adapts.
  struct AdaptationEnd
  {
    std::string stopped_by; ///< limit, maximum passes, ...
    std::string message;    ///< one sentence with cause and way out; empty when what was asked for is reached
  };

  /// The solution on one mesh: what the interface problem's means for bodies and pairs.
  struct Solution
  {
    std::vector<BodyResult> bodies; ///< in the scene's order
    std::vector<PairResult> pairs;  ///< likewise
    SchemeResult iteration;
    double rigid_displacement = 0.; ///< scheme neumann: of the one side that carries a given resultant
    bool compliance_is_dense = false;
  };

  /// Everything a run has found, for those who write it down: the last pass's solution, and how it came.
  struct Results : Solution
  {
    const Scene *scene = nullptr;
    std::vector<PassRecord> passes;
    std::optional<AdaptationEnd> adaptation_end;
    std::optional<LimitDistance> limit_distance;
    TrueErrors true_errors;
    std::vector<PointResult> points; ///< where the scene asks for them
    Times times;
    unsigned int n_processes = 1;
    std::vector<Warning> warnings;
    std::vector<std::string> left_out; ///< what this scene did not need

    bool converged() const
    {
      return iteration.converged() && (!adaptation_end || adaptation_end->message.empty());
    }
    /// Cause and way out where the run has not reached what it was asked for.
    const std::string &message() const
    {
      return iteration.converged() && adaptation_end ? adaptation_end->message : iteration.message;
    }
    /// Decomposition steps of all passes.
    unsigned int steps() const
    {
      unsigned int sum = 0;
      for (const PassRecord &pass : passes)
        sum += pass.steps;
      return sum;
    }
  };
} // namespace abut
