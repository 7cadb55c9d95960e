// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Bodies that pass through each other where no pair joins them.

#include <abut/run/checks/unpaired_overlap.h>
#include <abut/run/checks/validity.h>

#include <algorithm>
#include <sstream>

namespace abut
{
  namespace
  {
    /// A side of one of the two bodies that a contact joins with the side of the other one: the contact ends
    /// where another side goes on.
    std::string side_to_go_on_from(const Scene &scene, const UnpairedOverlap &overlap,
                                   const std::size_t which)
    {
      const std::string &body = scene.bodies[overlap.bodies[which]].name,
                        &other = scene.bodies[overlap.bodies[1 - which]].name;
      for (const ContactDescription &contact : scene.contacts)
        for (const auto &[own, there] :
             {std::pair(contact.slave, contact.master), std::pair(contact.master, contact.slave)})
          if (own.body == body && there.body == other && there.boundary == overlap.sides[1 - which])
            return "take the sides of body " + body + " together, " + body + ':' + own.boundary + " + " +
                   overlap.sides[which] + " in Contact " + contact.name + ", or ";
      return "";
    }

    std::string way_out(const Scene &scene, const UnpairedOverlap &overlap)
    {
      const BodyDescription &a = scene.bodies[overlap.bodies[0]], &b = scene.bodies[overlap.bodies[1]];
      if (a.is_rigid && b.is_rigid)
        return "rigid bodies make no pair with each other: make one of them elastic";
      if (scene.finds_contacts)
        return "raise Contact distance, or name the pairs";
      return side_to_go_on_from(scene, overlap, 0) + side_to_go_on_from(scene, overlap, 1) +
             "add a Contact of these two sides, or let Contacts = automatic find it";
    }

    Warning overlap_warning(const Scene &scene, const UnpairedOverlap &overlap, const std::string &when,
                            const std::string &beside)
    {
      std::ostringstream text;
      text.precision(3);
      text << "Bodies " << scene.bodies[overlap.bodies[0]].name << " and "
           << scene.bodies[overlap.bodies[1]].name << " overlap by " << overlap.depth << when << ", at ("
           << overlap.place.x() << ", " << overlap.place.y() << ") between "
           << scene.bodies[overlap.bodies[0]].name << ':' << overlap.sides[0] << " and "
           << scene.bodies[overlap.bodies[1]].name << ':' << overlap.sides[1] << ", which no contact joins"
           << beside << ": they pass through each other; " << way_out(scene, overlap);
      return {WarningCode::unpaired_overlap, text.str()};
    }
  } // namespace

  Warnings placed_overlap_warnings(const Scene &scene, const Model &model)
  {
    Warnings warnings;
    for (const UnpairedOverlap &overlap : unpaired_overlaps(scene, model, {}))
      warnings.push_back(overlap_warning(scene, overlap, " before anything moves", ""));
    return warnings;
  }

  Warnings displaced_overlap_warnings(const Scene &scene, const Model &model, const Solution &solution)
  {
    std::vector<Eigen::VectorXd> displacements;
    for (const BodyResult &body : solution.bodies)
      displacements.push_back(body.displacement);
    const std::vector<UnpairedOverlap> placed = unpaired_overlaps(scene, model, {});
    std::ostringstream beside;
    beside.precision(3);
    if (!solution.pairs.empty())
      beside << " (the contacts let bodies overlap by up to "
             << std::max_element(solution.pairs.begin(), solution.pairs.end(),
                                 [](const PairResult &a, const PairResult &b) {
                                   return a.max_penetration < b.max_penetration;
                                 })
                    ->max_penetration
             << ")";
    Warnings warnings;
    for (const UnpairedOverlap &overlap : unpaired_overlaps(scene, model, displacements))
      if (std::none_of(placed.begin(), placed.end(),
                       [&](const UnpairedOverlap &known) { return known.bodies == overlap.bodies; }))
        warnings.push_back(overlap_warning(scene, overlap, " once displaced", beside.str()));
    return warnings;
  }
} // namespace abut
