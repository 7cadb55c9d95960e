// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <mpi.h>

namespace abut
{
  /// MPI's name of the processes that share a run, or a body: for libraries that talk to others themselves.
  class Communicator
  {
  public:
    /// Takes it over.
    explicit Communicator(const MPI_Comm handle) : handle_(handle) {}
    /// Frees it; ends MPI where it is that of all processes.
    ~Communicator();
    Communicator(const Communicator &) = delete;
    Communicator &operator=(const Communicator &) = delete;

    MPI_Comm handle() const { return handle_; }

  private:
    MPI_Comm handle_;
  };
} // namespace abut
