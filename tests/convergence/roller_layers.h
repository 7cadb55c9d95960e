// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/reference/layers_contact.h>

/// The data of `prm/two-layers-rollers.prm`, and its exact solution for any approach.
namespace roller_layers
{
  constexpr double length = 4., curvature = 1e-3, approach = 1.366e-3, modulus = 2.1e5, poisson_ratio = .3;

  inline abut::LayersContact exact(const double approach_taken)
  {
    const abut::Layer layer{modulus, poisson_ratio, 1., abut::Layer::Base::sliding};
    return abut::LayersContact({{{layer, layer}}, length, curvature, approach_taken});
  }
} // namespace roller_layers
