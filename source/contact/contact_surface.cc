// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/contact/contact_surface.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <tuple>

namespace abut
{
  namespace
  {
    using SideId = std::pair<std::size_t, std::size_t>; // body, side

    SideId id_of(const ContactBody &side)
    {
      return {side.body, side.side};
    }

    /// Sides in groups of two colours: those of a pair differ, those that go on smoothly are alike.
    class Colouring
    {
    public:
      /// False, with nothing changed, where the colours of the two would contradict what is known.
      bool relate(const SideId &a, const SideId &b, const bool differ)
      {
        const auto [root_a, colour_a] = find(a);
        const auto [root_b, colour_b] = find(b);
        if (root_a == root_b)
          return (colour_a != colour_b) == differ;
        parents_[root_b] = {root_a, (colour_a != colour_b) != differ};
        return true;
      }
      /// A name of the group, and the colour within it.
      std::pair<SideId, bool> find(const SideId &side)
      {
        const auto parent = parents_.try_emplace(side, side, false).first->second;
        if (parent.first == side)
          return {side, false};
        const auto [root, colour] = find(parent.first);
        return {root, colour != parent.second};
      }

    private:
      std::map<SideId, std::pair<SideId, bool>> parents_;
    };

    /// Whether one side begins where the other ends and goes on by less than 45 degrees.
    bool goes_on(const Trace &first, const Trace &second)
    {
      for (const Segment &a : first.segments())
        for (const Segment &b : second.segments())
          if (first.node_dofs()[a.nodes.back()] == second.node_dofs()[b.nodes.front()])
            return is_smooth(a.end_normals[1], b.end_normals[0]);
      return false;
    }

    bool are_joined(const ContactBody &a, const ContactBody &b)
    {
      return a.body == b.body && a.side != b.side &&
             (goes_on(*a.trace, *b.trace) || goes_on(*b.trace, *a.trace));
    }

    std::vector<ContactBody> all_sides(const std::vector<PairInput> &pairs)
    {
      std::vector<ContactBody> sides;
      for (const PairInput &pair : pairs)
        for (const ContactBody &side : {pair.slave, pair.master})
          if (std::none_of(sides.begin(), sides.end(),
                           [&](const ContactBody &known) { return id_of(known) == id_of(side); }))
            sides.push_back(side);
      return sides;
    }

    /// `alone`: for every pair whether its sides would need the same colour.
    Colouring colour(const std::vector<PairInput> &pairs, std::vector<bool> &alone)
    {
      Colouring colouring;
      for (const PairInput &pair : pairs)
        alone.push_back(!colouring.relate(id_of(pair.slave), id_of(pair.master), true));
      const std::vector<ContactBody> sides = all_sides(pairs);
      for (const ContactBody &a : sides)
        for (const ContactBody &b : sides)
          if (id_of(a) < id_of(b) && are_joined(a, b))
            colouring.relate(id_of(a), id_of(b), false);
      return colouring;
    }

    /// Position of a side in a list, where it is added if it is new.
    std::size_t position(const ContactBody &side, std::vector<SurfaceSide> &sides)
    {
      const auto known = std::find_if(sides.begin(), sides.end(), [&](const SurfaceSide &other) {
        return SideId(other.body, other.side) == id_of(side);
      });
      if (known != sides.end())
        return static_cast<std::size_t>(known - sides.begin());
      sides.push_back({side.trace, side.plane_modulus, side.body, side.side});
      return sides.size() - 1;
    }

    Carrier carrier(const MultiplierSide wanted, const bool slave_is_cut)
    {
      if (wanted == MultiplierSide::automatic)
        return Carrier::automatic;
      return (wanted == MultiplierSide::slave) == slave_is_cut ? Carrier::cut : Carrier::other;
    }

    /// Refuses a pair that has no pieces, unless other bodies of the surface alone hide its master.
    void refuse_unless_hidden(const PairInput &pair, const SurfaceLink &link, const Surface &surface)
    {
      const ContactDescription &contact = *pair.description;
      Surface alone{
          {surface.cut[link.cut]}, {surface.others[link.other]}, {{0, 0, link.deepest, link.carrier}}};
      const auto normals = common_normals(alone);
      if (!common_refinement(alone, normals).empty())
        return;
      // Without the limit on the overlap: does something lie opposite right through a body?
      alone.links[0].deepest = std::numeric_limits<double>::infinity();
      double overlap = std::numeric_limits<double>::infinity();
      for (const Piece &piece : common_refinement(alone, normals))
        overlap = std::min(
            overlap,
            -normals[0].project(piece.cut_segment, .5 * (piece.start + piece.end), piece.other_segment).gap);
      std::ostringstream text;
      text << "Contact " << contact.name << ": ";
      if (std::isfinite(overlap))
        text << "the sides overlap by " << overlap << ", more than the bodies behind them are deep ("
             << link.deepest << "); check the side names and the bodies' places";
      else
        text << "no part of the slave " << contact.slave.body << ':' << contact.slave.boundary
             << " faces the master " << contact.master.body << ':' << contact.master.boundary
             << " along their normals; check the bodies' places and the side names";
      throw UserError(text.str());
    }
  } // namespace

  std::vector<std::vector<std::size_t>> ContactSurface::group(const std::vector<PairInput> &pairs)
  {
    std::vector<bool> alone;
    Colouring colouring = colour(pairs, alone);
    std::map<SideId, std::size_t> group_of;
    std::vector<std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < pairs.size(); ++i)
    {
      std::size_t group = groups.size();
      if (!alone[i])
        group = group_of.try_emplace(colouring.find(id_of(pairs[i].slave)).first, group).first->second;
      if (group == groups.size())
        groups.emplace_back();
      groups[group].push_back(i);
    }
    return groups;
  }

  ContactSurface::ContactSurface(const std::vector<PairInput> &pairs)
  {
    Assert(!pairs.empty(), dealii::ExcMessage("a surface has a pair"));
    std::vector<bool> alone;
    Colouring colouring = colour(pairs, alone);
    const bool cut_colour = colouring.find(id_of(pairs.front().slave)).second;

    Surface surface;
    std::vector<bool> slave_is_cut;
    for (const PairInput &pair : pairs)
    {
      slave_is_cut.push_back(colouring.find(id_of(pair.slave)).second == cut_colour);
      const auto &[cut, other] =
          slave_is_cut.back() ? std::tie(pair.slave, pair.master) : std::tie(pair.master, pair.slave);
      surface.links.push_back({position(cut, surface.cut), position(other, surface.others),
                               std::min(cut.depth, other.depth),
                               carrier(pair.description->multipliers, slave_is_cut.back())});
    }
    for (const SurfaceSide &side : surface.cut)
      cut_sides_.push_back(side.trace);
    for (const SurfaceLink &link : surface.links)
      cut_side_of_link_.push_back(link.cut);
    const std::vector<CommonNormal> normals = common_normals(surface);
    partition_ = std::make_unique<Partition>(surface, normals);
    for (std::size_t i = 0; i < pairs.size(); ++i)
    {
      const auto &pieces = partition_->pieces();
      if (std::none_of(pieces.begin(), pieces.end(), [i](const Piece &piece) { return piece.link == i; }))
        refuse_unless_hidden(pairs[i], surface.links[i], surface);
      pairs_.emplace_back(*pairs[i].description, *pairs[i].slave_placement, pairs[i].slave, pairs[i].master,
                          slave_is_cut[i], surface, normals, *partition_, i);
    }
  }

  std::vector<bool> ContactSurface::near_contact(const std::vector<bool> &pressed) const
  {
    AssertDimension(static_cast<Eigen::Index>(pressed.size()), n_parts());
    std::vector<bool> near = pressed;
    const auto neighbours = partition_->neighbours();
    for (std::size_t k = 0; k < near.size(); ++k)
      for (const std::size_t neighbour : neighbours[k])
        if (pressed[neighbour])
          near[k] = true;
    return near;
  }
} // namespace abut
