// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/communicator.h>
#include <abut/base/processes.h>
#include <abut/base/user_error.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <new>
#include <numeric>
#include <utility>

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
        text = "out of memory";
        return out_of_memory;
      }
      catch (const std::exception &error)
      {
        text = error.what();
        return other;
      }
      catch (...) // Trilinos throws numbers
      {
        text = "an error of a library";
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

    /// Everybody's bytes. MPI counts in int: where that is not enough, in pages.
    Gathered gather(Bytes own, const std::vector<Announcement> &all, const MPI_Comm communicator)
    {
      constexpr std::size_t page = 4096, most_bytes = std::size_t(1) << 30;
      std::vector<std::size_t> sizes;
      for (const Announcement &announced : all)
        sizes.push_back(announced.size);
      const std::size_t total = std::accumulate(sizes.begin(), sizes.end(), std::size_t(0)),
                        unit = total < most_bytes ? 1 : page;
      const auto in_units = [&](const std::size_t size) {
        return static_cast<int>((size + unit - 1) / unit);
      };
      Gathered gathered(sizes, unit);
      std::vector<int> counts, begins;
      for (unsigned int rank = 0; rank < all.size(); ++rank)
      {
        counts.push_back(in_units(sizes[rank]));
        begins.push_back(in_units(gathered.begin(rank)));
      }
      const int count = in_units(own.size());
      own.resize(static_cast<std::size_t>(count) * unit);
      MPI_Datatype unit_type = MPI_DATATYPE_NULL;
      MPI_Type_contiguous(static_cast<int>(unit), MPI_BYTE, &unit_type);
      MPI_Type_commit(&unit_type);
      MPI_Allgatherv(own.data(), count, unit_type, gathered.data(), counts.data(), begins.data(), unit_type,
                     communicator);
      MPI_Type_free(&unit_type);
      return gathered;
    }

    /// The words of the process that has failed, in all of them; `own` are its own there.
    std::string words_of(const std::size_t failed, const Announcement &announced, std::string own,
                         const MPI_Comm communicator)
    {
      own.resize(announced.size);
      MPI_Bcast(own.data(), static_cast<int>(own.size()), MPI_CHAR, static_cast<int>(failed), communicator);
      return own;
    }

    /// MPI's, of all processes.
    std::unique_ptr<Communicator> initialised()
    {
      int provided = 0;
      MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
      return std::make_unique<Communicator>(MPI_COMM_WORLD);
    }
  } // namespace

  Communicator::~Communicator()
  {
    if (handle_ == MPI_COMM_WORLD)
      MPI_Finalize();
    else
      MPI_Comm_free(&handle_);
  }

  Processes::Processes(std::unique_ptr<Communicator> communicator) : communicator_(std::move(communicator))
  {
    int size = 1, rank = 0;
    MPI_Comm_size(communicator_->handle(), &size);
    MPI_Comm_rank(communicator_->handle(), &rank);
    size_ = static_cast<unsigned int>(size);
    rank_ = static_cast<unsigned int>(rank);
  }

  Processes::Processes(const Launch &launch) : Processes(initialised())
  {
    if (static_cast<int>(size_) != launch.n_processes)
      throw UserError("received " + std::to_string(launch.n_processes) +
                      " processes, of which the MPI library of this program sees " + std::to_string(size_) +
                      "; start them with the mpirun of that library (Open MPI)");
  }

  Processes::~Processes() = default;

  std::shared_ptr<Processes> Processes::group(const std::vector<unsigned int> &ranks) const
  {
    const bool is_in = std::binary_search(ranks.begin(), ranks.end(), rank_);
    MPI_Comm handle = MPI_COMM_NULL;
    MPI_Comm_split(communicator_->handle(), is_in ? 0 : MPI_UNDEFINED, static_cast<int>(rank_), &handle);
    if (!is_in)
      return nullptr;
    return std::shared_ptr<Processes>(new Processes(std::make_unique<Communicator>(handle)));
  }

  Gathered::Gathered(std::vector<std::size_t> sizes, const std::size_t alignment) : sizes_(std::move(sizes))
  {
    std::size_t end = 0;
    for (const std::size_t size : sizes_)
    {
      begins_.push_back(end);
      end += (size + alignment - 1) / alignment * alignment;
    }
    bytes_.reset(new char[end]); // not set to zero
  }

  Gathered Processes::exchange(Bytes own, const std::exception_ptr &failure, const std::uint64_t meeting)
  {
    if (ended_by_)
      std::rethrow_exception(ended_by_);
    std::string text;
    const Failure kind = kind_of(failure, text);
    const Announcement announced{meeting, kind == none ? own.size() : text.size(), kind};
    std::vector<Announcement> all(size_);
    MPI_Allgather(&announced, n_words, MPI_UINT64_T, all.data(), n_words, MPI_UINT64_T,
                  communicator_->handle());

    std::exception_ptr error;
    if (const auto failed = std::find_if(all.begin(), all.end(), is_failure); failed != all.end())
      error = error_of(failed->failure, words_of(static_cast<std::size_t>(failed - all.begin()), *failed,
                                                 text, communicator_->handle()));
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

    try
    {
      return gather(std::move(own), all, communicator_->handle());
    }
    catch (...) // the others wait in there
    {
      end_all(std::current_exception());
    }
  }

  void Processes::together(const std::uint64_t meeting, const std::function<void()> &f)
  {
    exchange({}, nullptr, meeting);
    try
    {
      f();
    }
    catch (const ComputationError &)
    {
      throw;
    }
    catch (...)
    {
      end_all(std::current_exception());
    }
  }

  void Processes::end_all(const std::exception_ptr &failure) const
  {
    std::string text;
    kind_of(failure, text);
    std::cerr << "abut: process " + std::to_string(rank_) + " of " + std::to_string(size_) +
                     " could not go on: " + text + '\n';
    MPI_Abort(communicator_->handle(), 2);
    std::abort();
  }

  void Processes::run(const std::function<void()> &f)
  {
    ended_by_ = nullptr;
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
