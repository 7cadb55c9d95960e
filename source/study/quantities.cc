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

  const std::vector<NamedQuantity> &named_quantities()
  {
    using Of = const Quantities &;
    static const std::vector<NamedQuantity> all = {
        {"contact_force", "contact force", [](Of of) { return of.force(); }, true},
        {"max_pressure", "peak pressure", [](Of of) { return of.max_pressure(); }, true},
        {"contact_length", "contact length", [](Of of) { return of.contact_length(); }, true},
        {"max_von_mises", "max von Mises", [](Of of) { return of.max_von_mises; }, false},
        {"strain_energy", "strain energy", [](Of of) { return of.strain_energy; }, false}};
    return all;
  }

  std::vector<PointQuantities> quantities_at(const std::vector<PointResult> &points)
  {
    std::vector<PointQuantities> quantities;
    for (const PointResult &point : points)
      quantities.push_back({point.body->name() + '_' + std::to_string(point.number), point.stress.von_mises(),
                            point.displacement});
    return quantities;
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
