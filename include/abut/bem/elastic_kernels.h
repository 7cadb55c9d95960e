// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace abut
{
  /**
   * The operators of LayerOperators as kernels log ln|w| I + even [I + (Re, -Im; -Im, -Re) conj(w)/w]: V,
   * 2 V - L and W (between slopes), for G = 1.
   */
  struct ElasticKernels
  {
    struct Kernel
    {
      double log, even;
    };

    explicit ElasticKernels(double poisson_ratio);

    Kernel single, rotated, hypersingular;
  };
} // namespace abut
