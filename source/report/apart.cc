// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/report/apart.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace abut
{
  namespace
  {
    constexpr double tolerated_share = .01, drawn_distance_share = .02; // of the scene's size

    Vector2 mean_normal(const Trace &side)
    {
      const auto &normals = side.node_normals();
      return std::accumulate(normals.begin(), normals.end(), Vector2(0., 0.)) /
             static_cast<double>(normals.size());
    }

    /// Turned so that the second coordinate is along the unit vector `normal`.
    Polyline turned(Polyline points, const Vector2 &normal)
    {
      for (Vector2 &point : points)
        point = Vector2(normal.y() * point.x() - normal.x() * point.y(), normal.dot(point));
      return points;
    }

    /// Smallest distance along `normal` from the slave's nodes to the master's pieces that face them.
    double drawn_gap(const Polyline &slave_places, const Trace &master, const Polyline &master_places,
                     const Vector2 &normal)
    {
      const Polyline from = turned(slave_places, normal), to = turned(master_places, normal);
      double smallest = std::numeric_limits<double>::infinity();
      for (const Segment &segment : master.segments())
      {
        const Vector2 begin = to[segment.nodes.front()], end = to[segment.nodes.back()];
        if (begin.x() >= end.x()) // a side runs with its body on the left: this piece looks away
          continue;
        for (const Vector2 &place : from)
          if (place.x() >= begin.x() && place.x() <= end.x())
          {
            const double s = (place.x() - begin.x()) / (end.x() - begin.x());
            smallest = std::min(smallest, (1. - s) * begin.y() + s * end.y() - place.y());
          }
      }
      return smallest;
    }

    /// What to add to the master's shift minus the slave's.
    Vector2 separation(const PairResult &result, const std::vector<Eigen::VectorXd> &drawn, const double size)
    {
      const ContactBody &m = result.pair->master();
      const Eigen::VectorXd &of_slave = drawn[result.pair->slave().body], &of_master = drawn[m.body];
      const Trace &slave = *result.pair->slave().trace, &master = *m.trace;
      const Vector2 mean = mean_normal(slave);
      if (mean.norm() < .1) // a closed curve has no direction
        return Vector2::Zero();
      const double gap = drawn_gap(deformed_nodes(slave, of_slave), master, deformed_nodes(master, of_master),
                                   mean.normalized());
      if (!std::isfinite(gap) || gap >= -tolerated_share * size)
        return Vector2::Zero();
      return (drawn_distance_share * size - gap) * mean.normalized();
    }
  } // namespace

  Polyline deformed_nodes(const Trace &side, const Eigen::VectorXd &displacement)
  {
    Polyline places = side.node_points();
    for (std::size_t node = 0; node < places.size(); ++node)
      for (std::size_t component = 0; component < 2; ++component)
        places[node][static_cast<Eigen::Index>(component)] += displacement[side.node_dofs()[node][component]];
    return places;
  }

  Polyline shifts_apart(const Results &results, const std::vector<Eigen::VectorXd> &drawn,
                        const double scene_size)
  {
    // From one body to the next along the pairs.
    Polyline shifts(results.bodies.size(), Vector2::Zero());
    std::vector<bool> placed(results.bodies.size(), false);
    for (std::size_t first = 0; first < placed.size(); ++first)
    {
      placed[first] = true;
      const auto leads_on = [&](const PairResult &result) {
        return placed[result.pair->slave().body] != placed[result.pair->master().body];
      };
      for (auto next = std::find_if(results.pairs.begin(), results.pairs.end(), leads_on);
           next != results.pairs.end();
           next = std::find_if(results.pairs.begin(), results.pairs.end(), leads_on))
      {
        const std::size_t slave = next->pair->slave().body, master = next->pair->master().body;
        const Vector2 apart = separation(*next, drawn, scene_size);
        if (placed[slave])
          shifts[master] = shifts[slave] + apart;
        else
          shifts[slave] = shifts[master] - apart;
        placed[slave] = placed[master] = true;
      }
    }
    return shifts;
  }
} // namespace abut
