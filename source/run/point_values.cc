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

    /// Whether a body has the points that it is asked for.
    std::vector<char> has_points(const std::vector<OutputPoint> &points, const Body &body)
    {
      std::vector<char> has;
      for (const OutputPoint &point : points)
        has.push_back(is_asked(point, body) && !body.cells_at(point.place).empty());
      return has;
    }

    /// At the points that a body has.
    std::vector<PointResult> values_of(const std::vector<OutputPoint> &points, const BodyResult &result)
    {
      std::vector<PointResult> values;
      for (std::size_t i = 0; i < points.size(); ++i)
        if (is_asked(points[i], *result.body))
          if (const auto stress = result.body->stress_at(result.deformation, points[i].place))
            values.push_back({result.body, i + 1, points[i].place,
                              result.body->displacement_at(result.displacement, points[i].place), *stress,
                              result.body->stresses_at(result.deformation, points[i].place)});
      return values;
    }
  } // namespace

  void check_output_points(const Scene &scene, const Model &model)
  {
    const std::vector<OutputPoint> &points = scene.output_points;
    if (points.empty())
      return;
    const auto has = model.executor().of_bodies(
        model.bodies().size(), [&](const std::size_t a) { return has_points(points, *model.bodies()[a]); });
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const OutputPoint &point = points[i];
      if (!point.body.empty() && scene.body_index(point.body) == scene.bodies.size())
        throw UserError("Output/Points: received `" + text_of(point) +
                        "`, but there is no body of this name");
      if (std::none_of(has.begin(), has.end(), [&](const auto &of_body) { return of_body[i]; }))
        throw UserError("Output/Points: received `" + text_of(point) + "`, but " +
                        (point.body.empty() ? "no elastic body" : "body " + point.body) + " has " +
                        (point.body.empty() ? "this point" : "no such point of its mesh"));
    }
  }

  std::vector<PointResult> point_values(const Scene &scene, const std::vector<BodyResult> &bodies,
                                        const Executor &executor)
  {
    if (scene.output_points.empty())
      return {};
    auto of_bodies = executor.of_bodies(
        bodies.size(), [&](const std::size_t a) { return values_of(scene.output_points, bodies[a]); });
    std::vector<PointResult> values;
    for (std::size_t a = 0; a < bodies.size(); ++a)
      for (PointResult &value : of_bodies[a])
      {
        value.body = bodies[a].body;
        values.push_back(std::move(value));
      }
    std::stable_sort(values.begin(), values.end(),
                     [](const PointResult &a, const PointResult &b) { return a.number < b.number; });
    return values;
  }
} // namespace abut
