// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace abut
{
  /// Whether somebody has initialised these libraries, which a serial run does not need.
  bool mpi_is_initialised();
  bool p4est_is_initialised();

  /// Of OpenBLAS: name, version and whose kernels it runs; "unknown" with another BLAS.
  std::string blas_name();
} // namespace abut
