// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/executor.h>
#include <abut/base/user_error.h>
#include <abut/run/evaluate.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    BodyResult body_result(const Body &body, const Eigen::VectorXd &contact_forces,
                           const double rigid_displacement, const Eigen::VectorXd &amplitudes)
    {
      BodyResult result;
      result.contact_forces = result.estimate_forces = contact_forces;
      result.rigid_displacement = rigid_displacement;
      if (amplitudes.size() > 0)
        result.rigid_displacement = body.rigid_side_displacement(amplitudes);
      result.deformation = body.deformation(contact_forces, result.rigid_displacement);
      result.displacement = result.deformation + body.rigid_motion(result.rigid_displacement);
      if (amplitudes.size() > 0)
        result.displacement += body.free_motion(amplitudes);
      result.energy = body.strain_energy(result.deformation);
      result.reactions = body.reactions(result.deformation, contact_forces);
      return result;
    }

    /// Pressures and forces of all parts.
    void add_loads(const ContactPair &pair, PairResult &result)
    {
      result.curve.emplace(result.surface->partition(), result.loads, pair.penalty() == 0.);
      result.pressures = result.curve->at_places();
      if (pair.penalty() == 0.)
        result.pressure_error = pressure_error(result.surface->partition(), result.loads, result.pressures);
      const Eigen::VectorXd forces = pair.slave_coupling().transpose() * result.loads;
      for (Index i = 0; i < forces.size(); i += 2)
        result.force += forces.segment<2>(i);
      result.normal_force = pair.weights().dot(result.loads);
    }

    /// Which parts are those of the pair, and what they tell; returns which press.
    std::vector<bool> add_parts(const ContactPair &pair, PairResult &result)
    {
      result.min_gap = std::numeric_limits<double>::infinity();
      std::vector<bool> pressed(static_cast<std::size_t>(result.loads.size()));
      for (std::size_t k = 0; k < pressed.size(); ++k)
      {
        const auto i = static_cast<Index>(k);
        pressed[k] = result.loads[i] > 0. || (pair.penalty() > 0. && result.gaps[i] < 0.);
        if (!(pair.weights()[i] > 0.))
          continue;
        result.parts.push_back(k);
        result.max_pressure = std::max(result.max_pressure, result.pressures[i]);
        result.contact_length += pressed[k] ? pair.weights()[i] : 0.;
        result.min_gap = std::min(result.min_gap, result.gaps[i]);
      }
      for (const ContactEnd &end : result.curve->ends())
        if (pair.weights()[static_cast<Index>(end.parts.front())] > 0.)
          result.contact_length += end.beyond;
      result.max_penetration = std::max(0., -result.min_gap);
      return pressed;
    }

    /// What the bodies' rigid motions make of the gap.
    void add_rigid_motion(const ContactPair &pair, const std::vector<BodyResult> &bodies, PairResult &result)
    {
      const auto motion = [&](const ContactBody &side) -> Eigen::VectorXd {
        const BodyResult &body = bodies[side.body];
        return body.body->of_side(body.body->trace_of(body.displacement - body.deformation), side.side);
      };
      const Eigen::VectorXd of_cut = motion(pair.cut_side()), of_other = motion(pair.other_side());
      result.rigid_gaps = pair.mean_gaps(of_cut, of_other);
      result.rigid_sliding = pair.sliding(of_cut, of_other);
    }

    /// What the sides' displacements make of the gap.
    void add_motion(const ContactPair &pair, const std::vector<bool> &pressed,
                    const std::vector<BodyResult> &bodies, PairResult &result)
    {
      const auto displacement = [&](const ContactBody &side) -> Eigen::VectorXd {
        const BodyResult &body = bodies[side.body];
        return body.body->of_side(body.body->trace_of(body.displacement), side.side);
      };
      const Eigen::VectorXd of_cut = displacement(pair.cut_side()),
                            of_other = displacement(pair.other_side());
      result.missed = pair.missed_contact(result.surface->near_contact(pressed), of_cut, of_other);
      result.nearest = pair.nearest(of_cut, of_other);
      result.sliding = pair.sliding(of_cut, of_other);
      for (const std::size_t k : result.parts)
        if (result.presses(k))
          result.max_sliding = std::max(result.max_sliding, std::abs(result.sliding[static_cast<Index>(k)]));
    }
  } // namespace

  std::vector<BodyResult> body_results(const Model &model, const SchemeResult &iteration,
                                       const double rigid_displacement, const InterfaceMotions *const motions)
  {
    AssertDimension(iteration.traction.size(), model.problem().n_pressures());
    AssertDimension(iteration.motions.size(), motions == nullptr ? 0 : motions->size());
    std::vector<BodyResult> results =
        model.executor().of_bodies(model.bodies().size(), [&](const std::size_t a) {
          return body_result(*model.bodies()[a], model.problem().contact_forces(a, iteration.traction),
                             rigid_displacement,
                             motions == nullptr ? Eigen::VectorXd() : motions->of_body(iteration.motions, a));
        });
    for (std::size_t a = 0; a < results.size(); ++a)
      results[a].body = model.bodies()[a].get();
    return results;
  }

  std::vector<PairResult> pair_results(const Model &model, const SchemeResult &iteration,
                                       const std::vector<BodyResult> &bodies)
  {
    const InterfaceProblem &problem = model.problem();
    AssertDimension(bodies.size(), model.bodies().size());
    AssertDimension(iteration.response.size(), problem.response_size());
    std::vector<PairResult> results;
    for (std::size_t i = 0; i < model.pairs().size(); ++i)
    {
      const ContactPair &pair = *model.pairs()[i];
      const std::size_t surface = model.surface_of(i);
      PairResult result;
      result.pair = &pair;
      result.surface = &model.surfaces()[surface];
      result.gaps = problem.of_surface(surface, problem.gaps(iteration.response));
      result.loads = problem.of_surface(surface, iteration.traction);
      result.round_off = 1e-12 * iteration.traction.cwiseAbs().maxCoeff();
      add_loads(pair, result);
      add_motion(pair, add_parts(pair, result), bodies, result);
      add_rigid_motion(pair, bodies, result);
      results.push_back(std::move(result));
    }
    return results;
  }

  namespace
  {
    struct FinalValues
    {
      BodyPeaks peaks;
      double condition = std::numeric_limits<double>::quiet_NaN();
      BodyCounters counters;
      CellsSummary cells;

      void serialize(Archive &archive) { archive(peaks, condition, counters, cells); }
    };

    CellsSummary summary_of(const std::vector<CellInfo> &cells)
    {
      CellsSummary summary;
      if (!cells.empty())
        summary.min_level = cells.front().level;
      for (const CellInfo &cell : cells)
      {
        summary.min_level = std::min(summary.min_level, cell.level);
        summary.max_level = std::max(summary.max_level, cell.level);
        if (cell.at_glue)
          ++summary.n_at_glue;
      }
      return summary;
    }

    FinalValues final_values(const BodyResult &result, const bool tells_condition)
    {
      const Body &body = *result.body;
      FinalValues values;
      values.peaks = find_peaks(body, result.displacement, result.deformation, body.singular_vertices());
      if (!std::isfinite(result.energy) || !std::isfinite(values.peaks.von_mises.value))
        throw ComputationError(
            "Body " + body.name() +
            ": energy or stresses have left the range of the machine's numbers; change the units");
      if (tells_condition)
        values.condition = body.condition();
      values.counters = body.counters();
      values.cells = summary_of(body.cells());
      return values;
    }
  } // namespace

  void add_final_values(const Executor &executor, const bool tells_condition, std::vector<BodyResult> &bodies)
  {
    const std::vector<FinalValues> values = executor.of_bodies(
        bodies.size(), [&](const std::size_t a) { return final_values(bodies[a], tells_condition); });
    for (std::size_t a = 0; a < bodies.size(); ++a)
    {
      bodies[a].peaks = values[a].peaks;
      bodies[a].condition = values[a].condition;
      bodies[a].counters = values[a].counters;
      bodies[a].cells = values[a].cells;
      bodies[a].n_processes = executor.n_processes_of(a);
    }
  }
} // namespace abut
