// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/vector2.h>
#include <abut/scene/expression.h>

#include <optional>
#include <string>
#include <vector>

namespace abut
{
  /// A smooth piece of an outline, from where the one before ends.
  struct OutlinePiece
  {
    enum class Kind
    {
      line,
      arc, ///< of a circle, a quarter at most
      spline
    };

    std::string side; ///< its name; "" for none
    Kind kind;
    std::vector<Vector2> points; ///< the last is the end; of an arc the first is the centre, of a spline the
                                 ///< first ones lie between
    std::optional<Expression> height = {}; ///< a spline that stands for y = height(x)
  };

  /// A closed curve.
  struct OutlineLoop
  {
    Vector2 start;
    std::vector<OutlinePiece> pieces; ///< the last one ends at the start
  };

  /**
   * Reads what `Outline` says, the boundary of a body in its own frame: closed curves separated by
   * semicolons, the outer one first, then holes. A curve is a point and pieces that go on from it,
   *
   *     (0, 0) -> base: (10, 0) -> arc (12, 5) (10, 10) -> centre (5, 10) (0, 10) -> spline (1, 7) (-1, 3)
   * (0, 0)
   *
   * each a straight line to a point, an arc through a point to another, an arc about a centre to a point (the
   * shorter one), a spline through points or, as `y = 5 - x^2/20 to (-10, 0)`, the graph of a formula in x as
   * far as a point; `close` is the line back to the start. `circle (0, 0) 5` is a whole curve. A name before
   * a piece makes it, with all of the same name, a side. Numbers may be formulas of the file's constants.
   * Throws UserError, beginning with `where`, with the piece that cannot be read, a curve that is open or
   * meets itself or another one, a hole outside.
   */
  std::vector<OutlineLoop> parse_outline(const std::string &text, const Constants &constants,
                                         const std::string &where);
} // namespace abut
