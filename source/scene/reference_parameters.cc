// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/scene/reference_parameters.h>
#include <abut/scene/text.h>

#include <deal.II/base/parameter_handler.h>

namespace abut
{
  namespace
  {
    const Choices<ReferenceParameters::Solution> reference_solutions{
        {"none", ReferenceParameters::Solution::none},
        {"layers sliding", ReferenceParameters::Solution::layers_sliding},
        {"layers bonded", ReferenceParameters::Solution::layers_bonded}};

    double positive_constant(const dealii::ParameterHandler &prm, const std::string &entry,
                             const Constants &constants)
    {
      const std::string where = "Reference/" + entry;
      const double value = constant_value(prm.get(entry), constants, where);
      if (!(value > 0.))
        throw UserError(where + ": received `" + prm.get(entry) +
                        "`, the solution of two layers needs a number above 0");
      return value;
    }
  } // namespace

  void ReferenceParameters::declare(dealii::ParameterHandler &prm)
  {
    namespace Patterns = dealii::Patterns;
    prm.declare_entry(
        "Exact solution", "none", Patterns::Selection(words_of(reference_solutions)),
        "Exact solution with which results are compared. layers sliding: two layers with sliding "
        "faces and roller ends, pressed together over a quadratic gap. layers bonded: the same with faces "
        "that "
        "do not slide.");
    prm.declare_entry("Approach", "0", Patterns::Anything(),
                      "layers: how far the outer faces approach each other, a formula of constants. "
                      "Length.");
    prm.declare_entry("Gap curvature", "0", Patterns::Anything(),
                      "layers: r of the gap r x^2, a formula of constants. 1 / length.");
  }

  ReferenceParameters ReferenceParameters::parse(dealii::ParameterHandler &prm, const Constants &constants)
  {
    ReferenceParameters reference;
    reference.solution = choose(reference_solutions, prm.get("Exact solution"), "Reference/Exact solution");
    if (reference.solution == Solution::none)
      return reference;
    reference.approach = positive_constant(prm, "Approach", constants);
    reference.gap_curvature = positive_constant(prm, "Gap curvature", constants);
    return reference;
  }
} // namespace abut
