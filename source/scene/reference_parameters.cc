// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/text.h>
#include <abut/scene/reference_parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    using Solution = ReferenceParameters::Solution;

    const Choices<Solution> reference_solutions{
        {"none", Solution::none},
        {"layers sliding", Solution::layers_sliding},
        {"layers bonded", Solution::layers_bonded},
        {"infinite layers sliding", Solution::infinite_layers_sliding},
        {"infinite layers bonded", Solution::infinite_layers_bonded},
        {"hertz", Solution::hertz},
        {"lame", Solution::lame},
        {"flat punch", Solution::flat_punch},
        {"corner", Solution::corner}};

    const Choices<ReferenceParameters::Contact> reference_contacts{
        {"exact", ReferenceParameters::Contact::exact},
        {"penalised", ReferenceParameters::Contact::penalised}};

    /// A number above 0 that some of the solutions need.
    struct ReferenceDatum
    {
      std::string entry;
      double ReferenceParameters::*value;
      std::vector<Solution> needed_by;
      std::string documentation; ///< without its end, the unit
      std::string unit;
    };

    const std::vector<Solution> layers{Solution::layers_sliding, Solution::layers_bonded,
                                       Solution::infinite_layers_sliding, Solution::infinite_layers_bonded};

    const std::vector<ReferenceDatum> reference_data{
        {"Approach", &ReferenceParameters::approach, layers,
         "layers: how far the outer faces approach each other", "Length"},
        {"Gap curvature", &ReferenceParameters::gap_curvature, layers, "layers: r of the gap r x^2",
         "1 / length"},
        {"Force",
         &ReferenceParameters::force,
         {Solution::hertz, Solution::flat_punch},
         "hertz, flat punch: P, what presses the bodies together; the whole of it where the scene is one "
         "half",
         "Force / thickness"},
        {"Radius",
         &ReferenceParameters::radius,
         {Solution::hertz},
         "hertz: R of 1/R = 1/R_1 + 1/R_2, in the plane; the gap is x^2/(2R)",
         "Length"},
        {"Half width",
         &ReferenceParameters::half_width,
         {Solution::flat_punch},
         "flat punch: a, half of the punch's width",
         "Length"},
        {"Amplitude",
         &ReferenceParameters::amplitude,
         {Solution::corner},
         "corner: K of the stress K r^(alpha - 1) across the bisector, alpha = 0.54448",
         "Force / area length^(alpha - 1)"}};

    double positive_constant(const dealii::ParameterHandler &prm, const ReferenceDatum &datum,
                             const Solution solution, const Constants &constants)
    {
      const std::string where = "Reference/" + datum.entry;
      const double value = constant_value(prm.get(datum.entry), constants, where);
      if (!(value > 0.))
        throw UserError(where + ": received `" + prm.get(datum.entry) + "`, the solution " +
                        to_string(solution) + " needs a number above 0");
      return value;
    }

    void check_contact(const ReferenceParameters &reference)
    {
      if (reference.contact == ReferenceParameters::Contact::penalised &&
          reference.solution != Solution::layers_sliding && reference.solution != Solution::layers_bonded)
        throw UserError("Reference/Contact: received `penalised` with the solution " +
                        to_string(reference.solution) +
                        ", allowed with layers sliding and layers bonded only");
    }
  } // namespace

  void ReferenceParameters::declare(dealii::ParameterHandler &prm)
  {
    namespace Patterns = dealii::Patterns;
    prm.declare_entry(
        "Exact solution", "none", Patterns::Selection(words_of(reference_solutions)),
        "Exact solution with which results are compared. layers sliding: two layers with sliding "
        "faces and roller ends, pressed together over a quadratic gap. layers bonded: the same with faces "
        "that do not slide. infinite layers sliding, infinite layers bonded: layers without an end, for "
        "scenes whose right ends are free; the ends make a difference. hertz: contact of half-planes, the "
        "pressure and its resultant. lame: a disc or "
        "ring shrunk into a ring. flat punch: a half-plane, cut out as a rectangle, under a rigid punch. "
        "corner: the singular field of an L-shape. A scene that is not the solution's is refused.");
    prm.declare_entry(
        "Contact", "exact", Patterns::Selection(words_of(reference_contacts)),
        "layers sliding, layers bonded: the contact law of the exact solution. exact: no overlap; the "
        "penalty is "
        "part of the errors. penalised: the penalty of the scene's contact; errors are those of meshes and "
        "iteration alone.");
    for (const ReferenceDatum &datum : reference_data)
      prm.declare_entry(datum.entry, "0", Patterns::Anything(),
                        datum.documentation + ". A formula of constants. " + datum.unit + ".");
  }

  ReferenceParameters ReferenceParameters::parse(dealii::ParameterHandler &prm, const Constants &constants)
  {
    ReferenceParameters reference;
    reference.solution = choose(reference_solutions, prm.get("Exact solution"), "Reference/Exact solution");
    reference.contact = choose(reference_contacts, prm.get("Contact"), "Reference/Contact");
    check_contact(reference);
    for (const ReferenceDatum &datum : reference_data)
      if (std::find(datum.needed_by.begin(), datum.needed_by.end(), reference.solution) !=
          datum.needed_by.end())
        reference.*datum.value = positive_constant(prm, datum, reference.solution, constants);
    return reference;
  }

  std::string to_string(const ReferenceParameters::Solution solution)
  {
    return word_of(reference_solutions, solution);
  }
} // namespace abut
