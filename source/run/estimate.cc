// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/adaptation/goal_marks.h>
#include <abut/adaptation/marking.h>
#include <abut/base/user_error.h>
#include <abut/contact/law_mismatch.h>
#include <abut/run/estimate.h>
#include <abut/run/goal_value.h>
#include <abut/run/gradings.h>
#include <abut/run/pressure_marks.h>
#include <abut/trace/applied_traction.h>

#include <cmath>
#include <set>

namespace abut
{
  namespace
  {
    /// A rigid body has no cells.
    void add_to_cells(const Trace &trace, const Eigen::VectorXd &of_segments, Eigen::VectorXd &cells)
    {
      if (cells.size() == 0)
        return;
      for (std::size_t i = 0; i < trace.segments().size(); ++i)
        cells[trace.segments()[i].cell] += of_segments[static_cast<Eigen::Index>(i)];
    }

    void add_mismatch(const ContactPair &pair, const std::vector<bool> &near,
                      const std::vector<BodyResult> &bodies, ContactMismatch &sum)
    {
      const auto displacement = [&](const ContactBody &side) {
        const BodyResult &result = bodies[side.body];
        return result.body->of_side(result.body->trace_of(result.displacement), side.side);
      };
      const auto traction = [&](const ContactBody &side) {
        const BodyResult &result = bodies[side.body];
        return applied_traction(*side.trace, result.body->of_side(result.estimate_forces, side.side));
      };
      const ContactBody &cut = pair.cut_side(), &other = pair.other_side();
      const LawMismatch mismatch = law_mismatch(pair, near, {displacement(cut), displacement(other)},
                                                {traction(cut), traction(other)});
      sum.law += mismatch.law;
      sum.responses[cut.body] += mismatch.cut_response;
      sum.responses[other.body] += mismatch.other_response;
      add_to_cells(*cut.trace, mismatch.of_cut_segments, sum.cells[cut.body]);
      add_to_cells(*other.trace, mismatch.of_other_segments, sum.cells[other.body]);
    }

    void mark_missed(const Scene &scene, const PairResult &result, const std::vector<BodyResult> &bodies,
                     std::vector<CellMarks> &marks)
    {
      const ContactPair &pair = *result.pair;
      const auto mark_segment = [&](const ContactBody &side, const std::size_t segment) {
        if (!scene.bodies[side.body].adapt)
          return;
        const unsigned int cell = bodies[side.body].body->contact_sides()[side.side].segments()[segment].cell;
        marks[side.body].refine[cell] = true;
        marks[side.body].coarsen[cell] = false;
      };
      for (const MissedContact &missed : result.missed)
      {
        mark_segment(pair.cut_side(), missed.piece.cut_segment);
        mark_segment(pair.other_side(), missed.piece.other_segment);
      }
    }
  } // namespace

  namespace
  {
    /// Of the two the larger one in every cell: where data are smooth an indicator sees the same error. The
    /// stress of an energy norm is that of shear.
    void include_oscillation(const Body &body, CellErrors &errors)
    {
      const Eigen::VectorXd oscillation = body.data_oscillation();
      if (!(oscillation.array() > 0.).any())
        return;
      errors.energy = errors.energy.cwiseMax(oscillation);
      errors.stress = errors.stress.cwiseMax(std::sqrt(2. * body.material().mu()) * oscillation);
    }
  } // namespace

  Estimation estimate(const Indicator &indicator, const AdaptationParameters &parameters,
                      const std::vector<BodyResult> &bodies, const Executor &executor)
  {
    for ([[maybe_unused]] const BodyResult &body : bodies)
      AssertDimension(body.estimate_forces.size(), body.body->trace_size());
    Estimation estimation;
    estimation.errors = executor.of_bodies(bodies.size(), [&](const std::size_t a) {
      if (bodies[a].body->description().is_rigid)
        return CellErrors(); // no cells, no errors
      CellErrors errors =
          indicator.estimate({*bodies[a].body, bodies[a].deformation, bodies[a].estimate_forces});
      include_oscillation(*bodies[a].body, errors);
      if (!errors.energy.allFinite() || !errors.stress.allFinite())
        throw ComputationError(
            "Body " + bodies[a].body->name() +
            ": the estimate of a cell is not finite; cells have become too small for their "
            "coordinates, stop earlier (a larger Tolerance, Adaptation/Maximum passes)");
      return errors;
    });
    for (const CellErrors &errors : estimation.errors)
      estimation.eta.push_back(relative_errors(errors, parameters.normalisation));
    return estimation;
  }

  ContactMismatch contact_mismatch(const InterfaceProblem &problem, const Eigen::VectorXd &pressures,
                                   const std::vector<BodyResult> &bodies)
  {
    AssertDimension(pressures.size(), problem.n_pressures());
    AssertDimension(bodies.size(), problem.bodies().size());
    ContactMismatch sum{0., std::vector<double>(bodies.size(), 0.), {}};
    for (const BodyResult &body : bodies)
      sum.cells.push_back(Eigen::VectorXd::Zero(body.body->counts().cells));
    for (std::size_t surface = 0; surface < problem.surfaces().size(); ++surface)
    {
      const ContactSurface &parts = problem.surfaces()[surface];
      std::vector<bool> presses;
      for (const double pressure : problem.of_surface(surface, pressures))
        presses.push_back(pressure > 0.);
      const std::vector<bool> near = parts.near_contact(presses);
      for (const ContactPair &pair : parts.pairs())
        add_mismatch(pair, near, bodies, sum);
    }
    return sum;
  }

  namespace
  {
    /// Pressures that the contact law makes of the displacement; without a penalty any that push satisfy it
    /// as far as they meet no gap.
    Eigen::VectorXd pressures_by_law(const InterfaceProblem &problem, const SchemeResult &iteration)
    {
      // Only those of the solution balance what floats; the estimate holds for all that push.
      if (iteration.motions.size() > 0)
        return iteration.traction;
      return (problem.penalties().array() > 0.)
          .select(problem.pressures(iteration.response), iteration.traction);
    }
  } // namespace

  double GoalDistance::expected(const Estimation &cheap) const
  {
    return ratio_.value_or(1.) * cheap.bound().value_or(cheap.discretisation());
  }

  bool GoalDistance::is_near(const Estimation &cheap) const
  {
    const double margin = ratio_ ? 1.1 : 2.; // jumps have been .7 to 1.8 times the error
    return expected(cheap) <= margin * tolerance_ || cheap.discretisation() <= tolerance_;
  }

  void GoalDistance::learn(const Estimation &cheap, const Estimation &better)
  {
    if (cheap.bound() && better.bound() && *cheap.bound() > 0.)
      ratio_ = *better.bound() / *cheap.bound();
  }

  namespace
  {
    /// "fe-be", or "fe-be, kelly" where bodies differ.
    std::string names_of(const Indicator &indicator, const std::vector<BodyResult> &bodies)
    {
      std::set<std::string> names;
      for (const BodyResult &body : bodies)
        if (!body.body->description().is_rigid)
          names.insert(indicator.name_for(*body.body));
      std::string all;
      for (const std::string &name : names)
        all += (all.empty() ? "" : ", ") + name;
      return all;
    }

    Estimation estimate_by(const Indicator &indicator, const Setup &setup, Solution &solution)
    {
      const InterfaceProblem &problem = setup.model.problem();
      const bool by_law = setup.scene.adaptation.estimates_by_law();
      const Eigen::VectorXd pressures =
          by_law ? pressures_by_law(problem, solution.iteration) : solution.iteration.traction;
      for (std::size_t a = 0; a < solution.bodies.size(); ++a)
        solution.bodies[a].estimate_forces = problem.contact_forces(a, pressures);
      Estimation estimation =
          estimate(indicator, setup.scene.adaptation, solution.bodies, setup.model.executor());
      if (by_law)
        estimation.mismatch = contact_mismatch(problem, pressures, solution.bodies);
      for (std::size_t a = 0; a < solution.bodies.size(); ++a)
      {
        solution.bodies[a].eta = estimation.eta[a];
        solution.bodies[a].better = estimation.errors[a].better;
      }
      estimation.estimator = names_of(indicator, solution.bodies);
      if (setup.scene.adaptation.certifies())
        for (const BodyResult &body : solution.bodies)
          if (estimation.why_uncertified.empty() && !body.body->description().is_rigid)
            estimation.why_uncertified = indicator.why_uncertified(*body.body);
      return estimation;
    }

    bool pressures_allow_to_end(const Scene &scene, const Solution &solution)
    {
      return !scene.goal.is_energy() ||
             relative_pressure_error(solution.pairs).value_or(0.) <= scene.tolerance;
    }
  } // namespace

  Estimation estimate_solution(const Setup &setup, Solution &solution, GoalDistance &distance)
  {
    Assert(setup.indicator != nullptr, dealii::ExcMessage("nothing is to be estimated"));
    Estimation estimation = estimate_by(*setup.indicator, setup, solution);
    if (setup.certifier == nullptr || !distance.is_near(estimation) ||
        !pressures_allow_to_end(setup.scene, solution))
      return estimation;
    Estimation better = estimate_by(*setup.certifier, setup, solution);
    distance.learn(estimation, better);
    return better;
  }

  namespace
  {
    /// How far the error has to go down; somewhat below the tolerance, since a mesh does not keep all that is
    /// expected of it.
    std::vector<CellMarks> marks_for_tolerance(const Scene &scene, const Estimation &estimation,
                                               const Results &results)
    {
      constexpr double safety = .8;
      std::vector<GoalCells> cells;
      for (std::size_t a = 0; a < scene.bodies.size(); ++a)
        cells.push_back({estimation.cell_squares(a), scene.bodies[a].degree, scene.bodies[a].adapt});
      // How a goal of its own follows the energy norm is not known.
      const double aim = scene.goal.is_energy()
                             ? safety * scene.tolerance / results.passes.back().error_for_tolerance()
                             : .5;
      GoalMarks marks = goal_marks(cells, aim);
      grade_towards_singularities(cells, aim, results, marks.cells);
      if (scene.goal.is_energy())
        mark_pressures(scene, results, scene.tolerance, marks.cells);
      return std::move(marks.cells);
    }

    std::vector<CellMarks> marks_of_bodies(const Scene &scene, const Estimation &estimation,
                                           const std::vector<BodyResult> &bodies)
    {
      std::vector<CellMarks> marks;
      for (std::size_t a = 0; a < bodies.size(); ++a)
        marks.push_back(scene.bodies[a].adapt
                            ? mark(estimation.errors[a], estimation.eta[a], scene.adaptation)
                            : no_marks(bodies[a].body->counts().cells));
      return marks;
    }
  } // namespace

  std::vector<CellMarks> mark_all(const Scene &scene, const Estimation &estimation, const Results &results)
  {
    const std::vector<BodyResult> &bodies = results.bodies;
    AssertDimension(bodies.size(), scene.bodies.size());
    const bool for_tolerance = Registry<MarkingEntry>::get().find(scene.adaptation.marking).needs_tolerance;
    std::vector<CellMarks> marks = for_tolerance ? marks_for_tolerance(scene, estimation, results)
                                                 : marks_of_bodies(scene, estimation, bodies);
    for (const PairResult &pair : results.pairs)
      mark_missed(scene, pair, bodies, marks);
    if (for_tolerance)
      mark_goal(scene, results, marks);
    for (std::size_t a = 0; a < bodies.size(); ++a)
      if (scene.bodies[a].adapt && scene.bodies[a].joints.mortar.neighbour_rule)
        for (const unsigned int cell : bodies[a].body->crowded_cells())
        {
          marks[a].refine[cell] = true;
          marks[a].coarsen[cell] = false;
        }
    return marks;
  }
} // namespace abut
