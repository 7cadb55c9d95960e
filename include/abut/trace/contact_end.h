// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/trace/partition.h>

#include <optional>
#include <vector>

namespace abut
{
  /**
   * Where contact ends within a stretch, the sides leaving each other smoothly: there the exact pressure of
   * frictionless contact falls to zero like the square root of the distance from the end [Johnson1985, ch. 4
   * and 5]. Over the last parts that press it is taken as p(t) = K sqrt(L - t), t the distance from where
   * they begin, with their force F and their moment M about t = 0:
   *
   *     L = 5/2 M/F,   K = 3/2 F L^(-3/2).
   *
   * So the end is known better than to a part, and force and moment are those of the loads.
   */
  struct ContactEnd
  {
    std::vector<std::size_t> parts; ///< outwards: those that press, and the first one that does not
    int direction;                  ///< along the surface: 1 where it ends ahead of the contact, else -1
    double start;                   ///< where the parts begin, along the surface
    double length;                  ///< L
    double amplitude;               ///< K
    double beyond; ///< from the outer bound of the last part that presses to the end; may be negative

    /// The pressure at the distance t outwards from `start`.
    double pressure(double t) const;
  };

  /**
   * The ends of contact of a partition, by the last four parts or as many as are no more than .4 of the way
   * from the largest load. None where that is less than three, where the square root would not end within the
   * last part that presses or the next one, and where a stretch ends, as at the edge of a punch.
   */
  std::vector<ContactEnd> find_contact_ends(const Partition &partition, const Eigen::VectorXd &loads);
} // namespace abut
