// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/vector2.h>

#include <functional>
#include <map>
#include <string>

namespace abut
{
  /// Names usable in every expression of a file, and their values.
  using Constants = std::map<std::string, double>;

  /**
   * A formula in the own-frame coordinates x and y, the constants of the file and pi, as muParser reads it
   * (`if(x<1, a, b)`, `x^2`, `sin(pi*x)`). Evaluation is safe from several threads.
   */
  class Expression
  {
  public:
    /// Throws UserError, beginning with `where`, when the text is not a formula.
    Expression(const std::string &text, const Constants &constants, const std::string &where);

    /// A function given by the program; `text` stands for it in messages.
    Expression(const std::function<double(const Vector2 &)> &function, const std::string &text,
               const std::string &where);

    /// Throws UserError when the value is not finite.
    double operator()(const Vector2 &own_point) const;
    const std::string &text() const { return text_; }
    /// Whether neither x nor y occurs in the formula.
    bool is_constant() const;

  private:
    std::string text_;
    std::string where_;
    std::function<double(const Vector2 &)> function_;
  };

  /// The value of a formula of constants alone. Throws UserError, beginning with `where`, also for x and y.
  double constant_value(const std::string &text, const Constants &constants, const std::string &where);

  /// The point `(x, y)`, two such values.
  Vector2 constant_point(const std::string &text, const Constants &constants, const std::string &where);
} // namespace abut
