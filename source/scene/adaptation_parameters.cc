// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/text.h>
#include <abut/scene/adaptation_parameters.h>
#include <abut/scene/marking_entry.h>

#include <deal.II/base/parameter_handler.h>

namespace abut
{
  namespace
  {
    const Choices<BoundarySolution> boundary_solutions{
        {"trace space", BoundarySolution::trace_space},
        {"constant traction", BoundarySolution::constant_traction},
        {"reference quality", BoundarySolution::reference_quality},
        {"finite element trace", BoundarySolution::finite_element_trace}};

    const Choices<Normalisation> normalisations{{"rms", Normalisation::rms},
                                                {"printed", Normalisation::printed}};

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

    const EstimatorEntry &entry_of(const AdaptationParameters &parameters)
    {
      return Registry<EstimatorEntry>::get().find(parameters.estimator);
    }

    void check_combined(const AdaptationParameters &parameters)
    {
      if (!entry_of(parameters).estimates())
        throw UserError("Adaptation/Estimator: received `" + parameters.estimator +
                        "` with Combined = true, allowed are " +
                        Registry<EstimatorEntry>::get().names_with(
                            [](const EstimatorEntry &entry) { return entry.estimates(); }));
      if (parameters.limit == 0.)
        throw UserError(
            "Adaptation/Limit: received `0` with Combined = true, whose passes end when eta is below "
            "the limit; allowed are numbers above 0");
    }

    void check_together(const AdaptationParameters &parameters)
    {
      if (Registry<MarkingEntry>::get().find(parameters.marking).needs_limit &&
          entry_of(parameters).estimates() && parameters.limit == 0.)
        throw UserError("Adaptation/Limit: received `0` with Marking = " + parameters.marking +
                        ", which splits the cells above the limit; allowed are numbers above 0");
      if (parameters.estimate_steps > 0 && !parameters.estimates_by_law())
        throw UserError("Adaptation/Estimate steps: received `" + std::to_string(parameters.estimate_steps) +
                        "`, allowed is 0 but with Estimator = " + estimators_with_boundary_elements() +
                        ", Combined = false and a Boundary solution other than finite element trace");
      if (parameters.combined)
        check_combined(parameters);
    }
  } // namespace

  std::string estimators_with_boundary_elements()
  {
    return Registry<EstimatorEntry>::get().names_with(
        [](const EstimatorEntry &entry) { return entry.has_boundary_elements; }, " or ");
  }

  bool AdaptationParameters::certifies() const
  {
    return entry_of(*this).make_certifier != nullptr;
  }

  std::string AdaptationParameters::why_not_by_law() const
  {
    if (certifies())
      return {};
    if (!entry_of(*this).has_boundary_elements)
      return "only Estimator = " + estimators_with_boundary_elements() +
             " bounds the error, this one compares the finite elements with themselves";
    if (combined)
      return "in the combined algorithm the boundary elements answer the pressures before the last step";
    if (boundary_solution == BoundarySolution::finite_element_trace)
      return coarse_boundary_elements;
    return {};
  }

  void AdaptationParameters::declare(dealii::ParameterHandler &prm)
  {
    namespace Patterns = dealii::Patterns;
    prm.declare_entry("Estimator", "none", Patterns::Anything(),
                      "How the stress error of a cell is estimated. " +
                          Vocabulary::of("Estimator").documentation());
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
    prm.declare_entry("Boundary accuracy", "0.001", Patterns::Double(0., .1),
                      "Error allowed to the boundary elements of fe-be where there are too many to sum over "
                      "all pairs of them, as a share of the estimated error. No unit. 0: all pairs "
                      "are summed over, whatever it costs.");
    prm.declare_entry(
        "Normalisation", "rms", Patterns::Selection(words_of(normalisations)),
        "How eta relates the stress error of a cell to the mean stress of its body. rms: root of "
        "mean squares. printed: norms by areas, (27) of the paper to the letter, which grows as "
        "cells shrink.");
    prm.declare_entry(
        "Limit", "0", Patterns::Double(0.),
        "delta: the run ends when eta is at most this in every cell of every adapted body. No unit. "
        "0: it ends after Maximum passes.");
    prm.declare_entry("Marking", "doerfler", Patterns::Anything(),
                      "Which cells are split, each body by itself. " +
                          Vocabulary::of("Marking").documentation());
    prm.declare_entry("Fraction", "0.5", Patterns::Double(0., 1.),
                      "Share, above 0, that Marking speaks of; 1 with fixed fraction: every cell, uniform "
                      "refinement. No unit.");
    prm.declare_entry("Coarsening", "0", Patterns::Double(0., 1.),
                      "Which cells may be merged, four into one: a share, see Marking. No unit. 0: none.");
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
    parameters.estimator = Vocabulary::of("Estimator").check(prm.get("Estimator"), "Adaptation/Estimator");
    parameters.boundary_solution =
        choose(boundary_solutions, prm.get("Boundary solution"), "Adaptation/Boundary solution");
    parameters.boundary_accuracy = prm.get_double("Boundary accuracy");
    parameters.normalisation = choose(normalisations, prm.get("Normalisation"), "Adaptation/Normalisation");
    parameters.limit = prm.get_double("Limit");
    parameters.marking = Vocabulary::of("Marking").check(prm.get("Marking"), "Adaptation/Marking");
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
