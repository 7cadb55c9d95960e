// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace abut::testing
{
  /// A run of the program that may be killed with all its processes, by mpirun where there are several.
  class KilledProcess
  {
  public:
    KilledProcess(unsigned int n_processes, const std::vector<std::string> &arguments);
    ~KilledProcess();
    KilledProcess(const KilledProcess &) = delete;
    KilledProcess &operator=(const KilledProcess &) = delete;

    /// Waits until a file has been made or replaced so many times, or the run has ended.
    void wait_for_changes(const std::string &path, unsigned int n_changes);
    /// Waits so long, or until the run has ended.
    void wait_for(std::chrono::milliseconds time);
    /// Until it has ended: its exit status, or -1.
    int wait();
    /// By SIGKILL, wherever it is; afterwards none of its processes is left.
    void kill();

  private:
    bool has_ended();

    pid_t leader_; ///< of a session that all its processes belong to
    std::optional<int> status_;
  };
} // namespace abut::testing
