// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/text.h>
#include <abut/scene/scheme_checks.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    std::size_t count_resultants(const BodyDescription &body)
    {
      return static_cast<std::size_t>(
          std::count_if(body.conditions.begin(), body.conditions.end(),
                        [](const Condition &c) { return c.kind == ConditionKind::resultant; }));
    }

    void check_number_of_resultants(const Scene &scene)
    {
      std::size_t resultants = 0;
      for (const BodyDescription &body : scene.bodies)
      {
        const std::size_t own = count_resultants(body);
        resultants += own;
        if (own > 1)
          throw UserError("Body " + body.name + "/Conditions: received " + std::to_string(own) +
                          " resultants, one on a body is allowed");
      }
      if (resultants > 1 && scene.decomposition.scheme == SchemeKind::neumann)
        throw UserError("Conditions: received " + std::to_string(resultants) +
                        " resultants, one in a scene is allowed for Decomposition/Scheme = neumann; several "
                        "for conjugate and newton");
    }

    void check_exact_contact(const Scene &scene)
    {
      for (const ContactDescription &contact : scene.contacts)
        if (!contact.penalty && !(contact.penalty_coefficient > 0.))
          throw UserError("Contact " + contact.name +
                          "/Penalty coefficient: received `0`, allowed are numbers above 0: exact contact is "
                          "beyond the scheme neumann, Decomposition/Scheme = newton or conjugate solve it");
    }

    void check_estimated_steps(const Scene &scene)
    {
      const bool gives_a_force =
          std::any_of(scene.bodies.begin(), scene.bodies.end(),
                      [](const BodyDescription &body) { return count_resultants(body) > 0; });
      if (scene.adaptation.estimate_steps > 0 &&
          (scene.decomposition.scheme != SchemeKind::neumann || gives_a_force))
        throw UserError("Adaptation/Estimate steps: received `" +
                        std::to_string(scene.adaptation.estimate_steps) +
                        "`, allowed is 0 but with Decomposition/Scheme = neumann and without a resultant");
    }
  } // namespace

  void check_scheme(const Scene &scene)
  {
    check_number_of_resultants(scene);
    check_estimated_steps(scene);
    if (scene.decomposition.scheme == SchemeKind::neumann)
    {
      check_exact_contact(scene);
      return;
    }
    if (scene.adaptation.combined)
      throw UserError(
          "Adaptation/Combined: received `true`, which is a step of Decomposition/Scheme = neumann "
          "for every mesh; allowed with other schemes is false");
    if (scene.decomposition.stopping_rule == StoppingRule::increment)
      throw UserError("Decomposition/Stopping rule: received `increment`, a rule for Decomposition/Scheme = "
                      "neumann; allowed with other schemes is bound");
  }
} // namespace abut
