// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/libraries.h>

#include <mpi.h>
#include <p4est_base.h>

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
} // namespace abut
