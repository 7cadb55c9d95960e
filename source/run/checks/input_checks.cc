// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What is known before anything is solved.

#include <abut/run/checks/validity.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

namespace abut
{
  namespace
  {
    /// Of the depth of the shallower body: the strain that taking the overlap up would need. Half of what
    /// `large-strain` allows, as the softer body may have to take nearly all of it in a part of its depth.
    constexpr double largest_overlap = .02;

    /// The length that takes an overlap up: the depth or, on a side that turns, its radius where that is
    /// larger.
    double reach(const ContactBody &side)
    {
      double turn = 0.;
      for (const Segment &segment : side.trace->segments())
      {
        const Vector2 from = Trace::averaged_normal(segment, 0.), to = Trace::averaged_normal(segment, 1.);
        turn += std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
      }
      constexpr double noticeable = M_PI / 4.;
      return std::abs(turn) < noticeable ? side.depth
                                         : std::max(side.depth, side.trace->length() / std::abs(turn));
    }

    Warnings overlap_warnings(const ContactPair &pair)
    {
      const double depth = std::min(reach(pair.slave()), reach(pair.master()));
      if (!(pair.smallest_gap() < -largest_overlap * depth))
        return {};
      std::ostringstream text;
      text.precision(3);
      text << "Contact " << pair.name() << ": the sides overlap by " << -pair.smallest_gap()
           << " before anything moves, " << 100. * -pair.smallest_gap() / depth
           << " % of the depth of the bodies (" << depth << "); linear elasticity is for up to "
           << 100. * largest_overlap << " %, check the bodies' places and sizes (Shift, Size, Gap)";
      return {{WarningCode::large_overlap, text.str()}};
    }

    /// A load along a direction in which the same side's displacement is prescribed does nothing.
    Warnings load_on_support_warnings(const Body &body)
    {
      constexpr double noticeable = 1e-3; // of the load: what chords of a curve turn it by
      Warnings warnings;
      std::set<std::string> sides;
      for (const Condition &condition : body.description().conditions)
        if (!is_support(condition.kind))
          sides.insert(condition.boundary);
      for (const std::string &side : sides)
      {
        const LostLoad load = body.lost_load(side);
        if (!(load.lost > noticeable * load.largest))
          continue;
        std::ostringstream text;
        text.precision(3);
        text << "Body " << body.name() << ": the load on " << side
             << " acts along a displacement that is prescribed there: up to " << load.lost
             << " (force per area) of it goes into the support and does nothing to the body; keep one of the "
                "two conditions";
        warnings.push_back({WarningCode::load_on_support, text.str()});
      }
      return warnings;
    }

    /// A round side in too few edges is a polygon, whatever it is for.
    Warnings coarse_curve_warnings(const Body &body, const std::string &side)
    {
      const auto facets = body.facets(side);
      if (!facets || facets->n_blunt_corners == 0)
        return {};
      std::ostringstream text;
      text.precision(3);
      text << "Body " << body.name() << ": its side " << side << " turns by up to " << facets->largest_kink
           << " degrees between its edges, which are taken for corners one after the other; if the side is "
              "round, raise Body "
           << body.name() << "/Corner angle or mesh it finer";
      return {{WarningCode::coarse_curve, text.str()}};
    }

    /// What straight edges of a mesh file do to a gap.
    Warnings facets_warnings(const Body &body, const std::string &side, const ContactPair &pair)
    {
      constexpr double noticeable = .05; // of the smallest gap or the overlap
      const auto facets = body.facets(side);
      if (!facets || facets->followed || !pair.gap_from_geometry() ||
          !(facets->height > noticeable * std::abs(pair.smallest_gap())))
        return {};
      std::ostringstream text;
      text.precision(3);
      text << "Contact " << pair.name() << ": the side " << body.name() << ':' << side
           << " is taken as meshed: its straight edges are up to " << facets->height
           << " off the smooth curve through them, the smallest gap is " << pair.smallest_gap()
           << "; if the side is round, set Body " << body.name() << "/Boundary curve = smooth";
      return {{WarningCode::facets, text.str()}};
    }

    Warnings file_warnings(const Scene &scene, const Body &body)
    {
      Warnings warnings = body.mesh_warnings();
      std::set<std::string> sides;
      for (const Condition &condition : body.description().conditions)
        if (!condition.point)
          sides.insert(condition.boundary);
      for (const ContactDescription &contact : scene.contacts)
        for (const Side &side : {contact.slave, contact.master})
          if (side.body == body.name())
            sides.insert(side.boundary);
      for (const std::string &side : sides)
        append(warnings, coarse_curve_warnings(body, side));
      return warnings;
    }

    Warning repeated_warning(const RepeatedParameter &parameter)
    {
      return {WarningCode::repeated_parameter, "Line " + std::to_string(parameter.last_line) + ": `" +
                                                   parameter.name + "` is set once more, after line " +
                                                   std::to_string(parameter.first_line) +
                                                   "; the last line counts, delete the others"};
    }
    Warning default_material_warning(const std::string &section)
    {
      return {WarningCode::default_material,
              section +
                  ": its Young modulus is not given and is 1, while another one "
                  "of the scene is given: set " +
                  section + "/Young modulus"};
    }

    /// Bodies that no contact names: each of them is a problem of its own.
    Warnings lone_body_warnings(const Scene &scene)
    {
      if (scene.bodies.size() < 2)
        return {};
      if (scene.contacts.empty())
        return {{WarningCode::body_without_contact,
                 "The scene has " + std::to_string(scene.bodies.size()) +
                     " bodies and no contact: each is computed by itself, they pass through each other; name "
                     "the pairs in Contacts, or set Contacts = automatic"}};
      Warnings warnings;
      for (const BodyDescription &body : scene.bodies)
        if (std::none_of(scene.contacts.begin(), scene.contacts.end(),
                         [&](const ContactDescription &contact) {
                           return contact.slave.body == body.name || contact.master.body == body.name;
                         }))
          warnings.push_back(
              {WarningCode::body_without_contact,
               "Body " + body.name +
                   " is in no contact: it is computed by itself, the others pass through it; " +
                   (scene.finds_contacts
                        ? "raise Contact distance, or take the body out"
                        : "name a pair with it in Contacts, set Contacts = automatic, or take "
                          "the body out")});
      return warnings;
    }
  } // namespace

  Warnings input_warnings(const Scene &scene, const Model &model)
  {
    Warnings warnings;
    for (const RepeatedParameter &parameter : scene.repeated)
      warnings.push_back(repeated_warning(parameter));
    for (const std::string &section : scene.default_materials)
      warnings.push_back(default_material_warning(section));
    append(warnings, lone_body_warnings(scene));
    append(warnings, placed_overlap_warnings(scene, model));
    for (const auto &body : model.bodies())
      append(warnings, load_on_support_warnings(*body));
    for (const auto &body : model.bodies())
      append(warnings, file_warnings(scene, *body));
    for (std::size_t i = 0; i < model.pairs().size(); ++i)
    {
      const ContactPair &pair = *model.pairs()[i];
      append(warnings, overlap_warnings(pair));
      append(warnings,
             facets_warnings(*model.bodies()[pair.slave().body], scene.contacts[i].slave.boundary, pair));
      append(warnings,
             facets_warnings(*model.bodies()[pair.master().body], scene.contacts[i].master.boundary, pair));
    }
    return warnings;
  }
} // namespace abut
