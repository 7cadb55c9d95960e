// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/text.h>
#include <abut/scene/adaptation_parameters.h>

#include <deal.II/base/parameter_handler.h>

namespace abut
{
  namespace
  {
    const Choices<EstimatorKind> estimators{{"none", EstimatorKind::none},
                                            {"kelly", EstimatorKind::kelly},
                                            {"zz", EstimatorKind::zz},
                                            {"spr", EstimatorKind::spr},
                                            {"fe-be", EstimatorKind::fe_be}};

    const Choices<BoundarySolution> boundary_solutions{
        {"trace space", BoundarySolution::trace_space},
        {"constant traction", BoundarySolution::constant_traction},
        {"reference quality", BoundarySolution::reference_quality},
        {"finite element trace", BoundarySolution::finite_element_trace}};

    const Choices<Normalisation> normalisations{{"rms", Normalisation::rms},
                                                {"printed", Normalisation::printed}};

    const Choices<Marking> markings{{"threshold", Marking::threshold},
                                    {"fixed fraction", Marking::fixed_fraction},
                                    {"doerfler", Marking::doerfler}};

    /// A share with its bounds.
    double share(const dealii::ParameterHandler &prm, const std::string &entry, const bool zero_allowed,
                 const bool one_allowed)
    {
      const double value = prm.get_double(entry);
      if ((zero_allowed ? value >= 0. : value > 0.) && (one_allowed ? value <= 1. : value < 1.))
        return value;
      throw UserError("Adaptation/" + entry + ": received `" + prm.get(entry) +
                      "`, allowed are numbers from " + (zero_allowed ? "0" : "above 0") + " to " +
                      (one_allowed ? "1" : "below 1"));
    }

    void check_together(const AdaptationParameters &parameters)
    {
      if (parameters.marking == Marking::threshold && parameters.estimator != EstimatorKind::none &&
          parameters.limit == 0.)
        throw UserError(
            "Adaptation/Limit: received `0` with Marking = threshold, which splits the cells above "
            "the limit; allowed are numbers above 0");
      const bool by_law = parameters.estimator == EstimatorKind::fe_be && !parameters.combined &&
                          parameters.boundary_solution != BoundarySolution::finite_element_trace;
      if (parameters.estimate_steps > 0 && !by_law)
        throw UserError(
            "Adaptation/Estimate steps: received `" + std::to_string(parameters.estimate_steps) +
            "`, allowed is 0 but with Estimator = fe-be, Combined = false and a Boundary solution "
            "other than finite element trace");
      if (!parameters.combined)
        return;
      if (parameters.estimator == EstimatorKind::none)
        throw UserError(
            "Adaptation/Estimator: received `none` with Combined = true, allowed are kelly, zz, spr, fe-be");
      if (parameters.limit == 0.)
        throw UserError(
            "Adaptation/Limit: received `0` with Combined = true, whose passes end when eta is below "
            "the limit; allowed are numbers above 0");
    }
  } // namespace

  std::string to_string(const EstimatorKind estimator)
  {
    return word_of(estimators, estimator);
  }

  void AdaptationParameters::declare(dealii::ParameterHandler &prm)
  {
    namespace Patterns = dealii::Patterns;
    prm.declare_entry(
        "Estimator", "none", Patterns::Selection(words_of(estimators)),
        "How the stress error of a cell is estimated. kelly: jumps of the traction between cells. "
        "zz: against nodal averages of the stress, not for values at degree 2. spr: against polynomials "
        "fitted to the stress "
        "around each vertex and to the known boundary tractions. fe-be: against boundary elements on the "
        "edges of the mesh, which get the same data (the paper); bodies whose cells have straight edges "
        "(degree 1 "
        "on curved shapes), uniform body forces, no forces at points.");
    prm.declare_entry(
        "Boundary solution", "trace space", Patterns::Selection(words_of(boundary_solutions)),
        "Boundary elements of the estimator fe-be for finite elements of degree p. trace space: "
        "displacements "
        "and discontinuous tractions of degree p, with a recovered tangential derivative. constant traction: "
        "tractions of degree p - 1, nothing recovered (the paper to the letter). reference quality: "
        "displacements of degree p + 1. finite element trace: no boundary elements are solved, displacements "
        "and reactions of the finite elements enter the representation formula (cheap; no independent "
        "check near nu = 1/2). trace space and reference quality split edges towards vertices with infinite "
        "stress, the others do not. Without fe-be this has no meaning.");
    prm.declare_entry(
        "Normalisation", "rms", Patterns::Selection(words_of(normalisations)),
        "How eta relates the stress error of a cell to the mean stress of its body. rms: root of "
        "mean squares. printed: norms by areas, (27) of the paper to the letter, which grows as "
        "cells shrink.");
    prm.declare_entry(
        "Limit", "0", Patterns::Double(0.),
        "delta: the run ends when eta is at most this in every cell of every adapted body. No unit. "
        "0: it ends after Maximum passes.");
    prm.declare_entry(
        "Marking", "doerfler", Patterns::Selection(words_of(markings)),
        "Which cells are split. threshold: those with eta above Limit. fixed fraction: the share "
        "Fraction of the cells. doerfler: the fewest cells that carry the share Fraction of the "
        "squared error. Each body by itself.");
    prm.declare_entry("Fraction", "0.5", Patterns::Double(0., 1.),
                      "Share, above 0, that Marking speaks of; 1 with fixed fraction: every cell, uniform "
                      "refinement. No unit.");
    prm.declare_entry(
        "Coarsening", "0", Patterns::Double(0., 1.),
        "Which cells may be merged, four into one. threshold: those with eta below this times "
        "Limit. fixed fraction: this share of the cells, with the smallest errors. doerfler: as "
        "many cells as carry this share of the squared error. No unit. 0: none.");
    prm.declare_entry("Maximum passes", "10", Patterns::Integer(1, 10000),
                      "Meshes after which the run ends, the initial one included.");
    prm.declare_entry("Maximum unknowns", "1000000", Patterns::Integer(1),
                      "No further mesh is made once all bodies together have this many.");
    prm.declare_entry(
        "Iteration fraction", "0.1", Patterns::Double(0., 1.),
        "Iteration error allowed in each pass, as a share of the estimated discretisation error "
        "(energy norm, stopping rule bound, no side with a resultant). No unit. 0: "
        "Decomposition/Tolerance in each pass.");
    prm.declare_entry("Estimate steps", "0", Patterns::Integer(0),
                      "With fe-be and the scheme neumann: discretisation and iteration error together are "
                      "estimated at every "
                      "n-th step of the decomposition, for history.csv. 0: at the end of each pass only.");
    prm.declare_entry(
        "Combined", "false", Patterns::Bool(),
        "true: one decomposition step and one adaptation step a pass, as in the paper, until the "
        "increment of Decomposition/Tolerance and Limit are both reached. false: the decomposition "
        "is solved in each pass.");
  }

  AdaptationParameters AdaptationParameters::parse(dealii::ParameterHandler &prm)
  {
    AdaptationParameters parameters;
    parameters.estimator = choose(estimators, prm.get("Estimator"), "Adaptation/Estimator");
    parameters.boundary_solution =
        choose(boundary_solutions, prm.get("Boundary solution"), "Adaptation/Boundary solution");
    parameters.normalisation = choose(normalisations, prm.get("Normalisation"), "Adaptation/Normalisation");
    parameters.limit = prm.get_double("Limit");
    parameters.marking = choose(markings, prm.get("Marking"), "Adaptation/Marking");
    parameters.fraction = share(prm, "Fraction", false, true);
    parameters.coarsening = share(prm, "Coarsening", true, false);
    parameters.maximum_passes = static_cast<unsigned int>(prm.get_integer("Maximum passes"));
    parameters.maximum_unknowns = static_cast<unsigned int>(prm.get_integer("Maximum unknowns"));
    parameters.iteration_fraction = share(prm, "Iteration fraction", true, false);
    parameters.estimate_steps = static_cast<unsigned int>(prm.get_integer("Estimate steps"));
    parameters.combined = prm.get_bool("Combined");
    check_together(parameters);
    return parameters;
  }
} // namespace abut
