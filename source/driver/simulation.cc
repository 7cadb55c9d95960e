// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/contact/elastic_layer.h>
#include <abut/decomposition/resultant_loading.h>
#include <abut/driver/simulation.h>
#include <abut/driver/true_errors.h>
#include <abut/user_error.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;
    using Clock = std::chrono::steady_clock;

    /// Adds the time until its end of life to a number of seconds.
    class Stopwatch
    {
    public:
      explicit Stopwatch(double &seconds) : seconds_(seconds) {}
      ~Stopwatch() { seconds_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
      Stopwatch(const Stopwatch &) = delete;
      Stopwatch &operator=(const Stopwatch &) = delete;

    private:
      double &seconds_;
      Clock::time_point start_ = Clock::now();
    };

    std::vector<std::string> contact_sides(const Scene &scene, const std::string &body)
    {
      std::vector<std::string> sides;
      for (const ContactDescription &contact : scene.contacts)
        for (const Side &side : {contact.slave, contact.master})
          if (side.body == body && std::find(sides.begin(), sides.end(), side.boundary) == sides.end())
            sides.push_back(side.boundary);
      return sides;
    }

    ContactBody contact_body(const Scene &scene, const std::vector<std::unique_ptr<Body>> &bodies,
                             const Side &side)
    {
      const std::size_t index = scene.body_index(side.body);
      const std::vector<std::string> sides = contact_sides(scene, side.body);
      const auto position =
          static_cast<std::size_t>(std::find(sides.begin(), sides.end(), side.boundary) - sides.begin());
      const Body &body = *bodies[index];
      const double depth = body.contact_depth(position);
      return {index, position, depth, depth / body.material().young_modulus,
              layer_compliance(body.material(), depth)};
    }

  } // namespace

  Simulation::Simulation(const Scene &scene) : scene_(scene)
  {
    const Stopwatch watch(mesh_time_);
    use_one_blas_thread();
    if (scene.reference.solution == ReferenceParameters::Solution::layers_sliding)
      reference_.emplace(scene);
    make_bodies();
    make_pairs();
  }

  void Simulation::make_bodies()
  {
    bodies_.resize(scene_.bodies.size());
    for (std::size_t a = 0; a < bodies_.size(); ++a)
      bodies_[a] = std::make_unique<Body>(scene_.bodies[a], contact_sides(scene_, scene_.bodies[a].name));
  }

  void Simulation::make_pairs()
  {
    for (const ContactDescription &contact : scene_.contacts)
    {
      const ContactBody slave = contact_body(scene_, bodies_, contact.slave);
      const ContactBody master = contact_body(scene_, bodies_, contact.master);
      pairs_.emplace_back(contact, scene_.bodies[slave.body].placement, slave, master,
                          bodies_[slave.body]->contact_sides()[slave.side],
                          bodies_[master.body]->contact_sides()[master.side]);
    }
  }

  Counts Simulation::counts() const
  {
    Counts sum;
    for (const auto &body : bodies_)
      sum = sum + count(body->space());
    return sum;
  }

  void Simulation::check_supports() const
  {
    for (const auto &body : bodies_)
    {
      if (body->free_rigid_motions().empty())
        continue;
      std::string motions;
      for (const std::string &motion : body->free_rigid_motions())
        motions += (motions.empty() ? "" : ", ") + motion;
      if (body->contact_sides().empty())
        throw UserError("Body " + body->name() + " is held by nothing against " + motions +
                        ": give it supports in Body " + body->name() +
                        "/Conditions (a displacement condition on a side or at a point)");
      throw UserError("Body " + body->name() + " is held by contact alone against " + motions +
                      ": this version needs supports on every body; add a displacement condition to Body " +
                      body->name() + "/Conditions");
    }
  }

  void Simulation::prepare(Times &times)
  {
    std::vector<Body::PreparationTimes> of_body(bodies_.size());
    for_each_body(bodies_.size(), [&](const std::size_t a) { of_body[a] = bodies_[a]->prepare(); });
    for (const Body::PreparationTimes &t : of_body) // side by side: the longest counts
    {
      times.assemble = std::max(times.assemble, t.assemble);
      times.factorise = std::max(times.factorise, t.factorise);
    }
  }

  const Body *Simulation::resultant_body() const
  {
    for (const auto &body : bodies_)
      if (body->resultant())
        return body.get();
    return nullptr;
  }

  SchemeResult Simulation::solve_interface(const InterfaceProblem &problem, const InterfaceSolver &solver,
                                           const StepObserver &observer, Results &results) const
  {
    std::optional<Eigen::VectorXd> start;
    SchemeResult result;
    double &delta = results.rigid_displacement;
    const auto solve = [&] {
      const unsigned int steps_before =
          result.steps; // a given force takes several solutions: one count for all
      result = solver.solve(problem.loads(delta), start, [&](StepRecord record) {
        record.step += steps_before;
        if (observer)
          observer(record);
      });
      result.steps += steps_before;
      if (result.converged())
        start = result.traction;
    };
    const Body *const pressed = resultant_body();
    if (pressed == nullptr)
    {
      solve();
      return result;
    }
    const std::size_t index = scene_.body_index(pressed->name());
    const auto force = [&](const double displacement) {
      delta = displacement;
      solve();
      if (!result.converged())
        throw ComputationError(result.message);
      const Eigen::VectorXd contact = problem.contact_forces(index, result.traction);
      return pressed->rigid_side_force(pressed->deformation(contact, delta), contact);
    };
    double guess = std::abs(pressed->resultant()->force) / pressed->material().young_modulus;
    for (const ContactPair &pair : pairs_)
      guess += std::max(1e-6 * pair.slave().depth, pair.coupling().smallest_gap);
    delta = find_rigid_displacement(force, pressed->resultant()->force, guess,
                                    std::max(10. * scene_.decomposition.tolerance, 1e-10),
                                    "Body " + pressed->name() + ", side " + pressed->resultant()->boundary);
    return result;
  }

  Results Simulation::run(const StepObserver &observer)
  {
    check_supports();
    Results results;
    results.scene = &scene_;
    results.times.mesh = mesh_time_;
    prepare(results.times);

    std::vector<const TraceBody *> trace_bodies;
    for (const auto &body : bodies_)
      trace_bodies.push_back(body.get());
    const InterfaceProblem problem(trace_bodies, pairs_);
    std::unique_ptr<InterfaceSolver> solver;
    {
      const Stopwatch watch(results.times.solve);
      solver = std::make_unique<InterfaceSolver>(problem, scene_.decomposition);
    }
    results.compliance_is_dense = solver->compliance().is_dense();
    {
      const Stopwatch watch(results.times.interface);
      results.iteration = solve_interface(problem, *solver, observer, results);
    }
    {
      const Stopwatch watch(results.times.solve);
      results.bodies.resize(bodies_.size());
      for_each_body(bodies_.size(),
                    [&](const std::size_t a) { results.bodies[a] = body_result(a, problem, results); });
    }
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      results.pairs.push_back(pair_result(i, problem, results.iteration));

    results.limit_distance = limit_distance(problem, *solver, results);
    if (reference_)
      results.true_errors = true_errors(*reference_, results);
    results.left_out = left_out(results);
    return results;
  }
} // namespace abut
