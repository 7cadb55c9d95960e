// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/archive.h>

#include <cstddef>
#include <exception>
#include <functional>
#include <memory>
#include <type_traits>
#include <typeinfo>
#include <utility>
#include <vector>

namespace abut
{
  class Processes;

  /**
   * Runs f(0), ..., f(n - 1) side by side, in any order; the turns must not touch each other's results. Of
   * exceptions that of the lowest turn is passed on when all have ended; turns after it need not begin.
   *
   * This file is the only one that knows of threads. Its loops may stand within each other. Before the first
   * one a threaded BLAS (OpenBLAS) is told to use one thread in each caller: the turns already run side by
   * side.
   */
  void for_each(std::size_t n, const std::function<void(std::size_t)> &f);

  /// Runs f, whose inner loops do not take turns of outer ones meanwhile: for work under a lock.
  void by_itself(const std::function<void()> &f);

  /// Ranks of processes, increasing.
  using Ranks = std::vector<unsigned int>;

  /// What decides where a body lives.
  struct BodyLoad
  {
    double cost;                  ///< in any unit
    bool stays = false;           ///< where it is
    unsigned int n_processes = 1; ///< that share it
  };

  /**
   * The processes of every body: those of `before` for bodies that stay where they are, then the dearest one
   * first (its cost in each of its processes), each where there is the least to do, and where it was if there
   * is no less elsewhere. Where none stays and each has one process, at most 4/3 of the best longest sum of
   * costs (Graham, Bounds on multiprocessing timing anomalies, SIAM J. Appl. Math. 17, 1969).
   */
  std::vector<Ranks> least_loaded(const std::vector<BodyLoad> &bodies, std::vector<Ranks> before,
                                  unsigned int n_processes);

  /**
   * Who computes what of the bodies of a scene: threads of one process or, where several processes share a
   * run, the one in which a body lives. What is dear - a body's mesh, stiffness, factor and operators, and
   * what needs them - is there alone; fields and the interface problem are the same everywhere. A body may
   * live in several processes: all of them take its turns, together, and share its stiffness among them.
   */
  class Executor
  {
  public:
    /// One process, in which all bodies live.
    Executor() = default;
    explicit Executor(std::shared_ptr<Processes> processes);

    unsigned int n_processes() const { return n_processes_; }
    /// Whether this is the process that writes and tells.
    bool is_first() const { return rank_ == 0; }

    /// Chooses where bodies live (see least_loaded). All processes have to call it.
    void assign(const std::vector<BodyLoad> &bodies);
    /// All of them; null where this is the only one.
    const std::shared_ptr<Processes> &processes() const { return processes_; }
    /// Those that share a body, this one among them; null where it lives in one, or elsewhere.
    std::shared_ptr<Processes> sharing(const std::size_t body) const
    {
      return processes_ ? groups_[body] : nullptr;
    }
    unsigned int n_processes_of(const std::size_t body) const
    {
      return processes_ ? static_cast<unsigned int>(homes_[body].size()) : 1;
    }
    /// Whether a body lives in this process.
    bool is_home(std::size_t body) const;
    /// Whether this process passes on what comes of a body, and writes its files.
    bool tells_of(const std::size_t body) const { return !processes_ || homes_[body].front() == rank_; }
    /// In how many processes these bodies live.
    unsigned int n_busy(const std::vector<std::size_t> &bodies) const;

    /**
     * {f(0), ..., f(n_bodies - 1)}, of every body: f runs where the body lives and everybody gets all that
     * comes of it. The turns of bodies that live in several processes come first, one after the other, the
     * others side by side as in `for_each`. All processes have to call it, and not from within a loop. An
     * exception in any of them is passed on in all.
     */
    template <typename Function> auto of_bodies(const std::size_t n_bodies, const Function &f) const
    {
      using T = std::decay_t<decltype(f(std::size_t(0)))>;
      std::vector<T> results(n_bodies);
      const auto turn = [&](const std::size_t a) { results[a] = f(a); };
      if (!processes_)
        for_each(n_bodies, turn);
      else
        exchange(n_bodies, turn, typeid(T).hash_code(),
                 [&](Archive &archive, const std::size_t a) { archive(results[a]); });
      return results;
    }

    /// f(), which runs in the first process alone, for everybody. All processes have to call it, and not from
    /// within a loop. An exception is passed on in all.
    template <typename Function> auto from_first(const Function &f) const
    {
      Executor executor = *this;
      executor.homes_ = {Ranks{0}};
      executor.groups_ = {nullptr};
      return std::move(executor.of_bodies(1, [&](const std::size_t) { return f(); }).front());
    }

  private:
    /// Those of bodies that live in several processes. Returns what has gone wrong.
    std::exception_ptr take_shared_turns(const std::function<void(std::size_t)> &turn) const;
    /// Runs the turns that are here and passes on what they have made, which `pass` packs and unpacks.
    void exchange(std::size_t n_bodies, const std::function<void(std::size_t)> &turn, std::size_t type,
                  const std::function<void(Archive &, std::size_t)> &pass) const;

    std::shared_ptr<Processes> processes_; ///< null: this one alone
    unsigned int n_processes_ = 1, rank_ = 0;
    std::vector<Ranks> homes_;                       ///< of every body
    std::vector<std::shared_ptr<Processes>> groups_; ///< of every body, see `sharing`
  };
} // namespace abut
