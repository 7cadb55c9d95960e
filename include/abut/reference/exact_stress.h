// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace abut
{
  /// Stress of plane strain at a point: force per area, tension positive, zz = nu (xx + yy).
  struct ExactStress
  {
    double xx = 0.;
    double yy = 0.;
    double xy = 0.;
    double zz = 0.;
  };
} // namespace abut
