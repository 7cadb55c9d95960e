// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/libraries.h>

#include <mpi.h>
#include <p4est_base.h>

// Exported by OpenBLAS alone: with another BLAS the addresses are null.
extern "C" char *openblas_get_config() __attribute__((weak));
extern "C" char *openblas_get_corename() __attribute__((weak));

namespace abut
{
  bool mpi_is_initialised()
  {
    int initialised = 0;
    MPI_Initialized(&initialised);
    return initialised != 0;
  }

  bool p4est_is_initialised()
  {
    return p4est_package_id >= 0;
  }

  std::string blas_name()
  {
    if (openblas_get_config == nullptr || openblas_get_corename == nullptr)
      return "unknown";
    const std::string config = openblas_get_config(); // begins with name and version
    return config.substr(0, config.find(' ', config.find(' ') + 1)) + ", " + openblas_get_corename();
  }
} // namespace abut
