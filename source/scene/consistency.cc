// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/scene/consistency.h>
#include <abut/scene/estimator_entry.h>
#include <abut/scene/marking_entry.h>
#include <abut/scene/shape_entry.h>

#include <algorithm>
#include <utility>

namespace abut
{
  namespace
  {
    /// Whether a body is given with curved sides but meshed with straight ones.
    bool is_polygon_for_a_curve(const BodyDescription &body)
    {
      return body.cell_type == CellType::triangles && shape_of(body).has_curves;
    }

    void check_different(const ContactDescription &a, const ContactDescription &b)
    {
      const auto same = [](const Side &s, const Side &t) {
        return s.body == t.body && s.boundary == t.boundary;
      };
      if ((same(a.slave, b.slave) && same(a.master, b.master)) ||
          (same(a.slave, b.master) && same(a.master, b.slave)))
        throw UserError("Contact " + b.name + ": its sides are those of Contact " + a.name +
                        ", a pair of sides may stand in one contact only");
    }

    void check_geometric_gap(const Scene &scene, const ContactDescription &contact)
    {
      for (const Side &side : {contact.slave, contact.master})
        if (!contact.gap && is_polygon_for_a_curve(scene.bodies[scene.body_index(side.body)]))
          throw UserError("Contact " + contact.name +
                          "/Gap: received `geometry`, but the triangles of body " + side.body +
                          " follow its curved sides by chords; allowed are quadrilaterals (Body " +
                          side.body + "/Cell type) or the gap as an expression");
    }

    /// Two rigid sides press with any force, and the pressures need cells that yield.
    void check_rigid(const Scene &scene, const ContactDescription &contact)
    {
      const bool slave = scene.bodies[scene.body_index(contact.slave.body)].is_rigid,
                 master = scene.bodies[scene.body_index(contact.master.body)].is_rigid;
      const std::string where = "Contact " + contact.name;
      if (slave && master)
        throw UserError(where + ": its bodies " + contact.slave.body + " and " + contact.master.body +
                        " are both rigid outlines, one at least has to deform");
      if ((slave && contact.multipliers == MultiplierSide::slave) ||
          (master && contact.multipliers == MultiplierSide::master))
        throw UserError(where + "/Multipliers: received the side of a rigid outline, which has no cells; "
                                "allowed are automatic or the other side");
    }

    void check_contacts(const Scene &scene)
    {
      for (std::size_t i = 0; i < scene.contacts.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          check_different(scene.contacts[j], scene.contacts[i]);
      for (const auto &contact : scene.contacts)
      {
        const std::string where = "Contact " + contact.name;
        for (const auto &[entry, side] : {std::pair("/Slave", contact.slave), {"/Master", contact.master}})
          if (scene.body_index(side.body) == scene.bodies.size())
            throw UserError(where + entry + ": received the body `" + side.body +
                            "`, allowed are those of the list Bodies");
        if (contact.slave.body == contact.master.body && contact.slave.boundary == contact.master.boundary)
          throw UserError(where + ": slave and master are the same side `" + contact.slave.body + ":" +
                          contact.slave.boundary + "`, two different ones are needed");
        check_geometric_gap(scene, contact);
        check_rigid(scene, contact);
      }
    }

    /// A side that carries a given resultant takes no other load: its support would carry that one too.
    void check_loads_beside_resultant(const BodyDescription &body)
    {
      for (const Condition &resultant : body.conditions)
        for (const Condition &load : body.conditions)
          if (resultant.kind == ConditionKind::resultant && load.boundary == resultant.boundary &&
              (load.kind == ConditionKind::traction || load.kind == ConditionKind::pressure))
            throw UserError(
                "Body " + body.name + "/Conditions: " + load.boundary + ": received `" +
                to_string(load.kind) +
                "` beside `resultant`, which is all that the side carries; allowed is one of them");
    }

    void check_resultants(const Scene &scene)
    {
      for (const BodyDescription &body : scene.bodies)
        check_loads_beside_resultant(body);
    }

    void check_adaptation(const Scene &scene)
    {
      const AdaptationParameters &adaptation = scene.adaptation;
      bool some = false;
      for (const BodyDescription &body : scene.bodies)
      {
        some = some || body.adapt;
        if (body.adapt && !Registry<EstimatorEntry>::get().find(adaptation.estimator).estimates())
          throw UserError("Body " + body.name + "/Adapt: received `true`, but Adaptation/Estimator is " +
                          adaptation.estimator + "; allowed with it is false");
        if (body.adapt && body.cell_type == CellType::triangles && adaptation.coarsening > 0.)
          throw UserError("Adaptation/Coarsening: received a share above 0, but body " + body.name +
                          " has triangles, which cannot be merged; allowed is 0");
        const bool carried =
            std::any_of(body.conditions.begin(), body.conditions.end(),
                        [](const Condition &c) { return c.kind == ConditionKind::resultant; });
        if (carried && adaptation.combined)
          throw UserError("Adaptation/Combined: received `true`, but body " + body.name +
                          " carries a resultant, whose displacement takes whole solutions; allowed is false");
      }
      if (!some && adaptation.limit > 0.)
        throw UserError(
            "Adaptation/Limit: received a limit, but no body adapts; give one of them Adapt = true");
    }

    /// What needs a tolerance, and what a tolerance needs.
    void check_tolerance(const Scene &scene)
    {
      const AdaptationParameters &adaptation = scene.adaptation;
      const MarkingEntry &marking = Registry<MarkingEntry>::get().find(adaptation.marking);
      if (!scene.has_tolerance())
      {
        if (adaptation.certifies())
          throw UserError("Adaptation/Estimator: received `" + adaptation.estimator +
                          "`, which needs a Tolerance above 0");
        if (marking.needs_tolerance)
          throw UserError("Adaptation/Marking: received `" + adaptation.marking +
                          "`, which needs a Tolerance above 0");
        return;
      }
      if (!Registry<EstimatorEntry>::get().find(adaptation.estimator).estimates())
        throw UserError("Adaptation/Estimator: received `" + adaptation.estimator +
                        "` with a Tolerance, which needs an estimate; leave the entry out, or name one");
      if (adaptation.combined)
        throw UserError(
            "Adaptation/Combined: received `true` with a Tolerance; allowed is false, or Tolerance "
            "= 0, since the combined algorithm has a Limit of its own");
    }

    void check_exact_conditions(const Scene &scene)
    {
      for (const BodyDescription &body : scene.bodies)
        for (const Condition &condition : body.conditions)
          if (condition.exact && !scene.reference.is_named())
            throw UserError(
                "Body " + body.name + "/Conditions: " + condition.boundary +
                ": received `exact`, but Reference/Exact solution is none; name the solution there");
    }

    /// What keeps processes from sharing the mesh of a body, as a parameter and its value; empty: nothing.
    std::string objection_to_shared_mesh(const BodyDescription &body, const EstimatorEntry &estimator)
    {
      const ShapeEntry &shape = Registry<ShapeEntry>::get().find(body.shape);
      if (shape.is_rigid || shape.makes_cells)
        return "Shape = " + body.shape;
      if (body.cell_type == CellType::triangles)
        return "Cell type = triangles";
      if (body.joints.mortar_edges)
        return "Nonconforming edges = mortar";
      if (body.is_glued())
        return "Glue";
      constexpr double projected = .4; // the divergence, and compared from cell to cell
      if (body.largest_poisson_ratio() >= projected)
        return "a Poisson ratio from 0.4 on";
      if (!estimator.takes_distributed_meshes && estimator.estimates())
        return "Adaptation/Estimator = " + estimator.name;
      return {};
    }

    void check_shared_meshes(const Scene &scene)
    {
      const EstimatorEntry &estimator = Registry<EstimatorEntry>::get().find(scene.adaptation.estimator);
      for (const BodyDescription &body : scene.bodies)
        if (body.shares_mesh)
          if (const std::string objection = objection_to_shared_mesh(body, estimator); !objection.empty())
            throw UserError("Body " + body.name + "/Distributed mesh: received `true` with " + objection +
                            ", which needs all cells in one process; allowed with it is false");
    }
  } // namespace

  void check_consistency(const Scene &scene)
  {
    if (std::all_of(scene.bodies.begin(), scene.bodies.end(), [](const auto &body) { return body.is_rigid; }))
      throw UserError("Bodies: all are rigid outlines, one at least has to deform");
    check_contacts(scene);
    check_resultants(scene);
    check_tolerance(scene);
    check_adaptation(scene);
    check_exact_conditions(scene);
    check_shared_meshes(scene);
  }
} // namespace abut
