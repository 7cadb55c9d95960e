// SPDX-License-Identifier: LGPL-2.1-or-later
//
// To be preloaded: ends a program that starts MPI or opens a socket.

#include <cstdio>
#include <cstdlib>

namespace
{
  [[noreturn]] int refuse(const char *name)
  {
    std::printf("%s has been called\n", name);
    std::fflush(stdout);
    std::_Exit(1);
  }
} // namespace

extern "C" {
int socket(int, int, int)
{
  refuse("socket");
}

int MPI_Init(int *, char ***)
{
  refuse("MPI_Init");
}

int MPI_Init_thread(int *, char ***, int, int *)
{
  refuse("MPI_Init_thread");
}
}
