// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/text.h>
#include <abut/scene/reference_entry.h>
#include <abut/scene/reference_parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <set>

namespace abut
{
  namespace
  {
    const Choices<ReferenceParameters::Contact> reference_contacts{
        {"exact", ReferenceParameters::Contact::exact},
        {"penalised", ReferenceParameters::Contact::penalised}};

    std::string solutions_with_penalty(const std::string &separator)
    {
      return Registry<ReferenceEntry>::get().names_with(
          [](const ReferenceEntry &entry) { return entry.can_be_penalised; }, separator);
    }

    /// `hertz, flat punch: P, ...`: of an entry, by those that need it.
    std::string documentation_of(const std::string &entry)
    {
      std::map<std::string, std::string> needed_by; // by what is said of it
      for (const ReferenceEntry &solution : Registry<ReferenceEntry>::get().entries())
        for (const ReferenceDatum &datum : solution.data)
          if (datum.entry == entry)
          {
            std::string &names = needed_by[datum.documentation + ". " + datum.unit + "."];
            names += (names.empty() ? "" : ", ") + solution.name;
          }
      std::string text;
      for (const auto &[documentation, names] : needed_by)
        text += names + ": " + documentation + " ";
      return text + "A formula of constants.";
    }

    double positive_constant(const dealii::ParameterHandler &prm, const std::string &entry,
                             const std::string &solution, const Constants &constants)
    {
      const std::string where = "Reference/" + entry;
      const double value = constant_value(prm.get(entry), constants, where);
      if (!(value > 0.))
        throw UserError(where + ": received `" + prm.get(entry) + "`, the solution " + solution +
                        " needs a number above 0");
      return value;
    }

    void check_contact(const ReferenceParameters &reference, const ReferenceEntry &solution)
    {
      if (reference.contact == ReferenceParameters::Contact::penalised && !solution.can_be_penalised)
        throw UserError("Reference/Contact: received `penalised` with the solution " + solution.name +
                        ", allowed with " + solutions_with_penalty(" and ") + " only");
    }
  } // namespace

  bool ReferenceParameters::is_named() const
  {
    return Registry<ReferenceEntry>::get().find(solution).make != nullptr;
  }

  void ReferenceParameters::declare(dealii::ParameterHandler &prm)
  {
    namespace Patterns = dealii::Patterns;
    prm.declare_entry("Exact solution", "none", Patterns::Anything(),
                      "Exact solution with which results are compared. A scene that is not the solution's is "
                      "refused. " +
                          Vocabulary::of("Exact solution").documentation());
    prm.declare_entry(
        "Contact", "exact", Patterns::Selection(words_of(reference_contacts)),
        solutions_with_penalty(", ") +
            ": the contact law of the exact solution. exact: no overlap; the penalty is part of the errors. "
            "penalised: the penalty of the scene's contact; errors are those of meshes and iteration alone.");
    std::set<std::string> entries;
    for (const ReferenceEntry &solution : Registry<ReferenceEntry>::get().entries())
      for (const ReferenceDatum &datum : solution.data)
        entries.insert(datum.entry);
    for (const std::string &entry : entries)
      prm.declare_entry(entry, "0", Patterns::Anything(), documentation_of(entry));
  }

  ReferenceParameters ReferenceParameters::parse(dealii::ParameterHandler &prm, const Constants &constants)
  {
    ReferenceParameters reference;
    reference.solution =
        Vocabulary::of("Exact solution").check(prm.get("Exact solution"), "Reference/Exact solution");
    const ReferenceEntry &solution = Registry<ReferenceEntry>::get().find(reference.solution);
    reference.contact = choose(reference_contacts, prm.get("Contact"), "Reference/Contact");
    check_contact(reference, solution);
    for (const ReferenceDatum &datum : solution.data)
      reference.data[datum.entry] = positive_constant(prm, datum.entry, solution.name, constants);
    return reference;
  }
} // namespace abut
