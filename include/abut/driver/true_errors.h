// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/driver/layers_reference.h>
#include <abut/report/results.h>

namespace abut
{
  /**
   * Relative errors against the exact solution that the scene names (exact contact: penalty and iteration are
   * part of the error): energy norm of both bodies' displacement; stress in L2 over the components xx, yy, zz
   * and twice xy, both bodies; pressure sum p_i phi_i in L2 on the slave side; contact force.
   */
  TrueErrors true_errors(const LayersReference &reference, const Results &results);
} // namespace abut
