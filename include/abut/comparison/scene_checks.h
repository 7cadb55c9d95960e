// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/comparison/exact_solution.h>
#include <abut/reference/exact_stress.h>

namespace abut
{
  /// Whether two numbers are the same but for rounding.
  bool agree(double a, double b);

  /// The condition of a kind on a side; null where there is none.
  const Condition *find_condition(const BodyDescription &body, const std::string &boundary,
                                  ConditionKind kind);

  /// What is said of the datum `Force` of Reference.
  constexpr auto pressing_force =
      "P, what presses the bodies together; the whole of it where the scene is one half";

  inline Stress to_stress(const ExactStress &s)
  {
    return {s.xx, s.yy, s.xy, s.zz};
  }

  /// Checks that a scene is that of the exact solution it names; what fails is a UserError with the solution.
  class SceneChecks
  {
  public:
    explicit SceneChecks(const ReferenceParameters &reference) : solution_(reference.solution) {}

    /// `what`: the difference between the scene and the solution, with what is needed.
    void require(bool holds, const std::string &what) const;
    /// The value of a condition that must be one number all along the side (its first component, or another).
    double constant(const BodyDescription &body, const Condition &condition, std::size_t component = 0) const;
    /// `side: normal displacement: 0`.
    void require_roller(const BodyDescription &body, const std::string &side) const;
    /// `side: displacement: exact`.
    void require_exact(const BodyDescription &body, const std::string &side) const;
    void require_no_body_force(const BodyDescription &body) const;
    /// One body of a shape and no contact.
    void require_single_body(const Scene &scene, const std::string &shape) const;
    /// Two bodies and a contact between them.
    void require_pair(const Scene &scene) const;
    /// No conditions but the `n` looked at.
    void require_no_further_conditions(const BodyDescription &body, std::size_t n) const;

  private:
    std::string solution_;
  };
} // namespace abut
