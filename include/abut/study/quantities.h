// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/results/results.h>

#include <string>
#include <vector>

namespace abut
{
  /// What a solution says of one contact.
  struct ContactQuantities
  {
    std::string name;
    double force = 0.;          ///< normal force
    double max_pressure = 0.;   ///< largest reported pressure
    double contact_length = 0.; ///< of what presses
  };

  /// What a solution says at a point.
  struct PointQuantities
  {
    std::string name; ///< of the body and the point's number: `beam_1`
    double von_mises = 0.;
    Vector2 displacement = Vector2::Zero();
  };

  /// What a study asks of a solution, in the user's units.
  struct Quantities
  {
    std::vector<ContactQuantities> contacts;
    std::vector<PointQuantities> points;
    double max_von_mises = 0.; ///< over the output points of all bodies
    double strain_energy = 0.; ///< of all bodies

    double force() const;          ///< sum over the contacts
    double max_pressure() const;   ///< largest
    double contact_length() const; ///< sum
  };

  /// A quantity by its names in files and for people.
  struct NamedQuantity
  {
    std::string name, label;
    double (*value)(const Quantities &quantities);
    bool of_contact; ///< there is none without contacts
  };

  const std::vector<NamedQuantity> &named_quantities();

  std::vector<PointQuantities> quantities_at(const std::vector<PointResult> &points);

  /// All but those at points.
  Quantities quantities_of(const Solution &solution);
} // namespace abut
