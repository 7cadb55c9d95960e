// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/base/user_error.h>
#include <abut/run/point_values.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    bool is_asked(const OutputPoint &point, const Body &body)
    {
      return point.body.empty() || point.body == body.name();
    }

    std::string text_of(const OutputPoint &point)
    {
      return (point.body.empty() ? "" : point.body + ": ") + "(" + exact_number(point.place.x()) + ", " +
             exact_number(point.place.y()) + ")";
    }
  } // namespace

  void check_output_points(const Scene &scene, const Model &model)
  {
    const auto &bodies = model.bodies();
    for (const OutputPoint &point : scene.output_points)
    {
      if (!point.body.empty() && scene.body_index(point.body) == scene.bodies.size())
        throw UserError("Output/Points: received `" + text_of(point) +
                        "`, but there is no body of this name");
      if (std::none_of(bodies.begin(), bodies.end(), [&](const auto &body) {
            return is_asked(point, *body) && !body->cells_at(point.place).empty();
          }))
        throw UserError("Output/Points: received `" + text_of(point) + "`, but " +
                        (point.body.empty() ? "no elastic body" : "body " + point.body) + " has " +
                        (point.body.empty() ? "this point" : "no such point of its mesh"));
    }
  }

  std::vector<PointResult> point_values(const Scene &scene, const std::vector<BodyResult> &bodies)
  {
    std::vector<PointResult> values;
    for (std::size_t i = 0; i < scene.output_points.size(); ++i)
    {
      const OutputPoint &point = scene.output_points[i];
      for (const BodyResult &result : bodies)
        if (is_asked(point, *result.body))
          if (const auto stress = result.body->stress_at(result.deformation, point.place))
            values.push_back({result.body, i + 1, point.place,
                              result.body->displacement_at(result.displacement, point.place), *stress,
                              result.body->stresses_at(result.deformation, point.place)});
    }
    return values;
  }
} // namespace abut
