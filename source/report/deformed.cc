// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/report/apart.h>
#include <abut/report/deformed.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace abut
{
  namespace
  {
    constexpr double visible_share = .05; // of the scene's size

    /// The points of all outlines, their displacements and their cells.
    struct Outlines
    {
      Polyline points, displacements;
      std::vector<unsigned int> cells;
    };

    Outlines outlines_of(const BodyResult &result)
    {
      Outlines outlines;
      result.body->visit_displacement(
          result.displacement, SamplePoints::outline,
          [&](const SamplePoint &point, const Vector2 &u, const Eigen::Matrix2d &) {
            outlines.points.push_back(point.place);
            outlines.displacements.push_back(u);
            outlines.cells.push_back(point.cell);
          });
      return outlines;
    }

    double scene_size(const std::vector<Outlines> &bodies)
    {
      Vector2 low = bodies.front().points.front(), high = low;
      for (const Outlines &body : bodies)
        for (const Vector2 &point : body.points)
        {
          low = low.cwiseMin(point);
          high = high.cwiseMax(point);
        }
      return (high - low).norm();
    }

    /// Of the displacements from their mean.
    double largest_deviation(const Polyline &displacements)
    {
      const Vector2 mean = std::accumulate(displacements.begin(), displacements.end(), Vector2(0., 0.)) /
                           static_cast<double>(displacements.size());
      double largest = 0.;
      for (const Vector2 &u : displacements)
        largest = std::max(largest, (u - mean).norm());
      return largest;
    }

    /// The largest number 1, 2 or 5 times a power of ten that is not above `value`.
    double round_down(const double value)
    {
      const double power = std::pow(10., std::floor(std::log10(value)));
      const double leading = value / power;
      return power * (leading >= 5. ? 5. : leading >= 2. ? 2. : 1.);
    }

    double exaggeration(const std::vector<Outlines> &bodies)
    {
      double largest = 0.;
      for (const Outlines &body : bodies)
        largest = std::max(largest, largest_deviation(body.displacements));
      const double factor = visible_share * scene_size(bodies) / largest;
      return std::isfinite(factor) ? round_down(factor) : 1.;
    }

    DrawnBody drawn_body(const BodyResult &result, const Outlines &outlines, const double factor,
                         const Vector2 &shift)
    {
      DrawnBody body{{}, mean_von_mises(result), result.body->description().is_rigid};
      for (std::size_t i = 0; i < outlines.points.size(); ++i)
      {
        if (i == 0 || outlines.cells[i] != outlines.cells[i - 1])
          body.cells.emplace_back();
        body.cells.back().push_back(outlines.points[i] + factor * outlines.displacements[i] + shift);
      }
      return body;
    }

    /// The displacement at a part's place.
    Vector2 displacement_at(const Trace &side, const Part &part, const Eigen::VectorXd &displacement)
    {
      const Segment &segment = side.segments()[part.segment];
      const Eigen::VectorXd values = side.basis().values(part.s);
      Vector2 sum = Vector2::Zero();
      for (std::size_t i = 0; i < segment.nodes.size(); ++i)
      {
        const auto &dofs = side.node_dofs()[segment.nodes[i]];
        sum += values[static_cast<Eigen::Index>(i)] * Vector2(displacement[dofs[0]], displacement[dofs[1]]);
      }
      return sum;
    }

    /// The parts of a pair, a contact for each stretch.
    void add_contacts(const PairResult &result, const BodyResult &body, const double factor,
                      const Vector2 &shift, std::vector<DrawnContact> &contacts)
    {
      const ContactBody &cut = result.pair->cut_side();
      const auto &neighbours = result.surface->partition().neighbours();
      for (std::size_t i = 0; i < result.parts.size(); ++i)
      {
        const std::size_t k = result.parts[i];
        const bool goes_on =
            i > 0 && std::count(neighbours[k].begin(), neighbours[k].end(), result.parts[i - 1]) > 0;
        if (!goes_on)
          contacts.emplace_back();
        const Part &part = result.part(k);
        contacts.back().nodes.push_back(
            part.place + factor * displacement_at(*cut.trace, part, body.displacement) + shift);
        contacts.back().normals.push_back(
            Trace::averaged_normal(cut.trace->segments()[part.segment], part.s));
        contacts.back().pressures.push_back(result.pressures[static_cast<Eigen::Index>(k)]);
      }
    }
  } // namespace

  std::vector<double> mean_von_mises(const BodyResult &result)
  {
    std::vector<double> means(result.body->counts().cells), areas(means);
    result.body->visit_stress(result.deformation, SamplePoints::energy,
                              [&](const SamplePoint &point, const Stress &stress) {
                                means[point.cell] += point.weight * stress.von_mises();
                                areas[point.cell] += point.weight;
                              });
    for (std::size_t cell = 0; cell < means.size(); ++cell)
      means[cell] /= areas[cell];
    return means;
  }

  DrawnBody undeformed_body(const BodyResult &result)
  {
    return drawn_body(result, outlines_of(result), 0., Vector2::Zero());
  }

  DrawnScene deformed_scene(const Results &results)
  {
    std::vector<Outlines> outlines;
    for (const BodyResult &body : results.bodies)
      outlines.push_back(outlines_of(body));

    DrawnScene scene;
    scene.factor = exaggeration(outlines);
    scene.size = scene_size(outlines);
    const Polyline shifts = shifts_apart(results, scene.factor, scene.size);
    for (std::size_t i = 0; i < outlines.size(); ++i)
      scene.bodies.push_back(drawn_body(results.bodies[i], outlines[i], scene.factor, shifts[i]));
    for (const PairResult &pair : results.pairs)
    {
      const std::size_t body = pair.pair->cut_side().body;
      add_contacts(pair, results.bodies[body], scene.factor, shifts[body], scene.contacts);
    }
    scene.moved_apart =
        std::any_of(shifts.begin(), shifts.end(), [](const Vector2 &shift) { return !shift.isZero(0.); });
    return scene;
  }
} // namespace abut
