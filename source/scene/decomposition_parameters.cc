// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/text.h>
#include <abut/scene/decomposition_parameters.h>

#include <deal.II/base/parameter_handler.h>

namespace abut
{
  namespace
  {
    const Choices<SchemeKind> schemes{{"neumann", SchemeKind::neumann},
                                      {"conjugate", SchemeKind::conjugate},
                                      {"newton", SchemeKind::newton}};

    const Choices<InitialGuess> initial_guesses{
        {"elastic layer", InitialGuess::elastic_layer},
        {"elastic layer response", InitialGuess::elastic_layer_response}};

    const Choices<StoppingRule> stopping_rules{{"bound", StoppingRule::bound},
                                               {"increment", StoppingRule::increment}};

    const Choices<ComplianceMode> compliance_modes{{"automatic", ComplianceMode::automatic},
                                                   {"dense", ComplianceMode::dense},
                                                   {"solves", ComplianceMode::solves}};

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

    double parse_tolerance(const dealii::ParameterHandler &prm)
    {
      const double value = prm.get_double("Tolerance");
      if (!(value > 0. && value < 1.))
        throw UserError("Decomposition/Tolerance: received `" + prm.get("Tolerance") +
                        "`, allowed are numbers between 0 and 1, both excluded");
      return value;
    }
  } // namespace

  std::string to_string(const SchemeKind scheme)
  {
    return word_of(schemes, scheme);
  }

  void DecompositionParameters::declare(dealii::ParameterHandler &prm)
  {
    namespace Patterns = dealii::Patterns;
    prm.declare_entry(
        "Scheme", "newton", Patterns::Selection(words_of(schemes)),
        "How the interface problem is solved. newton: primal-dual active set, a few steps whatever penalty "
        "and stiffness ratio. conjugate: projected conjugate gradients. neumann: the parallel "
        "Neumann scheme of the paper; it needs a penalty above 0, supports on every body and at most one "
        "rigid side with a given resultant. `abut schemes` compares them.");
    prm.declare_entry(
        "Initial guess", "elastic layer response", Patterns::Selection(words_of(initial_guesses)),
        "elastic layer: normal displacements of the contact nodes that just close the gap, shared "
        "as by elastic layers. elastic layer response: the bodies' response to the pressure of "
        "such layers. For the scheme neumann.");
    prm.declare_entry("Relaxation", "automatic", Patterns::Anything(),
                      "gamma of the scheme neumann, a number above 0, or automatic. No unit.");
    prm.declare_entry(
        "Stopping rule", "bound", Patterns::Selection(words_of(stopping_rules)),
        "bound: guaranteed iteration error, relative, energy norm; for conjugate and newton where the "
        "penalty is 0 or tiny, or bodies float, the algebraic error of the contact law in the same norm. "
        "increment (neumann only): relative change of the normal contact displacement of every body in a "
        "step.");
    prm.declare_entry("Tolerance", "1e-6", Patterns::Double(0.),
                      "What the stopping rule asks for, above 0. No unit.");
    prm.declare_entry("Maximum steps", "100000", Patterns::Integer(1),
                      "Steps after which the iteration ends as not converged.");
    prm.declare_entry(
        "Interface compliance", "automatic", Patterns::Selection(words_of(compliance_modes)),
        "dense: the interface compliance is made once as a matrix. solves: every body is solved in "
        "every step. automatic: what is expected to be cheaper. The iterates are the same.");
  }

  DecompositionParameters DecompositionParameters::parse(dealii::ParameterHandler &prm)
  {
    DecompositionParameters parameters;
    const auto where = [](const std::string &entry) { return "Decomposition/" + entry; };
    parameters.scheme = choose(schemes, prm.get("Scheme"), where("Scheme"));
    parameters.initial_guess = choose(initial_guesses, prm.get("Initial guess"), where("Initial guess"));
    parameters.relaxation = parse_relaxation(prm);
    parameters.stopping_rule = choose(stopping_rules, prm.get("Stopping rule"), where("Stopping rule"));
    parameters.tolerance = parse_tolerance(prm);
    parameters.maximum_steps = static_cast<unsigned int>(prm.get_integer("Maximum steps"));
    parameters.compliance =
        choose(compliance_modes, prm.get("Interface compliance"), where("Interface compliance"));
    return parameters;
  }
} // namespace abut
