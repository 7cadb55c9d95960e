// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/study/observed_run.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    std::size_t body_of_interest(const Scene &scene)
    {
      for (std::size_t a = scene.bodies.size(); a-- > 0;)
        if (scene.bodies[a].adapt)
          return a;
      return scene.bodies.size() - 1;
    }

    Polyline sorted_by_x(Polyline points)
    {
      std::sort(points.begin(), points.end(),
                [](const Vector2 &a, const Vector2 &b) { return a.x() < b.x(); });
      return points;
    }

    Polyline contact_displacement(const PassState &state, const std::size_t body)
    {
      const Eigen::VectorXd values =
          state.problem.normal_displacements(state.results.iteration.iterate, body);
      Polyline points;
      Eigen::Index node = 0;
      for (const Trace &side : state.results.bodies[body].body->contact_sides())
        for (const Vector2 &point : side.node_points())
          points.emplace_back(point.x(), values[node++]);
      return sorted_by_x(std::move(points));
    }

    Polyline pressure_curve(const PairResult &pair)
    {
      Polyline points;
      for (const std::size_t k : pair.parts)
        points.emplace_back(pair.part(k).place.x(), pair.pressures[static_cast<Eigen::Index>(k)]);
      return sorted_by_x(std::move(points));
    }

    std::vector<unsigned int> levels_of(const Body &body)
    {
      std::vector<unsigned int> levels;
      for (const CellInfo &cell : body.cells())
        levels.push_back(cell.level);
      return levels;
    }

    std::size_t boundary_unknowns(const Estimation &estimation, const std::size_t body)
    {
      return body < estimation.errors.size()
                 ? static_cast<std::size_t>(estimation.errors[body].boundary.unknowns)
                 : 0;
    }

    ObservedPass observe_pass(const PassState &state, const std::size_t body, const Vector2 &monitored)
    {
      const BodyResult &result = state.results.bodies[body];
      ObservedPass pass;
      pass.record = state.results.passes.back();
      pass.estimate_seconds = pass.record.cost.estimate;
      pass.counts = result.body->counts();
      pass.boundary_unknowns = boundary_unknowns(state.estimation, body);
      if (body < state.estimation.errors.size())
        pass.boundary_elements = static_cast<std::size_t>(state.estimation.errors[body].boundary.elements);
      pass.all_unknowns = pass.record.counts.dofs;
      for (std::size_t a = 0; a < state.results.bodies.size(); ++a)
        pass.all_unknowns += boundary_unknowns(state.estimation, a);
      pass.drawing = undeformed_body(result);
      pass.levels = levels_of(*result.body);
      pass.contact_displacement = contact_displacement(state, body);
      if (!state.results.pairs.empty())
        pass.pressure = pressure_curve(state.results.pairs.front());
      pass.monitored = result.body->displacement_at(result.displacement, monitored);
      return pass;
    }
  } // namespace

  ObservedRun observe_run(const Scene &scene, const Vector2 &monitored)
  {
    ObservedRun run;
    run.adaptation = scene.adaptation;
    run.body = body_of_interest(scene);
    Simulation simulation(scene);
    RunObserver observer;
    observer.state = [&](const PassState &state) {
      run.passes.push_back(observe_pass(state, run.body, monitored));
    };
    run.converged = simulation.run(observer).converged();
    return run;
  }
} // namespace abut
