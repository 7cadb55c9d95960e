// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/material.h>
#include <abut/base/vector2.h>

#include <complex>
#include <functional>

/// A displacement and the stress that belongs to it, without body force.
struct PlaneField
{
  std::function<abut::Vector2(const abut::Vector2 &)> displacement;
  std::function<abut::Stress(const abut::Vector2 &)> stress;
};

/**
 * From Kolosov's potentials: with kappa = 3 - 4 nu
 *   2 mu (u + i v) = kappa phi - z conj(phi') - conj(psi),
 *   xx + yy = 4 Re phi',   yy - xx + 2 i xy = 2 (conj(z) phi'' + psi').
 */
struct Potentials
{
  std::complex<double> phi, d_phi, d2_phi, psi, d_psi;
};
PlaneField field_of(const abut::Material &material,
                    const std::function<Potentials(std::complex<double>)> &potentials);

/// phi and psi exponentials: no symmetry, and smooth everywhere.
PlaneField smooth_field(const abut::Material &material);

/**
 * The singular field of a wedge 0 <= theta <= angle around the origin, free at theta = 0 and held at theta =
 * angle (90 or 180 degrees): the exponent of r in the displacement with the smallest real part between 0
 * and 1. At 180 degrees, where a support ends inside a straight side, it is 1/2 + i ln(kappa)/(2 pi).
 */
class ClampedWedge
{
public:
  ClampedWedge(const abut::Material &material, double angle);

  PlaneField field() const;
  std::complex<double> exponent() const { return exponent_; }

private:
  abut::Material material_;
  std::complex<double> exponent_;
  /// phi = a z^l + b z^conj(l), psi = c z^l + d z^conj(l)
  std::complex<double> a_, b_, c_, d_;
};
