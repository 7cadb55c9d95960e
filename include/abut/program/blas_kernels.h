// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace abut
{
  /**
   * Asks OpenBLAS, before it is loaded for good, for kernels that use what the processor can do. It goes by a
   * list of processors: on one that is newer than itself it would take its oldest kernels, which are several
   * times as slow. What the user asks for by OPENBLAS_CORETYPE stays. Does nothing with another BLAS.
   */
  void choose_blas_kernels();
} // namespace abut
