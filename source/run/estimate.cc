// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/adaptation/marking.h>
#include <abut/contact/law_mismatch.h>
#include <abut/run/estimate.h>
#include <abut/trace/applied_traction.h>

namespace abut
{
  namespace
  {
    /// The entries of a vector over a body's contact sides that belong to one of them.
    Eigen::VectorXd on_side(const ContactBody &side, const BodyResult &result, const Eigen::VectorXd &trace)
    {
      return trace.segment(result.body->trace_offset(side.side),
                           static_cast<Eigen::Index>(2 * side.trace->n_nodes()));
    }

    void add_mismatch(const ContactPair &pair, const std::vector<bool> &near,
                      const std::vector<BodyResult> &bodies, ContactMismatch &sum)
    {
      const auto displacement = [&](const ContactBody &side) {
        const BodyResult &result = bodies[side.body];
        return on_side(side, result, result.body->trace_of(result.displacement));
      };
      const auto traction = [&](const ContactBody &side) {
        const BodyResult &result = bodies[side.body];
        return applied_traction(*side.trace, on_side(side, result, result.contact_forces));
      };
      const ContactBody &cut = pair.cut_side(), &other = pair.other_side();
      const LawMismatch mismatch = law_mismatch(pair, near, {displacement(cut), displacement(other)},
                                                {traction(cut), traction(other)});
      sum.law += mismatch.law;
      sum.responses[cut.body] += mismatch.cut_response;
      sum.responses[other.body] += mismatch.other_response;
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

  ContactMismatch contact_mismatch(const InterfaceProblem &problem, const Eigen::VectorXd &pressures,
                                   const std::vector<BodyResult> &bodies)
  {
    ContactMismatch sum{0., std::vector<double>(bodies.size(), 0.)};
    for (std::size_t surface = 0; surface < problem.surfaces().size(); ++surface)
    {
      const ContactSurface &parts = problem.surfaces()[surface];
      std::vector<bool> presses;
      for (const double pressure : problem.of_surface(surface, pressures))
        presses.push_back(pressure > 0.);
      const std::vector<bool> near = parts.near_contact(presses);
      for (const ContactPair &pair : parts.pairs())
        add_mismatch(pair, near, bodies, sum);
    }
    return sum;
  }

  std::vector<CellMarks> mark_all(const Scene &scene, const Estimation &estimation,
                                  const std::vector<BodyResult> &bodies, const std::vector<PairResult> &pairs)
  {
    std::vector<CellMarks> marks;
    for (std::size_t a = 0; a < bodies.size(); ++a)
      marks.push_back(scene.bodies[a].adapt ? mark(estimation.errors[a], estimation.eta[a], scene.adaptation)
                                            : no_marks(bodies[a].body->counts().cells));
    for (const PairResult &pair : pairs)
      mark_missed(scene, pair, bodies, marks);
    return marks;
  }
} // namespace abut
