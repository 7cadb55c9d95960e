// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/driver/estimation.h>
#include <abut/trace/applied_traction.h>

#include <algorithm>
#include <cmath>

namespace abut
{
  namespace
  {
    /// Zero where there is no stress.
    double by_norm(const double error, const double norm)
    {
      return norm > 0. ? error / norm : 0.;
    }

    void mark_missed(const Scene &scene, const PairResult &result, const std::vector<BodyResult> &bodies,
                     std::vector<CellMarks> &marks)
    {
      const ContactPair &pair = *result.pair;
      const auto mark_segment = [&](const ContactBody &side, const std::size_t segment) {
        if (!scene.bodies[side.body].adapt)
          return;
        const unsigned int cell = bodies[side.body].body->contact_sides()[side.side].segments()[segment].cell;
        marks[side.body].refine[cell] = true;
        marks[side.body].coarsen[cell] = false;
      };
      for (const MissedContact &missed : result.missed)
      {
        mark_segment(pair.cut_side(), missed.piece.cut_segment);
        mark_segment(pair.other_side(), missed.piece.other_segment);
      }
    }
  } // namespace

  double Estimation::energy_error() const
  {
    double square = 0.;
    for (const CellErrors &body : errors)
      square += body.energy.squaredNorm();
    return std::sqrt(square);
  }

  double Estimation::energy_norm() const
  {
    double square = 0.;
    for (const CellErrors &body : errors)
      square += body.energy_norm * body.energy_norm;
    return std::sqrt(square);
  }

  double Estimation::discretisation() const
  {
    return by_norm(energy_error(), energy_norm());
  }

  std::optional<double> Estimation::energy_bound() const
  {
    if (!law_mismatch)
      return {};
    const double b = energy_error();
    return .5 * b + std::sqrt(.25 * b * b + *law_mismatch);
  }

  std::optional<double> Estimation::bound() const
  {
    const std::optional<double> bound = energy_bound();
    return bound ? std::optional<double>(by_norm(*bound, energy_norm())) : bound;
  }

  double Estimation::stress() const
  {
    double square = 0.;
    for (const CellErrors &body : errors)
      square += body.stress_norm * body.stress_norm;
    return by_norm(stress_error(), std::sqrt(square));
  }

  double Estimation::stress_error() const
  {
    double square = 0.;
    for (const CellErrors &body : errors)
      square += body.stress.squaredNorm();
    return std::sqrt(square);
  }

  BoundaryCost Estimation::boundary_cost() const
  {
    BoundaryCost cost;
    for (const CellErrors &body : errors)
      cost += body.boundary;
    return cost;
  }

  double Estimation::eta_max(const Scene &scene) const
  {
    const bool some_adapt = std::any_of(scene.bodies.begin(), scene.bodies.end(),
                                        [](const BodyDescription &body) { return body.adapt; });
    double largest = 0.;
    for (std::size_t a = 0; a < eta.size(); ++a)
      if (scene.bodies[a].adapt || !some_adapt)
        largest = std::max(largest, eta[a].maxCoeff());
    return largest;
  }

  Estimation estimate(const Indicator &indicator, const AdaptationParameters &parameters,
                      const std::vector<BodyResult> &bodies)
  {
    Estimation estimation;
    estimation.errors.resize(bodies.size());
    estimation.eta.resize(bodies.size());
    for_each_body(bodies.size(), [&](const std::size_t a) {
      estimation.errors[a] =
          indicator.estimate({*bodies[a].body, bodies[a].deformation, bodies[a].contact_forces});
      estimation.eta[a] = relative_errors(estimation.errors[a], parameters.normalisation);
    });
    return estimation;
  }

  double law_mismatch(const std::vector<const ContactPair *> &pairs, const std::vector<BodyResult> &bodies)
  {
    double sum = 0.;
    for (const ContactPair *pair : pairs)
    {
      const auto on_side = [&](const ContactBody &side, const Eigen::VectorXd &trace) -> Eigen::VectorXd {
        return trace.segment(bodies[side.body].body->trace_offset(side.side),
                             static_cast<Eigen::Index>(2 * side.trace->n_nodes()));
      };
      const auto displacement = [&](const ContactBody &side) {
        return on_side(side, bodies[side.body].body->trace_of(bodies[side.body].displacement));
      };
      const ContactBody &cut = pair->cut_side();
      sum += pair->law_mismatch(displacement(cut), displacement(pair->other_side()),
                                applied_traction(*cut.trace, on_side(cut, bodies[cut.body].contact_forces)));
    }
    return sum;
  }

  std::vector<CellMarks> mark_all(const Scene &scene, const Estimation &estimation,
                                  const std::vector<BodyResult> &bodies, const std::vector<PairResult> &pairs)
  {
    std::vector<CellMarks> marks;
    for (std::size_t a = 0; a < bodies.size(); ++a)
      marks.push_back(scene.bodies[a].adapt ? mark(estimation.errors[a], estimation.eta[a], scene.adaptation)
                                            : no_marks(bodies[a].body->space().mesh().triangulation));
    for (const PairResult &pair : pairs)
      mark_missed(scene, pair, bodies, marks);
    return marks;
  }
} // namespace abut
