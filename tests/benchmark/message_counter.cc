// SPDX-License-Identifier: LGPL-2.1-or-later
// What a program sends by MPI, counted: preloaded (LD_PRELOAD), it stands before the MPI library's own
// functions and calls these by their second names, MPI's profiling interface. From MPI_Init and from every
// MPI_Pcontrol(level) on, the counts begin anew under that level, 0 at first; MPI_Finalize prints a line for
// each,
//     counted LEVEL MESSAGES BYTES COLLECTIVES COLLECTIVE_BYTES
// the most of any process: messages to one process and their bytes, calls that all processes take part in,
// and the bytes that a process gives to such calls and receives by them.

#include <array>
#include <iostream>
#include <map>
#include <mpi.h>

namespace
{
  struct Counts
  {
    long long messages = 0, bytes = 0, collectives = 0, collective_bytes = 0;
  };

  std::map<int, Counts> counts_of_levels;
  int level_now = 0;

  long long bytes_of(const int count, MPI_Datatype type)
  {
    int size = 0;
    PMPI_Type_size(type, &size);
    return static_cast<long long>(count) * size;
  }

  void count_message(const int count, MPI_Datatype type)
  {
    Counts &counts = counts_of_levels[level_now];
    ++counts.messages;
    counts.bytes += bytes_of(count, type);
  }

  void count_collective(const long long bytes)
  {
    Counts &counts = counts_of_levels[level_now];
    ++counts.collectives;
    counts.collective_bytes += bytes;
  }

  int size_of(MPI_Comm communicator)
  {
    int size = 1;
    PMPI_Comm_size(communicator, &size);
    return size;
  }

  void print_most(const int level, const Counts &counts)
  {
    const std::array<long long, 4> own{counts.messages, counts.bytes, counts.collectives,
                                       counts.collective_bytes};
    std::array<long long, 4> most{};
    PMPI_Reduce(own.data(), most.data(), 4, MPI_LONG_LONG, MPI_MAX, 0, MPI_COMM_WORLD);
    int rank = 0;
    PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
    if (rank > 0)
      return;
    std::cout << "counted " << level;
    for (const long long number : most)
      std::cout << ' ' << number;
    std::cout << '\n';
  }
} // namespace

extern "C" {
int MPI_Pcontrol(const int level, ...)
{
  level_now = level;
  counts_of_levels[level];
  return MPI_SUCCESS;
}

int MPI_Finalize()
{
  for (const auto &[level, counts] : counts_of_levels)
    print_most(level, counts);
  std::cout << std::flush;
  return PMPI_Finalize();
}

int MPI_Send(const void *data, int count, MPI_Datatype type, int to, int tag, MPI_Comm communicator)
{
  count_message(count, type);
  return PMPI_Send(data, count, type, to, tag, communicator);
}

int MPI_Rsend(const void *data, int count, MPI_Datatype type, int to, int tag, MPI_Comm communicator)
{
  count_message(count, type);
  return PMPI_Rsend(data, count, type, to, tag, communicator);
}

int MPI_Isend(const void *data, int count, MPI_Datatype type, int to, int tag, MPI_Comm communicator,
              MPI_Request *request)
{
  count_message(count, type);
  return PMPI_Isend(data, count, type, to, tag, communicator, request);
}

int MPI_Irsend(const void *data, int count, MPI_Datatype type, int to, int tag, MPI_Comm communicator,
               MPI_Request *request)
{
  count_message(count, type);
  return PMPI_Irsend(data, count, type, to, tag, communicator, request);
}

int MPI_Barrier(MPI_Comm communicator)
{
  count_collective(0);
  return PMPI_Barrier(communicator);
}

int MPI_Bcast(void *data, int count, MPI_Datatype type, int root, MPI_Comm communicator)
{
  count_collective(bytes_of(count, type));
  return PMPI_Bcast(data, count, type, root, communicator);
}

int MPI_Reduce(const void *data, void *result, int count, MPI_Datatype type, MPI_Op operation, int root,
               MPI_Comm communicator)
{
  count_collective(bytes_of(count, type));
  return PMPI_Reduce(data, result, count, type, operation, root, communicator);
}

int MPI_Allreduce(const void *data, void *result, int count, MPI_Datatype type, MPI_Op operation,
                  MPI_Comm communicator)
{
  count_collective(bytes_of(count, type));
  return PMPI_Allreduce(data, result, count, type, operation, communicator);
}

int MPI_Scan(const void *data, void *result, int count, MPI_Datatype type, MPI_Op operation,
             MPI_Comm communicator)
{
  count_collective(bytes_of(count, type));
  return PMPI_Scan(data, result, count, type, operation, communicator);
}

int MPI_Allgather(const void *data, int count, MPI_Datatype type, void *all, int n_received,
                  MPI_Datatype received, MPI_Comm communicator)
{
  count_collective(bytes_of(n_received, received) * size_of(communicator));
  return PMPI_Allgather(data, count, type, all, n_received, received, communicator);
}

int MPI_Allgatherv(const void *data, int count, MPI_Datatype type, void *all, const int *n_received,
                   const int *begins, MPI_Datatype received, MPI_Comm communicator)
{
  long long bytes = 0;
  for (int rank = 0; rank < size_of(communicator); ++rank)
    bytes += bytes_of(n_received[rank], received);
  count_collective(bytes);
  return PMPI_Allgatherv(data, count, type, all, n_received, begins, received, communicator);
}
}
