// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/material.h>

namespace abut
{
  /**
   * Compliance of an elastic (Winkler) layer of depth H on a rigid, frictionless base, pressed uniformly:
   * k = H (1 + nu)(1 - 2 nu) / (E (1 - nu)), displacement of the surface per unit of pressure.
   */
  inline double layer_compliance(const Material &material, const double depth)
  {
    const double nu = material.poisson_ratio;
    return depth * (1. + nu) * (1. - 2. * nu) / (material.young_modulus * (1. - nu));
  }
} // namespace abut
