// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/reference/pressed_layers.h>

#include <algorithm>
#include <functional>

namespace abut
{
  /// A pressure on a contact of given width that vanishes at its edge, expanded in a basis.
  struct ContactForWidth
  {
    Eigen::VectorXd coefficients;
    double approach; ///< at which the contact is that wide
  };

  /// The data with a length that makes no difference from infinity where the ends are infinite. Throws
  /// UserError for data that make no sense.
  LayersContactData with_finite_length(const LayersContactData &data);

  /// The half-width at which `approach_of` is the approach of the data. Throws UserError where there is none
  /// between 1e-4 and 0.99 of the length.
  double find_half_width(const LayersContactData &data,
                         const std::function<double(double half_width)> &approach_of);
  /// The same to 12 digits, near a guess.
  double find_half_width_near(double guess, const LayersContactData &data,
                              const std::function<double(double half_width)> &approach_of);

  /// Sums over the two layers.
  double half_plane_compliance(const LayersContactData &data);
  double uniform_compliance(const LayersContactData &data);

  /// The displacements w_1 + w_2 at the points x, without those of the mean pressure, under the pressures of
  /// a basis (SineBasis, SplineBasis): a column for each.
  template <typename Basis>
  Eigen::MatrixXd wave_displacement(const LayersContactData &data, const Basis &basis,
                                    const Eigen::VectorXd &x)
  {
    Eigen::Index n_modes = 0;
    for (const Layer &layer : data.layers)
      n_modes = std::max(n_modes, layer.n_thin_modes(data.length));
    const Eigen::MatrixXd modes = basis.modes(n_modes);
    Eigen::MatrixXd potential(x.size(), basis.size());
    for (Eigen::Index i = 0; i < x.size(); ++i)
      potential.row(i) = basis.potential(x(i));
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(x.size(), basis.size());
    for (const Layer &layer : data.layers)
      sum += layer.wave_displacement(data.length, x, modes.topRows(layer.n_thin_modes(data.length) + 1),
                                     potential);
    return sum;
  }
} // namespace abut
