// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/decomposition/pushed_bodies.h>
#include <abut/run/checks/supports.h>
#include <abut/run/rigid_side.h>

#include <sstream>

namespace abut
{
  namespace
  {
    /// Refuses pairs without penalty whose sides supports make overlap at a point.
    void check_held_points(const Model &model)
    {
      const auto prescribed = [&](const ContactBody &side) {
        const Body &body = *model.bodies()[side.body];
        return body.of_side(body.prescribed_trace(), side.side);
      };
      for (const ContactPair *pair : model.pairs())
      {
        if (pair->penalty() > 0.)
          continue;
        const auto found = pair->held_overlap(prescribed(pair->cut_side()), prescribed(pair->other_side()));
        if (!found)
          continue;
        std::ostringstream text;
        text << "Contact " << pair->name() << ": at (" << found->place.x() << ", " << found->place.y()
             << ") supports hold both bodies, and make them overlap by " << found->overlap
             << ", which no pressure can undo; let the contact side end before the held nodes, or give the "
                "contact "
                "a Penalty coefficient";
        throw UserError(text.str());
      }
    }

    /// Refuses a body that nothing holds, or that the scheme cannot hold. Returns whether contact holds it.
    bool check_floating(const Body &body, const DecompositionParameters &decomposition)
    {
      std::string motions;
      for (const std::string &motion : body.free_rigid_motions())
        motions += (motions.empty() ? "" : ", ") + motion;
      if (motions.empty())
        return false;
      if (body.contact_sides().empty())
        throw UserError("Body " + body.name() + " is held by nothing against " + motions +
                        ": give it supports in Body " + body.name() +
                        "/Conditions (a displacement condition on a side or at a point)");
      if (!scheme_of(decomposition).takes_motions)
        throw UserError("Body " + body.name() + " is held by contact alone against " + motions +
                        ": Decomposition/Scheme = " + decomposition.scheme +
                        " needs supports on every body; take " +
                        schemes_with(&SchemeEntry::takes_motions, true, " or ") +
                        ", or add a displacement condition to Body " + body.name() + "/Conditions");
      return true;
    }

    /// As far as the bodies move without deforming.
    void check_pushed_bodies(const Model &model)
    {
      const InterfaceProblem &problem = model.problem();
      const MotionTerms motions = make_motion_terms(problem);
      std::vector<Eigen::VectorXd> prescribed;
      for (const auto &body : model.bodies())
        prescribed.push_back(body->prescribed_trace());
      refuse_pushed_bodies(problem, motions, problem.observe(prescribed).head(problem.n_pressures()));
    }
  } // namespace

  void check_supports(const Scene &scene, const Model &model)
  {
    check_held_points(model);
    bool floats = false;
    for (const auto &body : model.bodies())
      floats = check_floating(*body, scene.decomposition) || floats;
    // Rigid sides need the stiffness: those scenes are checked later.
    if (floats && body_with_resultant(model) == nullptr)
      check_pushed_bodies(model);
  }
} // namespace abut
