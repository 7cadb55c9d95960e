// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/text.h>
#include <abut/base/user_error.h>
#include <abut/scene/mesh_size.h>

namespace abut
{
  MeshSize parse_mesh_size(const std::string &text, const Constants &constants, const std::string &where)
  {
    MeshSize size;
    const auto length = [&](const std::string &formula, const bool may_be_zero) {
      const double value = constant_value(formula, constants, where);
      if (!(value > 0. || (may_be_zero && value == 0.)))
        throw UserError(where + ": received `" + text + "`, allowed are sizes above 0, as in " +
                        "`2; bore: 0.5; (10, 0): 0.1`");
      return value;
    };
    unsigned int n_everywhere = 0;
    for (const std::string &piece : split_outside_parentheses(text, ';'))
    {
      const auto place = split_outside_parentheses(piece, ':');
      if (place.size() == 1 && n_everywhere++ > 0)
        throw UserError(where + ": received `" + text +
                        "`, allowed is one size without a place, the largest; the others belong to sides or "
                        "points, as in `2; bore: 0.5`");
      if (place.size() == 1)
        size.everywhere = length(piece, true);
      else if (place[0].empty() || place.size() > 2)
        throw UserError(where + ": received `" + piece +
                        "`, allowed is a side or a point (x, y), a colon and "
                        "a size");
      else if (place[0].front() == '(')
        size.at_points.emplace_back(constant_point(place[0], constants, where), length(place[1], false));
      else
        size.on_sides.emplace_back(place[0], length(place[1], false));
    }
    return size;
  }
} // namespace abut
