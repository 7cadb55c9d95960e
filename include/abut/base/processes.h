// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/archive.h>
#include <abut/base/launch.h>

#include <cstdint>
#include <exception>
#include <functional>

namespace abut
{
  /**
   * The processes of one run: MPI, of which this class is the only user. All of them do the same things in
   * the same order, but for the turns of bodies (see Executor), and meet in `exchange`.
   *
   * An error in any of them ends them all: it is told to the others where they meet next, and thrown there.
   * So nobody waits for one that has failed, and as all have the same error, one is enough to print it.
   */
  class Processes
  {
  public:
    /// Initialises MPI. Throws UserError where MPI knows of other processes than the launch.
    explicit Processes(const Launch &launch);
    /// Ends MPI.
    ~Processes();
    Processes(const Processes &) = delete;
    Processes &operator=(const Processes &) = delete;

    unsigned int size() const { return size_; }
    unsigned int rank() const { return rank_; }

    /**
     * Everybody's bytes, by rank. `failure`: what has gone wrong here instead, or null. `meeting`: what the
     * bytes are; all processes must say the same. Throws the failure of the lowest rank that has one, as a
     * UserError, ComputationError, std::bad_alloc or std::runtime_error, in all processes.
     */
    std::vector<Bytes> exchange(Bytes own, const std::exception_ptr &failure, std::uint64_t meeting);

    /// Runs f, in all processes, and waits for the others, which are not met again. Throws what has gone
    /// wrong in any of them.
    void run(const std::function<void()> &f);

  private:
    unsigned int size_ = 1, rank_ = 0;
    std::exception_ptr ended_by_; ///< the error of one that has ended; null while all go on
  };
} // namespace abut
