// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/adaptation/goal_marks.h>
#include <abut/adaptation/marking.h>
#include <abut/base/user_error.h>
#include <abut/run/contact_mismatch.h>
#include <abut/run/estimate.h>
#include <abut/run/goal_value.h>
#include <abut/run/gradings.h>
#include <abut/run/pressure_marks.h>

#include <cmath>
#include <set>

namespace abut
{
  namespace
  {
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
    /// Of the two the larger one in every cell: what an indicator sees is not counted twice. The stress of an
    /// energy norm is that of shear.
    void include(const Body &body, const Eigen::VectorXd &energy, CellErrors &errors)
    {
      errors.energy = errors.energy.cwiseMax(energy);
      errors.stress = errors.stress.cwiseMax(std::sqrt(2. * body.material().mu()) * energy);
    }

    /// Where data are smooth an indicator sees the same error.
    void include_oscillation(const Body &body, CellErrors &errors)
    {
      const Eigen::VectorXd oscillation = body.data_oscillation();
      if ((oscillation.array() > 0.).any())
        include(body, oscillation, errors);
    }

    /// Indicators compare each body with itself: what the sides miss of the contact law within their cells,
    /// for example a gap that goes up and down there, they do not see. It counts where it is more than all
    /// that they see: at the ends of smooth contacts, and while pressures are iterated, some of it is always
    /// there.
    void include_mismatch(const ContactMismatch &mismatch, const std::vector<BodyResult> &bodies,
                          std::vector<CellErrors> &errors)
    {
      constexpr double round_off = 1e-12; // of squares
      double seen = 0., unseen = 0.;
      for (std::size_t a = 0; a < bodies.size(); ++a)
      {
        seen += errors[a].energy.squaredNorm() + round_off * errors[a].energy_norm * errors[a].energy_norm;
        unseen += mismatch.cells[a].sum();
      }
      for (std::size_t a = 0; a < bodies.size() && unseen > seen; ++a)
        if (mismatch.cells[a].size() > 0)
          include(*bodies[a].body, mismatch.cells[a].cwiseSqrt(), errors[a]);
    }
  } // namespace

  Estimation estimate(const Indicator &indicator, const AdaptationParameters &parameters,
                      const std::vector<BodyResult> &bodies, const Executor &executor,
                      const ContactMismatch *const unseen)
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
    if (unseen != nullptr)
      include_mismatch(*unseen, bodies, estimation.errors);
    for (const CellErrors &errors : estimation.errors)
      estimation.eta.push_back(relative_errors(errors, parameters.normalisation));
    return estimation;
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
    /// What an indicator says of itself for a body.
    struct Certificate
    {
      std::string name, why_none; ///< see Indicator::name_for, why_uncertified

      void serialize(Archive &archive) { archive(name, why_none); }
    };

    /// Tells what estimates, "fe-be", or "fe-be, kelly" where bodies differ, and why it is no bound.
    void add_certificates(const Indicator &indicator, const Setup &setup, const Solution &solution,
                          Estimation &estimation)
    {
      std::set<std::string> names;
      for (const Certificate &certificate :
           setup.model.executor().of_bodies(solution.bodies.size(), [&](const std::size_t a) {
             const Body &body = *solution.bodies[a].body;
             if (body.description().is_rigid)
               return Certificate();
             return Certificate{indicator.name_for(body), setup.scene.adaptation.certifies()
                                                              ? indicator.why_uncertified(body)
                                                              : std::string()};
           }))
      {
        if (!certificate.name.empty())
          names.insert(certificate.name);
        if (estimation.why_uncertified.empty())
          estimation.why_uncertified = certificate.why_none;
      }
      for (const std::string &name : names)
        estimation.estimator += (estimation.estimator.empty() ? "" : ", ") + name;
    }

    Estimation estimate_by(const Indicator &indicator, const Setup &setup, Solution &solution)
    {
      const InterfaceProblem &problem = setup.model.problem();
      const bool by_law = setup.scene.adaptation.estimates_by_law();
      const Eigen::VectorXd pressures =
          by_law ? pressures_by_law(problem, solution.iteration) : solution.iteration.traction;
      for (std::size_t a = 0; a < solution.bodies.size(); ++a)
        solution.bodies[a].estimate_forces = problem.contact_forces(a, pressures);
      std::optional<ContactMismatch> mismatch;
      if (!setup.scene.adaptation.combined) // whose pressures are those before the last step
        mismatch = contact_mismatch(problem, pressures, solution.bodies);
      Estimation estimation = estimate(indicator, setup.scene.adaptation, solution.bodies,
                                       setup.model.executor(), mismatch && !by_law ? &*mismatch : nullptr);
      if (by_law)
        estimation.mismatch = std::move(mismatch);
      for (std::size_t a = 0; a < solution.bodies.size(); ++a)
      {
        solution.bodies[a].eta = estimation.eta[a];
        solution.bodies[a].better = estimation.errors[a].better;
      }
      add_certificates(indicator, setup, solution, estimation);
      return estimation;
    }
  } // namespace

  Estimation estimate_solution(const Setup &setup, Solution &solution, GoalDistance &distance)
  {
    Assert(setup.indicator != nullptr, dealii::ExcMessage("nothing is to be estimated"));
    Estimation estimation = estimate_by(*setup.indicator, setup, solution);
    if (setup.certifier == nullptr || !distance.is_near(estimation) ||
        !pressures_meet_tolerance(setup.scene, relative_pressure_error(solution.pairs)))
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
                                               const Results &results, const Executor &executor)
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
      grade_towards_singularities(cells, aim, results, executor, marks.cells);
      if (scene.goal.is_energy())
        mark_pressures(scene, results, scene.tolerance, marks.cells);
      return std::move(marks.cells);
    }

    /// The errors of cells with what stands beside them, without the better stresses.
    std::vector<CellErrors> errors_for_marks(const Estimation &estimation,
                                             const std::vector<BodyResult> &bodies)
    {
      std::vector<CellErrors> all(estimation.errors.size());
      for (std::size_t a = 0; a < all.size(); ++a)
      {
        const CellErrors &errors = estimation.errors[a];
        all[a].stress = errors.stress;
        all[a].energy = errors.energy;
        all[a].areas = errors.areas;
        all[a].stress_norm = errors.stress_norm;
        all[a].energy_norm = errors.energy_norm;
      }
      if (estimation.mismatch)
        include_mismatch(*estimation.mismatch, bodies, all);
      return all;
    }

    std::vector<CellMarks> marks_of_bodies(const Scene &scene, const Estimation &estimation,
                                           const std::vector<BodyResult> &bodies)
    {
      const std::vector<CellErrors> errors = errors_for_marks(estimation, bodies);
      std::vector<CellMarks> marks;
      for (std::size_t a = 0; a < bodies.size(); ++a)
        marks.push_back(scene.bodies[a].adapt
                            ? mark(errors[a], relative_errors(errors[a], scene.adaptation.normalisation),
                                   scene.adaptation)
                            : no_marks(bodies[a].body->counts().cells));
      return marks;
    }
  } // namespace

  std::vector<CellMarks> mark_all(const Scene &scene, const Estimation &estimation, const Results &results,
                                  const Executor &executor)
  {
    const std::vector<BodyResult> &bodies = results.bodies;
    AssertDimension(bodies.size(), scene.bodies.size());
    const bool for_tolerance = Registry<MarkingEntry>::get().find(scene.adaptation.marking).needs_tolerance;
    std::vector<CellMarks> marks = for_tolerance ? marks_for_tolerance(scene, estimation, results, executor)
                                                 : marks_of_bodies(scene, estimation, bodies);
    for (const PairResult &pair : results.pairs)
      mark_missed(scene, pair, bodies, marks);
    if (for_tolerance)
      mark_goal(scene, results, executor, marks);
    const auto crowded = executor.of_bodies(bodies.size(), [&](const std::size_t a) {
      return scene.bodies[a].adapt && scene.bodies[a].joints.mortar.neighbour_rule
                 ? bodies[a].body->crowded_cells()
                 : std::vector<unsigned int>();
    });
    for (std::size_t a = 0; a < bodies.size(); ++a)
      for (const unsigned int cell : crowded[a])
      {
        marks[a].refine[cell] = true;
        marks[a].coarsen[cell] = false;
      }
    return marks;
  }
} // namespace abut
