// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/driver/true_errors.h>

#include <cmath>

namespace abut
{
  namespace
  {
    /// Sums of squares over the bodies.
    struct Squares
    {
      double energy_error = 0., energy = 0., stress_error = 0., stress = 0.;

      void add(const Material &material, const Stress &computed, const Stress &exact, const double weight)
      {
        const Stress error = computed - exact;
        energy_error += weight * material.energy_density(error);
        energy += weight * material.energy_density(exact);
        stress_error += weight * error.square();
        stress += weight * exact.square();
      }
    };

    void add_body(const LayersReference &reference, const std::size_t index, const BodyResult &result,
                  Squares &squares)
    {
      const Space &space = result.body->space();
      visit_gradients(
          space, gauss_rule(space, space.degree() + 2), result.deformation,
          [&](const Vector2 &point, const double weight, const Vector2 &, const Eigen::Matrix2d &gradient) {
            const Material material = result.body->material();
            const Placement &placement = result.body->description().placement;
            Eigen::Matrix2d turn;
            turn << placement.direction_to_world(Vector2::UnitX()),
                placement.direction_to_world(Vector2::UnitY());
            squares.add(material, material.stress(turn.transpose() * gradient * turn),
                        reference.stress(index, placement.point_to_own(point)), weight);
          });
    }

    double pressure_error(const LayersReference &reference, const PairResult &pair,
                          const Placement &placement)
    {
      const GaussRule rule(8);
      double error = 0., norm = 0.;
      for (const Segment &segment : pair.slave->segments())
        for (Eigen::Index q = 0; q < rule.points.size(); ++q)
        {
          const double s = rule.points[q];
          const Eigen::VectorXd values = pair.slave->basis().values(s);
          double computed = 0.;
          for (std::size_t i = 0; i < segment.nodes.size(); ++i)
            computed += values[static_cast<Eigen::Index>(i)] * pair.pressures[segment.nodes[i]];
          const double exact = reference.pressure(placement.point_to_own(pair.slave->point(segment, s)));
          const double weight = rule.weights[q] * segment.length;
          error += weight * (computed - exact) * (computed - exact);
          norm += weight * exact * exact;
        }
      return std::sqrt(error / norm);
    }
  } // namespace

  TrueErrors true_errors(const LayersReference &reference, const Results &results)
  {
    Squares squares;
    for (std::size_t a = 0; a < results.bodies.size(); ++a)
      add_body(reference, a, results.bodies[a], squares);
    const PairResult &pair = results.pairs.front();
    const Placement &slave = results.scene->bodies[pair.pair->slave().body].placement;
    TrueErrors errors;
    errors.energy = std::sqrt(squares.energy_error / squares.energy);
    errors.stress = std::sqrt(squares.stress_error / squares.stress);
    errors.pressure = pressure_error(reference, pair, slave);
    const double force = slave.length_to_world(reference.force());
    errors.force = std::abs(pair.normal_force - force) / force;
    return errors;
  }
} // namespace abut
