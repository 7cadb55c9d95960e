// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace abut
{
  /// What a processor has of what OpenBLAS' kernels need.
  struct VectorUnits
  {
    bool avx;
    bool avx2;   ///< with fused multiplication
    bool avx512; ///< F, BW, CD, DQ and VL
  };

  /// Kernels to ask OpenBLAS for, by the name of a processor, where it has taken those of the processor
  /// `taken`; empty where it is to be left alone.
  std::string better_kernels(const std::string &taken, const VectorUnits &units);

  /**
   * Asks OpenBLAS, before it is loaded for good, for kernels that use what the processor can do. OpenBLAS
   * goes by a list of processors: on some that are newer than itself it takes its oldest kernels, which are
   * several times as slow. What the user asks for by OPENBLAS_CORETYPE stays. Does nothing where there is no
   * OpenBLAS. To be called before any library is loaded that needs it.
   */
  void choose_blas_kernels();
} // namespace abut
