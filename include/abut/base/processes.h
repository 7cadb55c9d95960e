// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/archive.h>
#include <abut/base/launch.h>

#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <type_traits>
#include <vector>

namespace abut
{
  class Communicator;

  /// What all processes have given each other.
  class Gathered
  {
  public:
    /// Room for so many bytes of each.
    explicit Gathered(std::vector<std::size_t> sizes, std::size_t alignment = 1);

    char *data() { return bytes_.get(); }
    /// Where those of a process begin: at a multiple of the alignment.
    std::size_t begin(const unsigned int rank) const { return begins_[rank]; }
    /// Takes the values that a process has packed.
    Archive of(const unsigned int rank) const { return {bytes_.get() + begins_[rank], sizes_[rank]}; }

  private:
    std::vector<std::size_t> sizes_, begins_;
    std::unique_ptr<char[]> bytes_;
  };

  /**
   * The processes of one run, or those that share a body: MPI, which nobody else uses but the libraries that
   * `communicator` is handed to. All of them do the same things in the same order, but for the turns of
   * bodies (see Executor), and meet in `exchange`.
   *
   * An error in any of them ends them all: it is told to the others where they meet next, and thrown there.
   * So nobody waits for one that has failed, and as all have the same error, one is enough to print it.
   */
  class Processes
  {
  public:
    /// Those of the run: initialises MPI, which ends with the object. Throws UserError where MPI knows of
    /// other processes than the launch.
    explicit Processes(const Launch &launch);
    ~Processes();
    Processes(const Processes &) = delete;
    Processes &operator=(const Processes &) = delete;

    unsigned int size() const { return size_; }
    unsigned int rank() const { return rank_; }
    const Communicator &communicator() const { return *communicator_; }

    /// Those with the given ranks, which increase, as processes of their own, numbered in the same order;
    /// null in all others. All processes have to ask for it.
    std::shared_ptr<Processes> group(const std::vector<unsigned int> &ranks) const;

    /**
     * Everybody's bytes. `failure`: what has gone wrong here instead, or null. `meeting`: what the
     * bytes are, not 0; all processes must say the same. Throws the failure of the lowest rank that has one,
     * as a UserError, ComputationError, std::bad_alloc or std::runtime_error, in all processes.
     */
    Gathered exchange(Bytes own, const std::exception_ptr &failure, std::uint64_t meeting);

    /// Everybody's value of what f returns, by rank: f is this process's own work. See `exchange`.
    template <typename Function> auto collect(const std::uint64_t meeting, const Function &f)
    {
      using T = std::decay_t<decltype(f())>;
      T own;
      Bytes packed;
      std::exception_ptr failure;
      try
      {
        own = f();
        Archive(packed, Archive::Direction::pack)(own);
      }
      catch (...)
      {
        failure = std::current_exception();
      }
      const Gathered all = exchange(std::move(packed), failure, meeting);
      std::vector<T> values(size_);
      for (unsigned int rank = 0; rank < size_; ++rank)
      {
        Archive archive = all.of(rank);
        archive(values[rank]);
      }
      return values;
    }

    /**
     * Runs f, in which all processes talk to each other by a library, when all have come. What it throws has
     * to be thrown in all of them, a ComputationError; another exception is this process's alone, for which
     * the others would wait without end: it is printed and ends all of them at once.
     */
    void together(std::uint64_t meeting, const std::function<void()> &f);

    /// Runs f, in all processes, and waits for the others, which are not met before the next `run`. Throws
    /// what has gone wrong in any of them.
    void run(const std::function<void()> &f);

  private:
    explicit Processes(std::unique_ptr<Communicator> communicator);
    /// Prints what only this process knows of, while the others wait for it, and ends all of them.
    [[noreturn]] void end_all(const std::exception_ptr &failure) const;

    std::unique_ptr<Communicator> communicator_;
    unsigned int size_ = 1, rank_ = 0;
    std::exception_ptr ended_by_; ///< the error of one that has ended; null while all go on
  };
} // namespace abut
