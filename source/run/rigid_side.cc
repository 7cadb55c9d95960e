// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/decomposition/resultant_loading.h>
#include <abut/run/rigid_side.h>

#include <algorithm>
#include <cmath>

namespace abut
{
  namespace
  {
    std::size_t index_with_resultant(const Model &model)
    {
      const auto &bodies = model.bodies();
      return static_cast<std::size_t>(
          std::find_if(bodies.begin(), bodies.end(), [](const auto &body) { return body->resultant(); }) -
          bodies.begin());
    }

    /// What a column of the body's modulus yields, after the gaps of all contacts are closed.
    double first_guess(const Model &model, const Body &pressed)
    {
      double guess = std::abs(pressed.resultant()->force) / pressed.material().young_modulus;
      for (const ContactPair *pair : model.pairs())
        if (pair->coverage() > 0.)
          guess += std::max(1e-6 * pair->slave().depth, pair->smallest_gap());
      return guess;
    }
  } // namespace

  const Body *body_with_resultant(const Model &model)
  {
    const std::size_t index = index_with_resultant(model);
    return index < model.bodies().size() ? model.bodies()[index].get() : nullptr;
  }

  RigidSideSolution solve_with_resultant(const Model &model, const InterfaceSolver &solver,
                                         const std::optional<Eigen::VectorXd> &start, const double guess,
                                         const double tolerance, const StepObserver &observer)
  {
    const InterfaceProblem &problem = model.problem();
    const std::size_t index = index_with_resultant(model);
    AssertIndexRange(index, model.bodies().size());
    const Body &pressed = *model.bodies()[index];
    std::optional<Eigen::VectorXd> from = start;
    SchemeResult result;
    const auto force = [&](const double displacement) {
      const unsigned int steps_before = result.steps; // several solutions: one count for all
      const auto count_on = [&](StepRecord record) {
        record.step += steps_before;
        observer(record);
      };
      result = solver.solve(problem.loads(displacement), from, count_on, tolerance);
      result.steps += steps_before;
      if (!result.converged())
        throw ComputationError(result.message);
      from = result.traction;
      const Eigen::VectorXd contact = problem.contact_forces(index, result.traction);
      return model.executor().of_bodies(model.bodies().size(), [&](const std::size_t a) {
        return a == index ? pressed.rigid_side_force(pressed.deformation(contact, displacement), contact)
                          : 0.;
      })[index];
    };
    const double displacement = find_rigid_displacement(
        force, pressed.resultant()->force, guess != 0. ? std::abs(guess) : first_guess(model, pressed),
        std::max(10. * tolerance, 1e-10),
        "Body " + pressed.name() + ", side " + pressed.resultant()->boundary);
    return {std::move(result), displacement};
  }
} // namespace abut
