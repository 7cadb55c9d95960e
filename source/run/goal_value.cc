// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/run/goal_value.h>

#include <algorithm>
#include <cmath>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    const PairResult &pair_with_peak(const std::vector<PairResult> &pairs)
    {
      return *std::max_element(pairs.begin(), pairs.end(), [](const PairResult &a, const PairResult &b) {
        return a.max_pressure < b.max_pressure;
      });
    }

    /// The part with the largest reported pressure.
    std::size_t peak_part(const PairResult &pair)
    {
      return *std::max_element(
          pair.parts.begin(), pair.parts.end(), [&](const std::size_t k, const std::size_t l) {
            return pair.pressures[static_cast<Index>(k)] < pair.pressures[static_cast<Index>(l)];
          });
    }

    double stress_at(const Vector2 &point, const std::vector<BodyResult> &bodies, const Executor &executor)
    {
      for (const auto &stress : executor.of_bodies(bodies.size(), [&](const std::size_t a) {
             return bodies[a].body->stress_at(bodies[a].deformation, point);
           }))
        if (stress)
          return stress->von_mises();
      throw ComputationError("Goal: the point of the stress is in no body any more");
    }

    double value_of(const Goal &goal, const Solution &solution, const Executor &executor)
    {
      double force = 0.;
      switch (goal.kind)
      {
      case Goal::Kind::force:
        for (const PairResult &pair : solution.pairs)
          force += pair.normal_force;
        return force;
      case Goal::Kind::peak_pressure:
        return pair_with_peak(solution.pairs).max_pressure;
      case Goal::Kind::stress:
        return stress_at(goal.point, solution.bodies, executor);
      case Goal::Kind::energy:
        break;
      }
      throw dealii::ExcInternalError();
    }

    double relative_change(const double value, const double before)
    {
      return value == before ? 0. : std::abs(value - before) / std::max(std::abs(value), std::abs(before));
    }

    std::optional<double> by_changes(double value, const std::vector<PassRecord> &before)
    {
      if (before.size() < 2)
        return {};
      constexpr double safety = 1.5;
      double largest = 0., weight = 1.;
      for (auto pass = before.rbegin(); pass != before.rend() && weight > .2; ++pass, weight *= .5)
      {
        largest = std::max(largest, weight * relative_change(value, pass->goal->value));
        value = pass->goal->value;
      }
      return safety * largest;
    }

    /// What a penalty changes of the pressure at the peak.
    double change_at_peak(const Setup &setup, const Solution &solution, const Eigen::VectorXd &pressures)
    {
      const PairResult &pair = pair_with_peak(solution.pairs);
      const auto number = static_cast<std::size_t>(&pair - solution.pairs.data());
      return std::abs(setup.model.problem().of_surface(setup.model.surface_of(number),
                                                       pressures)[static_cast<Index>(peak_part(pair))]);
    }

    /// By value; nothing where there is none.
    std::optional<double> by_value(const double change, const double value)
    {
      return value > 0. ? std::optional<double>(change / value) : std::nullopt;
    }
  } // namespace

  void check_goal(const Scene &scene, const Model &model)
  {
    if (scene.goal.is_energy())
      return;
    if (scene.goal.kind != Goal::Kind::stress)
    {
      if (model.pairs().empty())
        throw UserError("Goal: received `" + scene.goal.text() +
                        "` in a scene without contacts; allowed are energy "
                        "and stress at (x, y)");
      return;
    }
    std::vector<std::string> with_it;
    const auto cells = model.executor().of_bodies(model.bodies().size(), [&](const std::size_t a) {
      return model.bodies()[a]->cells_at(scene.goal.point);
    });
    for (std::size_t a = 0; a < cells.size(); ++a)
      if (!cells[a].empty())
        with_it.push_back(model.bodies()[a]->name());
    if (with_it.empty())
      throw UserError("Goal: received `" + scene.goal.text() + "`, but no elastic body has this point");
    if (with_it.size() > 1)
      throw UserError("Goal: received `" + scene.goal.text() + "`, but the bodies " + with_it[0] + " and " +
                      with_it[1] +
                      " both have this point, with stresses of their own; name one inside a body");
  }

  GoalRecord goal_record(const Setup &setup, const Solution &solution,
                         const std::optional<PenaltyChange> &penalty, const std::vector<PassRecord> &before)
  {
    const Goal &goal = setup.scene.goal;
    GoalRecord record;
    record.value = value_of(goal, solution, setup.model.executor());
    record.discretisation = by_changes(record.value, before);
    if (penalty && goal.kind == Goal::Kind::force)
      record.penalty = by_value(penalty->force, record.value);
    if (penalty && goal.kind == Goal::Kind::peak_pressure)
      record.penalty = by_value(change_at_peak(setup, solution, penalty->pressures), record.value);
    return record;
  }

  void mark_goal(const Scene &scene, const Solution &solution, const Executor &executor,
                 std::vector<CellMarks> &marks)
  {
    const auto mark = [&](const std::size_t body, const unsigned int cell) {
      if (scene.bodies[body].adapt)
        marks[body].refine[cell] = true;
    };
    if (scene.goal.kind == Goal::Kind::stress)
    {
      const auto cells = executor.of_bodies(solution.bodies.size(), [&](const std::size_t a) {
        return solution.bodies[a].body->cells_at(scene.goal.point);
      });
      for (std::size_t a = 0; a < cells.size(); ++a)
        for (const unsigned int cell : cells[a])
          mark(a, cell);
    }
    if (scene.goal.kind != Goal::Kind::peak_pressure)
      return;
    const PairResult &pair = pair_with_peak(solution.pairs);
    const std::size_t peak = peak_part(pair);
    for (const Piece &piece : pair.surface->partition().pieces())
      if (piece.part == peak && piece.link == pair.pair->link())
        for (const auto &[side, segment] : {std::pair(&pair.pair->cut_side(), piece.cut_segment),
                                            std::pair(&pair.pair->other_side(), piece.other_segment)})
          mark(side->body, side->trace->segments()[segment].cell);
  }
} // namespace abut
