// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/text.h>
#include <abut/scene/decomposition_parameters.h>
#include <abut/scene/scheme_entry.h>

#include <deal.II/base/parameter_handler.h>

namespace abut
{
  namespace
  {
    const Choices<StoppingRule> stopping_rules{{"bound", StoppingRule::bound},
                                               {"increment", StoppingRule::increment}};

    const Choices<ComplianceMode> compliance_modes{{"automatic", ComplianceMode::automatic},
                                                   {"dense", ComplianceMode::dense},
                                                   {"solves", ComplianceMode::solves}};

    double parse_tolerance(const dealii::ParameterHandler &prm)
    {
      const double value = prm.get_double("Tolerance");
      if (!(value > 0. && value < 1.))
        throw UserError("Decomposition/Tolerance: received `" + prm.get("Tolerance") +
                        "`, allowed are numbers between 0 and 1, both excluded");
      return value;
    }
  } // namespace

  const SchemeEntry &scheme_of(const DecompositionParameters &parameters)
  {
    return Registry<SchemeEntry>::get().find(parameters.scheme);
  }

  std::string schemes_with(bool SchemeEntry::*property, const bool value, const std::string &separator)
  {
    return Registry<SchemeEntry>::get().names_with(
        [&](const SchemeEntry &entry) { return entry.*property == value; }, separator);
  }

  void DecompositionParameters::declare(dealii::ParameterHandler &prm)
  {
    namespace Patterns = dealii::Patterns;
    prm.declare_entry("Scheme", "newton", Patterns::Anything(),
                      "How the interface problem is solved. " + Vocabulary::of("Scheme").documentation() +
                          " `abut schemes` compares them.");
    for (const SchemeEntry &scheme : Registry<SchemeEntry>::get().entries())
      if (scheme.declare != nullptr)
        scheme.declare(prm);
    prm.declare_entry(
        "Stopping rule", "bound", Patterns::Selection(words_of(stopping_rules)),
        "bound: guaranteed iteration error, relative, energy norm; for " +
            schemes_with(&SchemeEntry::takes_motions, true, " and ") +
            " where the "
            "penalty is 0 or tiny, or bodies float, the algebraic error of the contact law in the same norm. "
            "increment (" +
            schemes_with(&SchemeEntry::iterates_displacements, true, ", ") +
            " only): relative change of the normal contact displacement of every body in a "
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
    parameters.scheme = Vocabulary::of("Scheme").check(prm.get("Scheme"), where("Scheme"));
    for (const SchemeEntry &scheme : Registry<SchemeEntry>::get().entries())
      if (scheme.parse != nullptr)
        scheme.parse(prm, parameters);
    parameters.stopping_rule = choose(stopping_rules, prm.get("Stopping rule"), where("Stopping rule"));
    parameters.tolerance = parse_tolerance(prm);
    parameters.maximum_steps = static_cast<unsigned int>(prm.get_integer("Maximum steps"));
    parameters.compliance =
        choose(compliance_modes, prm.get("Interface compliance"), where("Interface compliance"));
    return parameters;
  }
} // namespace abut
