// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/study/observed_run.h>

namespace abut
{
  /// Where the cells lie that were split most often.
  struct Refinement
  {
    unsigned int finest = 0; ///< level
    double distance = 0.;    ///< mean of their centres' distances from the contact zone
    double all = 0.;         ///< the same for the whole body, mean over its area
  };

  /// The mean of the corners.
  Vector2 cell_centre(const Polyline &cell);

  /// The level of the cells that were split most often. There is at least one cell.
  unsigned int finest_level(const ObservedPass &pass);

  /// `half_width` >= 0: of the contact zone, which begins at x = 0 on the top of the body.
  Refinement refinement(const ObservedPass &pass, double half_width);

  /// Unknowns of finite and boundary elements on the mesh of equal cells as small as the smallest one; the
  /// boundary elements counted with as many unknowns for each as on the mesh itself. `body`: a rectangle.
  std::size_t unknowns_of_uniform_mesh(const ObservedPass &pass, const BodyDescription &body);
} // namespace abut
