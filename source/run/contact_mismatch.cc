// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/run/contact_mismatch.h>
#include <abut/trace/applied_traction.h>

namespace abut
{
  namespace
  {
    /// A rigid body has no cells.
    void add_to_cells(const Trace &trace, const Eigen::VectorXd &of_segments, Eigen::VectorXd &cells)
    {
      if (cells.size() == 0)
        return;
      for (std::size_t i = 0; i < trace.segments().size(); ++i)
        cells[trace.segments()[i].cell] += of_segments[static_cast<Eigen::Index>(i)];
    }

    void add_mismatch(const ContactPair &pair, const LawMismatch &mismatch, ContactMismatch &sum)
    {
      const ContactBody &cut = pair.cut_side(), &other = pair.other_side();
      sum.law += mismatch.law;
      sum.responses[cut.body] += mismatch.cut_response;
      sum.responses[other.body] += mismatch.other_response;
      add_to_cells(*cut.trace, mismatch.of_cut_segments, sum.cells[cut.body]);
      add_to_cells(*other.trace, mismatch.of_other_segments, sum.cells[other.body]);
    }
  } // namespace

  LawMismatch mismatch_of(const ContactPair &pair, const std::vector<bool> &near,
                          const std::vector<BodyResult> &bodies)
  {
    const auto displacement = [&](const ContactBody &side) {
      const BodyResult &result = bodies[side.body];
      return result.body->of_side(result.body->trace_of(result.displacement), side.side);
    };
    const auto traction = [&](const ContactBody &side) {
      const BodyResult &result = bodies[side.body];
      return applied_traction(*side.trace, result.body->of_side(result.estimate_forces, side.side));
    };
    const ContactBody &cut = pair.cut_side(), &other = pair.other_side();
    return law_mismatch(pair, near, {displacement(cut), displacement(other)},
                        {traction(cut), traction(other)});
  }

  ContactMismatch contact_mismatch(const InterfaceProblem &problem, const Eigen::VectorXd &pressures,
                                   const std::vector<BodyResult> &bodies)
  {
    AssertDimension(pressures.size(), problem.n_pressures());
    AssertDimension(bodies.size(), problem.bodies().size());
    ContactMismatch sum{0., std::vector<double>(bodies.size(), 0.), {}};
    for (const BodyResult &body : bodies)
      sum.cells.push_back(Eigen::VectorXd::Zero(body.body->counts().cells));
    for (std::size_t surface = 0; surface < problem.surfaces().size(); ++surface)
    {
      const ContactSurface &parts = problem.surfaces()[surface];
      std::vector<bool> presses;
      for (const double pressure : problem.of_surface(surface, pressures))
        presses.push_back(pressure > 0.);
      const std::vector<bool> near = parts.near_contact(presses);
      for (const ContactPair &pair : parts.pairs())
        add_mismatch(pair, mismatch_of(pair, near, bodies), sum);
    }
    return sum;
  }
} // namespace abut
