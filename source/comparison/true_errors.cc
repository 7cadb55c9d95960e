// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/comparison/stress_samples.h>
#include <abut/comparison/true_errors.h>
#include <abut/results/results.h>

#include <deal.II/base/exceptions.h>

#include <cmath>

namespace abut
{
  namespace
  {
    /// Integrals over a body.
    struct Squares
    {
      double energy_error = 0., energy = 0., stress_error = 0., stress = 0.;

      void operator+=(const Squares &other)
      {
        energy_error += other.energy_error;
        energy += other.energy;
        stress_error += other.stress_error;
        stress += other.stress;
      }
      void serialize(Archive &archive) { archive(energy_error, energy, stress_error, stress); }
    };

    Squares compare(const OwnStress &exact, const BodyResult &result)
    {
      const std::vector<StressSample> samples = precise_samples(result);
      const std::vector<CellInfo> cells = result.body->cells();
      const std::vector<Stress> stresses = at_samples(exact, samples);
      Squares squares;
      for (std::size_t i = 0; i < samples.size(); ++i)
      {
        const Stress error = samples[i].computed - stresses[i];
        const double weight = samples[i].weight;
        const Material &material = cells[samples[i].cell].material;
        squares.energy_error += weight * material.energy_density(error);
        squares.energy += weight * material.energy_density(stresses[i]);
        squares.stress_error += weight * error.square();
        squares.stress += weight * stresses[i].square();
      }
      return squares;
    }

    /// Of the reported pressures, over what the pair covers.
    double pressure_error(const std::function<double(const Vector2 &)> &exact_pressure,
                          const PairResult &pair, const Placement &placement)
    {
      const GaussRule rule(8);
      const Trace &cut = *pair.pair->cut_side().trace;
      const Partition &partition = pair.surface->partition();
      Assert(pair.pressures.allFinite(), dealii::ExcMessage("contact pressures are finite"));
      double error = 0., norm = 0.;
      for (const Piece &piece : partition.pieces())
      {
        if (piece.link != pair.pair->link())
          continue;
        const Segment &segment = cut.segments()[piece.cut_segment];
        for (Eigen::Index q = 0; q < rule.points.size(); ++q)
        {
          const double s = piece.start + (piece.end - piece.start) * rule.points[q];
          const double arc = piece.arc + (s - piece.start) * segment.length;
          const double computed = pair.curve->at(piece.part, arc);
          const double exact = exact_pressure(placement.point_to_own(cut.point(segment, s)));
          const double weight = rule.weights[q] * (piece.end - piece.start) * cut.tangent(segment, s).norm();
          error += weight * (computed - exact) * (computed - exact);
          norm += weight * exact * exact;
        }
      }
      return std::sqrt(error / norm);
    }

    const Placement &slave_placement(const Scene &scene, const PairResult &pair)
    {
      return scene.bodies[pair.pair->slave().body].placement;
    }
  } // namespace

  TrueErrors true_errors(const ExactSolution &exact, const Scene &scene,
                         const std::vector<BodyResult> &bodies, const std::vector<PairResult> &pairs,
                         const Executor &executor)
  {
    AssertDimension(bodies.size(), scene.bodies.size());
    TrueErrors errors;
    if (exact.stress(0))
    {
      Squares squares;
      for (const Squares &of_body : executor.of_bodies(
               bodies.size(), [&](const std::size_t a) { return compare(exact.stress(a), bodies[a]); }))
        squares += of_body;
      errors.energy = std::sqrt(squares.energy_error / squares.energy);
      errors.stress = std::sqrt(squares.stress_error / squares.stress);
    }
    if (pairs.empty())
      return errors;
    const PairResult &pair = pairs.front();
    const Placement &slave = slave_placement(scene, pair);
    if (const auto pressure = exact.pressure())
      errors.pressure = pressure_error(pressure, pair, slave);
    if (const auto force = exact.force())
      errors.force = std::abs(pair.normal_force / slave.length_to_world(*force) - 1.);
    return errors;
  }

  void add_exact_pressures(const ExactSolution &exact, const Scene &scene, std::vector<PairResult> &pairs)
  {
    const auto pressure = exact.pressure();
    if (pairs.empty() || !pressure)
      return;
    PairResult &pair = pairs.front();
    const Placement &placement = slave_placement(scene, pair);
    const Trace &cut = *pair.pair->cut_side().trace;
    for (const Piece &piece : pair.surface->partition().pieces())
    {
      if (piece.link != pair.pair->link())
        continue;
      const Segment &segment = cut.segments()[piece.cut_segment];
      for (const double share : {0., .25, .5, .75, 1.})
      {
        const double s = piece.start + share * (piece.end - piece.start);
        pair.exact_pressures.emplace_back(segment.arc_start + s * segment.length,
                                          pressure(placement.point_to_own(cut.point(segment, s))));
      }
    }
  }
} // namespace abut
