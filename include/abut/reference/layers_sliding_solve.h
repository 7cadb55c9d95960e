// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/reference/contact_pressure.h>
#include <abut/reference/layer.h>

namespace abut
{
  struct LayersSlidingData;

  /**
   * Surface displacement of a layer at the points x without that of the mean pressure, column by column:
   * `modes` holds cosine amplitudes of pressures (row 0 the mean, unused), `potential` their sums phi at x
   * (SineBasis::potential).
   */
  Eigen::MatrixXd wave_displacement(const Layer &layer, double length, const Eigen::VectorXd &x,
                                    const Eigen::MatrixXd &modes, const Eigen::MatrixXd &potential);

  /// The contact pressure of LayersSliding; errors as there.
  ContactPressure solve_layers_sliding(const LayersSlidingData &data);
} // namespace abut
