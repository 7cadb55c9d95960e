// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/text.h>
#include <abut/decomposition/schemes/neumann.h>
#include <abut/decomposition/spectrum.h>
#include <abut/scene/scheme_entry.h>

#include <deal.II/base/parameter_handler.h>

namespace abut
{
  double choose_relaxation(const InterfaceProblem &problem, const DecompositionParameters &parameters)
  {
    if (parameters.relaxation)
      return *parameters.relaxation;
    return automatic_relaxation(
        largest_eigenvalue(problem, *make_compliance(problem, ComplianceMode::solves, 0.)));
  }

  namespace
  {
    const Choices<InitialGuess> initial_guesses{
        {"elastic layer", InitialGuess::elastic_layer},
        {"elastic layer response", InitialGuess::elastic_layer_response}};

    std::optional<double> parse_relaxation(const dealii::ParameterHandler &prm)
    {
      const std::string text = prm.get("Relaxation");
      if (text == "automatic")
        return {};
      const double value = dealii::Patterns::Double().match(text) ? prm.get_double("Relaxation") : 0.;
      if (!(value > 0.))
        throw UserError("Decomposition/Relaxation: received `" + text +
                        "`, allowed are automatic and numbers above 0");
      return value;
    }

    void declare_neumann(dealii::ParameterHandler &prm)
    {
      namespace Patterns = dealii::Patterns;
      prm.declare_entry(
          "Initial guess", "elastic layer response", Patterns::Selection(words_of(initial_guesses)),
          "elastic layer: normal displacements of the contact nodes that just close the gap, shared "
          "as by elastic layers. elastic layer response: the bodies' response to the pressure of "
          "such layers. For the scheme neumann.");
      prm.declare_entry("Relaxation", "automatic", Patterns::Anything(),
                        "gamma of the scheme neumann, a number above 0, or automatic. No unit.");
    }

    void parse_neumann(const dealii::ParameterHandler &prm, DecompositionParameters &parameters)
    {
      parameters.initial_guess =
          choose(initial_guesses, prm.get("Initial guess"), "Decomposition/Initial guess");
      parameters.relaxation = parse_relaxation(prm);
    }

    DecompositionParameters with_relaxation(const InterfaceProblem &problem,
                                            const DecompositionParameters &parameters)
    {
      DecompositionParameters chosen = parameters;
      chosen.relaxation = choose_relaxation(problem, parameters);
      return chosen;
    }

    SchemeEntry neumann_entry()
    {
      SchemeEntry entry{
          "neumann",
          "the parallel Neumann scheme of the paper; it needs a penalty above 0, supports on every "
          "body and at most one rigid side with a given resultant"};
      entry.declare = declare_neumann;
      entry.parse = parse_neumann;
      entry.takes_motions = false;
      entry.solves_exact_contact = false;
      entry.iterates_displacements = true;
      entry.chosen = with_relaxation;
      entry.expected_solves = [](const DecompositionParameters &parameters, std::size_t /*n_motions*/) {
        return expected_steps(*parameters.relaxation, parameters.tolerance);
      };
      entry.make = [](const SchemeSetting &setting) -> std::unique_ptr<Scheme> {
        return std::make_unique<NeumannScheme>(setting.problem, setting.compliance, setting.parameters,
                                               *setting.parameters.relaxation);
      };
      return entry;
    }

    const Registered<SchemeEntry> registered_neumann(neumann_entry());
  } // namespace
} // namespace abut
