// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/processes.h>
#include <abut/base/user_error.h>

#include <algorithm>
#include <mpi.h>
#include <new>

namespace abut
{
  namespace
  {
    /// What a process tells the others before its bytes.
    struct Announcement
    {
      std::uint64_t meeting, size, failure;
    };
    constexpr int n_words = 3;
    constexpr std::uint64_t the_end = 0; ///< the last meeting

    enum Failure : std::uint64_t
    {
      none,
      user_error,
      computation_error,
      out_of_memory,
      other
    };

    Failure kind_of(const std::exception_ptr &failure, std::string &text)
    {
      if (!failure)
        return none;
      try
      {
        std::rethrow_exception(failure);
      }
      catch (const UserError &error)
      {
        text = error.what();
        return user_error;
      }
      catch (const ComputationError &error)
      {
        text = error.what();
        return computation_error;
      }
      catch (const std::bad_alloc &)
      {
        return out_of_memory;
      }
      catch (const std::exception &error)
      {
        text = error.what();
        return other;
      }
    }

    std::exception_ptr error_of(const std::uint64_t kind, const std::string &text)
    {
      switch (kind)
      {
      case user_error:
        return std::make_exception_ptr(UserError(text));
      case computation_error:
        return std::make_exception_ptr(ComputationError(text));
      case out_of_memory:
        return std::make_exception_ptr(std::bad_alloc());
      default:
        return std::make_exception_ptr(std::runtime_error(text));
      }
    }

    bool is_failure(const Announcement &announced)
    {
      return announced.failure != none;
    }

    /// Gives everybody the bytes of one process; their number is known. MPI counts in int.
    void broadcast(Bytes &bytes, const int from)
    {
      constexpr std::size_t at_once = std::size_t(1) << 30;
      for (std::size_t begin = 0; begin < bytes.size(); begin += at_once)
        MPI_Bcast(bytes.data() + begin, static_cast<int>(std::min(at_once, bytes.size() - begin)), MPI_BYTE,
                  from, MPI_COMM_WORLD);
    }
  } // namespace

  Processes::Processes(const Launch &launch)
  {
    int provided = 0, size = 1, rank = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    size_ = static_cast<unsigned int>(size);
    rank_ = static_cast<unsigned int>(rank);
    if (size == launch.n_processes)
      return;
    MPI_Finalize();
    throw UserError("received " + std::to_string(launch.n_processes) +
                    " processes, of which the MPI library of this program sees " + std::to_string(size) +
                    "; start them with the mpirun of that library (Open MPI)");
  }

  Processes::~Processes()
  {
    MPI_Finalize();
  }

  std::vector<Bytes> Processes::exchange(Bytes own, const std::exception_ptr &failure,
                                         const std::uint64_t meeting)
  {
    if (ended_by_)
      std::rethrow_exception(ended_by_);
    std::string text;
    const Failure kind = kind_of(failure, text);
    if (kind != none)
      own.assign(text.begin(), text.end());
    const Announcement announced{meeting, own.size(), kind};
    std::vector<Announcement> all(size_);
    MPI_Allgather(&announced, n_words, MPI_UINT64_T, all.data(), n_words, MPI_UINT64_T, MPI_COMM_WORLD);
    const auto bytes_of = [&](const std::size_t rank) {
      Bytes bytes = rank == rank_ ? std::move(own) : Bytes(all[rank].size);
      broadcast(bytes, static_cast<int>(rank));
      return bytes;
    };

    std::exception_ptr error;
    if (const auto failed = std::find_if(all.begin(), all.end(), is_failure); failed != all.end())
    {
      const Bytes words = bytes_of(static_cast<std::size_t>(failed - all.begin()));
      error = error_of(failed->failure, {words.begin(), words.end()});
    }
    else if (std::any_of(all.begin(), all.end(),
                         [&](const Announcement &other) { return other.meeting != meeting; }))
      error = std::make_exception_ptr(ComputationError(
          "the processes have come to different results, which does not happen on machines of "
          "one kind; start them on such"));
    if (error)
    {
      if (std::any_of(all.begin(), all.end(),
                      [](const Announcement &other) { return other.meeting == the_end; }))
        ended_by_ = error;
      std::rethrow_exception(error);
    }

    std::vector<Bytes> bytes;
    for (std::size_t rank = 0; rank < size_; ++rank)
      bytes.push_back(bytes_of(rank));
    return bytes;
  }

  void Processes::run(const std::function<void()> &f)
  {
    std::exception_ptr failure;
    try
    {
      f();
    }
    catch (...)
    {
      failure = std::current_exception();
    }
    exchange({}, failure, the_end);
  }
} // namespace abut
