// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/adaptation/better_stress.h>
#include <abut/adaptation/fe_be.h>
#include <abut/base/stopwatch.h>
#include <abut/base/user_error.h>

namespace abut
{
  namespace
  {
    const std::string asked = "Adaptation/Estimator = fe-be";

    /// Of the stress, relative, before it is known.
    constexpr double expected_error = 1e-3;
  } // namespace

  std::shared_ptr<const BoundaryModels> FEBEIndicator::model_of(const Body &body, BoundaryCost &cost) const
  {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      const auto found = kept_.find(&body);
      if (found != kept_.end() && found->second.mesh == body.mesh_version())
        return found->second.model;
      kept_.erase(&body);
    }
    ++cost.models;
    std::shared_ptr<const BoundaryModels> model;
    {
      const Stopwatch watch(cost.assemble);
      model = std::make_shared<const BoundaryModels>(as_finite_elements(body, asked), kind_, accuracy_);
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    kept_[&body] = {body.mesh_version(), model};
    return model;
  }

  CellErrors FEBEIndicator::estimate(const BodySolution &solution) const
  {
    BoundaryCost cost;
    const auto model = model_of(solution.body, cost);
    cost.elements = model->n_elements();
    cost.unknowns = model->n_unknowns();
    std::vector<SamplePoint> points, at_corners;
    solution.body.visit_stress(solution.deformation, SamplePoints::comparison,
                               [&](const SamplePoint &point, const Stress &) { points.push_back(point); });
    solution.body.visit_corner_stress(
        solution.deformation, [&](const SamplePoint &point, const Stress &) { at_corners.push_back(point); });
    const std::size_t n = points.size();
    points.insert(points.end(), at_corners.begin(), at_corners.end());
    const auto errors_with = [&](const double tolerance) {
      std::vector<Stress> better = model->stress(solution, points, tolerance, cost);
      const std::vector<Stress> better_at_corners(better.begin() + static_cast<std::ptrdiff_t>(n),
                                                  better.end());
      better.resize(n);
      CellErrors errors = compare(solution, better);
      if (!better_at_corners.empty())
        compare_at_corners(solution, better_at_corners, errors);
      return errors;
    };
    CellErrors errors = errors_with(accuracy_.tolerance(expected_error));
    const double found_error = errors.stress.norm() / errors.stress_norm;
    if (model->is_fast() && found_error < expected_error)
      errors = errors_with(accuracy_.tolerance(found_error));
    errors.boundary = cost;
    return errors;
  }

  void FEBEIndicator::check(const Body &body) const
  {
    if (body.description().has_inner_interfaces())
      throw UserError(
          "Body " + body.name() + ": it has Regions of other materials; " + asked +
          " is for bodies whose materials do not share nodes, allowed are kelly, zz, spr, or glued parts");
    check_boundary_elements(as_finite_elements(body, asked));
  }

  namespace
  {
    EstimatorEntry fe_be_entry()
    {
      EstimatorEntry entry{"fe-be", "against boundary elements on the edges of the mesh, which get the same "
                                    "data (the paper); bodies whose cells have straight edges (degree 1 on "
                                    "curved shapes), uniform body forces, no forces at points"};
      entry.make = [](const AdaptationParameters &parameters) -> std::unique_ptr<Indicator> {
        return std::make_unique<FEBEIndicator>(parameters.boundary_solution,
                                               BoundaryAccuracy{parameters.boundary_accuracy});
      };
      entry.has_boundary_elements = true;
      return entry;
    }

    const Registered<EstimatorEntry> registered_fe_be(fe_be_entry());
  } // namespace
} // namespace abut
