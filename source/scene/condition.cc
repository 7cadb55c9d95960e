// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/text.h>
#include <abut/scene/condition.h>

#include <algorithm>
#include <sstream>

namespace abut
{
  namespace
  {
    const Choices<ConditionKind> condition_kinds{
        {"displacement", ConditionKind::displacement},
        {"displacement x", ConditionKind::displacement_x},
        {"displacement y", ConditionKind::displacement_y},
        {"normal displacement", ConditionKind::normal_displacement},
        {"tangential displacement", ConditionKind::tangential_displacement},
        {"traction", ConditionKind::traction},
        {"pressure", ConditionKind::pressure},
        {"resultant", ConditionKind::resultant}};

    /// Kinds that take a displacement along axes, and so hold at points and take exact values.
    bool is_displacement(const ConditionKind kind)
    {
      return kind == ConditionKind::displacement || kind == ConditionKind::displacement_x ||
             kind == ConditionKind::displacement_y;
    }

    void check_number_of_expressions(const Condition &condition, const std::string &where)
    {
      const std::size_t n = condition.expressions.size();
      const bool is_vector =
          condition.kind == ConditionKind::displacement || condition.kind == ConditionKind::traction;
      const bool is_either = condition.kind == ConditionKind::resultant;
      if (n == (is_vector ? 2 : 1) || (is_either && n == 2))
        return;
      const std::string needed = is_either   ? "one (along the outward normal) or two expressions"
                                 : is_vector ? "two expressions"
                                             : "one expression";
      throw UserError(where + ": `" + to_string(condition.kind) + "` needs " + needed + ", received " +
                      std::to_string(n));
    }

    void check_resultant(const Condition &condition, const std::string &where)
    {
      for (const auto &expression : condition.expressions)
        if (condition.kind == ConditionKind::resultant && !expression.is_constant())
          throw UserError(where + ": the resultant `" + expression.text() +
                          "` depends on x or y, allowed are numbers and constants");
    }

    void parse_expressions(const std::string &text, const Constants &constants, const std::string &where,
                           Condition &condition)
    {
      condition.exact = text == "exact";
      if (condition.exact)
      {
        if (!is_displacement(condition.kind))
          throw UserError(where + ": received `exact` for `" + to_string(condition.kind) +
                          "`, allowed are displacement, displacement x, displacement y");
        return;
      }
      for (const auto &piece : split_outside_parentheses(text, ','))
        condition.expressions.emplace_back(piece, constants, where);
      check_number_of_expressions(condition, where);
      check_resultant(condition, where);
    }

    Condition parse_condition(const std::string &text, const Constants &constants, const std::string &where)
    {
      const auto first = text.find(':');
      const auto second = first == std::string::npos ? first : text.find(':', first + 1);
      if (second == std::string::npos)
        throw UserError(where + ": received `" + text + "`, a condition is written id: kind: expressions");

      Condition condition;
      condition.boundary = trim(text.substr(0, first));
      if (condition.boundary.empty() || condition.boundary.front() != '(')
        condition.boundary = name_of_sides(condition.boundary);
      if (condition.boundary.empty())
        throw UserError(where + ": received `" + text + "`, which names no boundary before its first colon");
      const std::string here = where + ": " + condition.boundary;
      condition.kind = choose(condition_kinds, trim(text.substr(first + 1, second - first - 1)), here);
      parse_expressions(trim(text.substr(second + 1)), constants, here, condition);
      if (condition.boundary.front() == '(')
      {
        condition.point = constant_point(condition.boundary, constants, where);
        if (!is_displacement(condition.kind))
          throw UserError(here + ": received `" + to_string(condition.kind) +
                          "` at a point, allowed are displacement, displacement x, displacement y");
      }
      return condition;
    }

    bool same_place(const Condition &a, const Condition &b)
    {
      if (a.point && b.point)
        return *a.point == *b.point;
      return a.boundary == b.boundary;
    }
  } // namespace

  std::vector<Condition> parse_conditions(const std::string &text, const Constants &constants,
                                          const std::string &where)
  {
    std::vector<Condition> conditions;
    std::istringstream stream(text);
    for (std::string piece; std::getline(stream, piece, ';');)
    {
      if (trim(piece).empty())
        continue;
      const Condition next = parse_condition(trim(piece), constants, where);
      for (const auto &earlier : conditions)
        if (earlier.kind == next.kind && same_place(earlier, next))
          throw UserError(where + ": `" + next.boundary + ": " + to_string(next.kind) +
                          "` is given twice, once is allowed");
      conditions.push_back(next);
    }
    return conditions;
  }

  bool varies(const Condition &condition)
  {
    return condition.exact ||
           !std::all_of(condition.expressions.begin(), condition.expressions.end(),
                        [](const Expression &expression) { return expression.is_constant(); });
  }

  std::string to_string(const ConditionKind kind)
  {
    return word_of(condition_kinds, kind);
  }

  bool is_support(const ConditionKind kind)
  {
    return kind != ConditionKind::traction && kind != ConditionKind::pressure;
  }
} // namespace abut
