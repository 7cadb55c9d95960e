// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/text.h>
#include <abut/scene/scheme_checks.h>
#include <abut/scene/scheme_entry.h>

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

    std::string displacement_schemes()
    {
      return schemes_with(&SchemeEntry::iterates_displacements, true, " or ");
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
      if (resultants > 1 && !scheme_of(scene.decomposition).takes_motions)
        throw UserError("Conditions: received " + std::to_string(resultants) +
                        " resultants, one in a scene is allowed for Decomposition/Scheme = " +
                        scene.decomposition.scheme + "; several for " +
                        schemes_with(&SchemeEntry::takes_motions, true, " and "));
    }

    void check_penalties(const Scene &scene)
    {
      for (const ContactDescription &contact : scene.contacts)
        if (!contact.penalty && !(contact.penalty_coefficient > 0.))
          throw UserError("Contact " + contact.name +
                          "/Penalty coefficient: received `0`, allowed are numbers above 0: exact contact is "
                          "beyond the scheme " +
                          scene.decomposition.scheme + ", Decomposition/Scheme = " +
                          schemes_with(&SchemeEntry::solves_exact_contact, true, " or ") + " solve it");
    }

    void check_estimated_steps(const Scene &scene)
    {
      const bool gives_a_force =
          std::any_of(scene.bodies.begin(), scene.bodies.end(),
                      [](const BodyDescription &body) { return count_resultants(body) > 0; });
      if (scene.adaptation.estimate_steps > 0 &&
          (!scheme_of(scene.decomposition).iterates_displacements || gives_a_force))
        throw UserError("Adaptation/Estimate steps: received `" +
                        std::to_string(scene.adaptation.estimate_steps) +
                        "`, allowed is 0 but with Decomposition/Scheme = " + displacement_schemes() +
                        " and without a resultant");
    }

    void check_displacement_steps(const Scene &scene)
    {
      if (scene.adaptation.combined)
        throw UserError("Adaptation/Combined: received `true`, which is a step of Decomposition/Scheme = " +
                        displacement_schemes() + " for every mesh; allowed with other schemes is false");
      if (scene.decomposition.stopping_rule == StoppingRule::increment)
        throw UserError(
            "Decomposition/Stopping rule: received `increment`, a rule for Decomposition/Scheme = " +
            displacement_schemes() + "; allowed with other schemes is bound");
    }
  } // namespace

  void check_scheme(const Scene &scene)
  {
    check_number_of_resultants(scene);
    check_estimated_steps(scene);
    const SchemeEntry &scheme = scheme_of(scene.decomposition);
    if (!scheme.solves_exact_contact)
      check_penalties(scene);
    if (!scheme.iterates_displacements)
      check_displacement_steps(scene);
  }
} // namespace abut
