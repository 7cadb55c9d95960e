// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/adaptation/better_stress.h>
#include <abut/adaptation/fe_be.h>
#include <abut/base/stopwatch.h>
#include <abut/base/user_error.h>

#include <cmath>

namespace abut
{
  namespace
  {
    const std::string asked = "Adaptation/Estimator = fe-be";

    /// Of the stress, relative, before it is known: half of that where the stress varies over the size of the
    /// body, some .6 n^(-p/2) with n cells of degree p. It is seldom less, and more where the stress is
    /// singular.
    double expected_error(const FiniteElementBody &body)
    {
      return .3 * std::pow(body.counts().cells, -.5 * body.space().degree());
    }
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
    const OwnStress own = own_stress(solution), own_at_corners = own_stress_at_corners(solution);
    std::vector<SamplePoint> points = own.points;
    points.insert(points.end(), own_at_corners.points.begin(), own_at_corners.points.end());
    const auto errors_with = [&](const double tolerance) {
      std::vector<Stress> better = model->stress(solution, points, tolerance, cost);
      const auto corners = better.begin() + static_cast<std::ptrdiff_t>(own.points.size());
      const std::vector<Stress> better_at_corners(corners, better.end());
      better.erase(corners, better.end());
      CellErrors errors = compare(solution.body, own, better);
      compare_at_corners(solution.body, own_at_corners, better_at_corners, errors);
      return errors;
    };
    const double expected = expected_error(as_finite_elements(solution.body, asked));
    CellErrors errors = errors_with(accuracy_.tolerance(expected));
    const double found_error = errors.stress.norm() / errors.stress_norm;
    if (model->is_fast() && found_error < expected)
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
      entry.takes_distributed_meshes = true;
      return entry;
    }

    const Registered<EstimatorEntry> registered_fe_be(fe_be_entry());
  } // namespace
} // namespace abut
