// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bodies/finite_elements/stress_field.h>
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

    /// Points around a reference cell, counter-clockwise; several on each edge for degrees above 1.
    dealii::Quadrature<2> outline_points(const Space &space)
    {
      const std::vector<dealii::Point<2>> triangle = {{0., 0.}, {1., 0.}, {0., 1.}};
      const std::vector<dealii::Point<2>> square = {{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}};
      const auto &corners = space.mesh().cell_type == CellType::triangles ? triangle : square;
      const unsigned int pieces = space.degree() == 1 ? 1 : 2 * space.degree();
      std::vector<dealii::Point<2>> points;
      for (std::size_t corner = 0; corner < corners.size(); ++corner)
        for (unsigned int piece = 0; piece < pieces; ++piece)
        {
          const auto &begin = corners[corner], &end = corners[(corner + 1) % corners.size()];
          points.push_back(begin + (static_cast<double>(piece) / pieces) * (end - begin));
        }
      return dealii::Quadrature<2>(points);
    }

    /// The points of all outlines and their displacements, cell by cell.
    struct Outlines
    {
      std::size_t points_per_cell = 0;
      Polyline points, displacements;
    };

    Outlines outlines_of(const BodyResult &result)
    {
      Outlines outlines;
      const dealii::Quadrature<2> points = outline_points(result.body->space());
      outlines.points_per_cell = points.size();
      visit_gradients(result.body->space(), points, result.displacement,
                      [&](const Vector2 &point, double, const Vector2 &u, const Eigen::Matrix2d &) {
                        outlines.points.push_back(point);
                        outlines.displacements.push_back(u);
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
      DrawnBody body{{}, mean_von_mises(result)};
      for (std::size_t i = 0; i < outlines.points.size(); ++i)
      {
        if (i % outlines.points_per_cell == 0)
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
    const Space &space = result.body->space();
    std::vector<double> means(space.mesh().triangulation.n_active_cells());
    double area = 0.;
    std::size_t visited = 0;
    StressField(*result.body, result.deformation)
        .visit(space.quadrature(), [&](const Vector2 &, const double weight, const Stress &stress) {
          double &mean = means[visited / space.quadrature().size()];
          mean += weight * stress.von_mises();
          area += weight;
          if (++visited % space.quadrature().size() == 0)
          {
            mean /= area;
            area = 0.;
          }
        });
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
