// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/text.h>
#include <abut/scene/expression.h>

#include <deal.II/base/function_parser.h>

#include <cmath>
#include <iostream>
#include <memory>
#include <regex>

namespace abut
{
  namespace
  {
    /// deal.II prints a parser's complaint on std::cerr and then throws it: here the exception is enough.
    class SilentErrorStream
    {
    public:
      SilentErrorStream() : buffer_(std::cerr.rdbuf(nullptr)) {}
      ~SilentErrorStream() { std::cerr.rdbuf(buffer_); }
      SilentErrorStream(const SilentErrorStream &) = delete;
      SilentErrorStream &operator=(const SilentErrorStream &) = delete;

    private:
      std::streambuf *buffer_;
    };

    /// What muParser and deal.II would take for something else than one formula; empty if nothing.
    std::string misleading_part(const std::string &text)
    {
      if (text.empty())
        return "it is empty";
      if (split_outside_parentheses(text, ',').size() > 1)
        return "it has a comma outside parentheses";
      if (text.find(';') != std::string::npos)
        return "it has a semicolon";
      static const std::regex assignment("(^|[^<>=!])=([^=]|$)"); // one takes longer to build than to search
      if (std::regex_search(text, assignment))
        return "it has an assignment, where == compares";
      return "";
    }
    /// The complaint without the column in front of it, which is the component's number.
    std::string complaint(const dealii::ExceptionBase &exception)
    {
      return std::regex_replace(one_line(exception), std::regex("^Parsing Error.*The parser said: "), "");
    }
  } // namespace

  Expression::Expression(const std::string &text, const Constants &constants, const std::string &where)
      : text_(trim(text)), where_(where)
  {
    const std::string begin = where_ + ": `" + text_ + "` is not a formula: ";
    const std::string reason = misleading_part(text_);
    if (!reason.empty())
      throw UserError(begin + reason);

    Constants all = constants;
    all["pi"] = std::acos(-1.);
    try
    {
      const SilentErrorStream silent;
      const auto parser = std::make_shared<dealii::FunctionParser<2>>();
      parser->initialize("x,y", text_, all);
      parser->value(dealii::Point<2>()); // the text is only read now
      function_ = [parser](const Vector2 &point) {
        return parser->value(dealii::Point<2>(point.x(), point.y()));
      };
    }
    catch (const dealii::ExceptionBase &exception)
    {
      throw UserError(begin + complaint(exception));
    }
  }

  Expression::Expression(const std::function<double(const Vector2 &)> &function, const std::string &text,
                         const std::string &where)
      : text_(text), where_(where), function_(function)
  {}

  double Expression::operator()(const Vector2 &own_point) const
  {
    const double value = function_(own_point);
    if (!std::isfinite(value))
      throw UserError(where_ + ": `" + text_ + "` has no finite value at (" + std::to_string(own_point.x()) +
                      ", " + std::to_string(own_point.y()) + ") of the body's own frame");
    return value;
  }

  bool Expression::is_constant() const
  {
    static const std::regex coordinate("(^|[^A-Za-z0-9_.])[xy]($|[^A-Za-z0-9_])");
    return !std::regex_search(text_, coordinate);
  }

  double constant_value(const std::string &text, const Constants &constants, const std::string &where)
  {
    const Expression expression(text, constants, where);
    if (!expression.is_constant())
      throw UserError(where + ": `" + expression.text() +
                      "` depends on x or y, allowed are numbers and constants");
    return expression(Vector2::Zero());
  }

  Vector2 constant_point(const std::string &text, const Constants &constants, const std::string &where)
  {
    const auto coordinates = text.back() == ')'
                                 ? split_outside_parentheses(text.substr(1, text.size() - 2), ',')
                                 : std::vector<std::string>();
    if (coordinates.size() != 2)
      throw UserError(where + ": received the point `" + text + "`, a point is written (x, y)");
    return {constant_value(coordinates[0], constants, where),
            constant_value(coordinates[1], constants, where)};
  }
} // namespace abut
