// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/study/quantities.h>

#include <algorithm>

namespace abut
{
  double Quantities::force() const
  {
    double sum = 0.;
    for (const ContactQuantities &contact : contacts)
      sum += contact.force;
    return sum;
  }

  double Quantities::max_pressure() const
  {
    double largest = 0.;
    for (const ContactQuantities &contact : contacts)
      largest = std::max(largest, contact.max_pressure);
    return largest;
  }

  double Quantities::contact_length() const
  {
    double sum = 0.;
    for (const ContactQuantities &contact : contacts)
      sum += contact.contact_length;
    return sum;
  }

  Quantities quantities_of(const Solution &solution)
  {
    Quantities quantities;
    for (const PairResult &pair : solution.pairs)
      quantities.contacts.push_back(
          {pair.pair->name(), pair.normal_force, pair.max_pressure, pair.contact_length});
    for (const BodyResult &body : solution.bodies)
    {
      const BodyPeaks peaks = find_peaks(*body.body, body.displacement, body.deformation, {});
      quantities.max_von_mises = std::max(quantities.max_von_mises, peaks.von_mises.value);
      quantities.strain_energy += body.energy;
    }
    return quantities;
  }
} // namespace abut
