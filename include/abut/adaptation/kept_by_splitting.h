// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>

/**
 * What is expected to stay of the squared error of a cell of size h when it is split into four.
 */
namespace abut::kept_by_splitting
{
  /// Energy norm, the stress is smooth: h^(2p), p the degree.
  inline double smooth(const unsigned int degree)
  {
    return std::pow(4., -static_cast<double>(degree));
  }
  /// Energy norm, cells at an end of contact, where the stress is like r^(1/2): h^3.
  constexpr double contact_end = 1. / 8.;
  /// Energy norm, cells at a vertex with infinite stress, at worst like r^(-1/2): h.
  constexpr double vertex = 1. / 2.;
  /// Pressure in L2, inside a contact: h^4, whatever the degree, as it is constant in every part.
  constexpr double pressure = 1. / 16.;
  /// Pressure in L2, at an end of contact, where it is like s^(1/2): h^2.
  constexpr double pressure_at_end = 1. / 4.;
} // namespace abut::kept_by_splitting
