// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/contact/contact_pair.h>
#include <abut/user_error.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace abut
{
  namespace
  {
    GapFunction gap_function(const ContactDescription &description, const Placement &slave_placement)
    {
      if (!description.gap)
        return [](const Vector2 &, const double geometric_gap) { return geometric_gap; };
      return [&description, &slave_placement](const Vector2 &point, double) {
        return slave_placement.length_to_world((*description.gap)(slave_placement.point_to_own(point)));
      };
    }

    /// The same, refusing pairs that were found right through the bodies.
    GapFunction checked(const GapFunction &gap, const std::string &name, const double depth)
    {
      return [gap, name, depth](const Vector2 &point, const double geometric_gap) {
        if (geometric_gap < -depth)
        {
          std::ostringstream text;
          text << "Contact " << name << ": the sides overlap by " << -geometric_gap
               << ", more than the bodies behind them are deep (" << depth
               << "); check the side names and the bodies' places";
          throw UserError(text.str());
        }
        const double initial_gap = gap(point, geometric_gap);
        if (std::abs(initial_gap - geometric_gap) > depth)
        {
          std::ostringstream text;
          text << "Contact " << name << "/Gap: received " << initial_gap << " where the sides are "
               << geometric_gap << " apart, a difference of more than the bodies' depth (" << depth
               << "); check the bodies' places";
          throw UserError(text.str());
        }
        return initial_gap;
      };
    }
  } // namespace

  ContactPair::ContactPair(const ContactDescription &description, const Placement &slave_placement,
                           const ContactBody &slave, const ContactBody &master, const Trace &slave_trace,
                           const Trace &master_trace)
      : name_(description.name), slave_(slave), master_(master),
        coupling_(couple(slave_trace, master_trace,
                         checked(gap_function(description, slave_placement), description.name,
                                 std::min(slave.depth, master.depth)))),
        penalty_(description.penalty.value_or(.5 * description.penalty_coefficient *
                                              (slave.flexibility + master.flexibility))),
        gap_from_geometry_(!description.gap), coverage_(coupling_.covered_length / slave_trace.length())
  {
    if (coupling_.weights.isZero(0.))
      throw UserError("Contact " + name_ + ": no part of the slave " + description.slave.body + ":" +
                      description.slave.boundary + " faces the master " + description.master.body + ":" +
                      description.master.boundary +
                      " along its normals; check the bodies' places and the side names");
  }
} // namespace abut
