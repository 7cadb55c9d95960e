// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/adaptation/better_stress.h>
#include <abut/adaptation/fe_be.h>

#include <chrono>

namespace abut
{
  namespace
  {
    std::vector<Vector2> comparison_points(const Space &space)
    {
      dealii::FEValues<2> values(space.mapping(), space.dof_handler().get_fe(), comparison_rule(space),
                                 dealii::update_quadrature_points);
      std::vector<Vector2> points;
      for (const auto &cell : space.dof_handler().active_cell_iterators())
      {
        values.reinit(cell);
        for (const auto &p : values.get_quadrature_points())
          points.emplace_back(p[0], p[1]);
      }
      return points;
    }
  } // namespace

  std::shared_ptr<const BoundaryModel> FEBEIndicator::model_of(const Body &body, BoundaryCost &cost) const
  {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      const auto found = kept_.find(&body);
      if (found != kept_.end() && found->second.mesh == body.counters().meshes)
        return found->second.model;
      kept_.erase(&body);
    }
    ++cost.models;
    const auto start = std::chrono::steady_clock::now();
    auto model = std::make_shared<const BoundaryModel>(body, kind_);
    cost.assemble = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const std::lock_guard<std::mutex> lock(mutex_);
    kept_[&body] = {body.counters().meshes, model};
    return model;
  }

  CellErrors FEBEIndicator::estimate(const BodySolution &solution) const
  {
    BoundaryCost cost;
    const auto model = model_of(solution.body, cost);
    cost.elements = model->space().n_elements();
    cost.unknowns = model->n_unknowns();
    const std::vector<Stress> stresses =
        model->stress(solution, comparison_points(solution.body.space()), cost);
    auto next = stresses.begin();
    CellErrors errors =
        compare(solution, [&](const Cell &, const dealii::FEValues<2> &, std::vector<Stress> &stress) {
          for (Stress &s : stress)
            s = *next++;
        });
    errors.boundary = cost;
    return errors;
  }
} // namespace abut
