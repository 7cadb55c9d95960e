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
    /// The points of all outlines, a field's displacements there, and their cells.
    struct Outlines
    {
      Polyline points, displacements;
      std::vector<unsigned int> cells;

      void serialize(Archive &archive) { archive(points, displacements, cells); }
    };

    Outlines outlines_of(const Body &body, const Eigen::VectorXd &field)
    {
      Outlines outlines;
      body.visit_displacement(field, SamplePoints::outline,
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

    /// From the mean deformation of its body.
    double largest_deviation(const std::vector<Outlines> &deformations)
    {
      double largest = 0.;
      for (const Outlines &body : deformations)
        largest = std::max(largest, largest_deviation(body.displacements));
      return largest;
    }

    /// The displacement as it is drawn.
    Eigen::VectorXd exaggerated(const BodyResult &result, const Exaggeration &factors)
    {
      return factors.deformation * result.deformation +
             factors.rigid * (result.displacement - result.deformation);
    }

    /// `drawn`: the displacement as it is drawn.
    DrawnBody drawn_body(const BodyResult &result, const Eigen::VectorXd &drawn, const Vector2 &shift)
    {
      const Outlines outlines = outlines_of(*result.body, drawn);
      DrawnBody body{{}, mean_von_mises(result), result.body->description().is_rigid};
      for (std::size_t i = 0; i < outlines.points.size(); ++i)
      {
        if (i == 0 || outlines.cells[i] != outlines.cells[i - 1])
          body.cells.emplace_back();
        body.cells.back().push_back(outlines.points[i] + outlines.displacements[i] + shift);
      }
      return body;
    }

    /// The parts of a pair, a contact for each stretch.
    void add_contacts(const PairResult &result, const Eigen::VectorXd &drawn, const Vector2 &shift,
                      std::vector<DrawnContact> &contacts)
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
        const Segment &segment = cut.trace->segments()[part.segment];
        contacts.back().nodes.push_back(part.place + cut.trace->displacement(segment, part.s, drawn) + shift);
        contacts.back().normals.push_back(Trace::averaged_normal(segment, part.s));
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
    return drawn_body(result, Eigen::VectorXd::Zero(result.displacement.size()), Vector2::Zero());
  }

  DrawnScene deformed_scene(const Results &results, const Executor &executor)
  {
    const std::size_t n_bodies = results.bodies.size();
    const std::vector<Outlines> deformations = executor.of_bodies(n_bodies, [&](const std::size_t a) {
      return outlines_of(*results.bodies[a].body, results.bodies[a].deformation);
    });

    DrawnScene scene;
    scene.size = scene_size(deformations);
    scene.exaggeration = exaggeration_of(results.pairs, largest_deviation(deformations), scene.size);
    std::vector<Eigen::VectorXd> drawn;
    for (const BodyResult &body : results.bodies)
      drawn.push_back(exaggerated(body, scene.exaggeration));
    const Polyline shifts = shifts_apart(results, drawn, scene.size);
    scene.bodies = executor.of_bodies(
        n_bodies, [&](const std::size_t a) { return drawn_body(results.bodies[a], drawn[a], shifts[a]); });
    for (const PairResult &pair : results.pairs)
    {
      const std::size_t body = pair.pair->cut_side().body;
      add_contacts(pair, drawn[body], shifts[body], scene.contacts);
    }
    scene.moved_apart =
        std::any_of(shifts.begin(), shifts.end(), [](const Vector2 &shift) { return !shift.isZero(0.); });
    return scene;
  }

  std::string deformation_caption(const DrawnScene &scene)
  {
    return exaggeration_text(scene.exaggeration, !scene.contacts.empty()) +
           (scene.moved_apart ? "; bodies drawn apart" : "");
  }
} // namespace abut
