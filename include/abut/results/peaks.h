// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/body.h>

namespace abut
{
  /// The largest value of a field, and where it is.
  struct Peak
  {
    double value = 0.;
    Vector2 place = Vector2::Zero(); ///< undeformed
    unsigned int cell = 0;           ///< active cell index

    void serialize(Archive &archive) { archive(value, place, cell); }
  };

  /// The largest values of a body's fields.
  struct BodyPeaks
  {
    Peak von_mises;    ///< over the output points
    Peak displacement; ///< length of the vector, over the output points
    Peak strain;       ///< principal strain, by its size, over the Gauss points
    /// The same farther from singular vertices than a hundredth of the body's diagonal.
    Peak regular_von_mises, regular_strain;

    void serialize(Archive &archive)
    {
      archive(von_mises, displacement, strain, regular_von_mises, regular_strain);
    }
  };

  /// `deformation`: the displacement less a rigid motion (see BodyResult).
  BodyPeaks find_peaks(const Body &body, const Eigen::VectorXd &displacement,
                       const Eigen::VectorXd &deformation, const std::vector<Vector2> &singular_vertices);
} // namespace abut
