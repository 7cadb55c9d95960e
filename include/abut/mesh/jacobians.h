// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/grid/tria.h>

#include <string>

namespace dealii
{
  template <int, int> class Mapping;
}

namespace abut
{
  /**
   * Refuses own cells whose image under the mapping, of polynomial degree `degree`, has a Jacobian <= 0
   * at a point of a lattice that holds the corners. `where` begins the message of the UserError.
   */
  void check_jacobians(const dealii::Triangulation<2> &triangulation, const dealii::Mapping<2, 2> &mapping,
                       unsigned int degree, const std::string &where);
} // namespace abut
