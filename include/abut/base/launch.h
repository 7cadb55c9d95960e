// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace abut
{
  /// What mpirun, or another process manager, tells a process that it starts. Asking for it initialises
  /// nothing and needs no library: the launcher asks too.
  struct Launch
  {
    int n_processes = 1;
    int rank = 0;

    /// Of Open MPI's mpirun, of MPICH's, and of srun. What a batch system tells a job is no launch.
    static Launch from_environment();

    bool is_first() const { return rank == 0; }
  };
} // namespace abut
