// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/archive.h>

#include <cstddef>
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

  /**
   * The process of every body: that of `before` for bodies that `stay` where they are, then the dearest one
   * first, each where there is the least to do. At most 4/3 of the best longest sum of costs where none stays
   * (Graham, Bounds on multiprocessing timing anomalies, SIAM J. Appl. Math. 17, 1969).
   */
  std::vector<unsigned int> least_loaded(const std::vector<double> &costs, const std::vector<bool> &stay,
                                         std::vector<unsigned int> before, unsigned int n_processes);

  /**
   * Who computes what of the bodies of a scene: threads of one process or, where several processes share a
   * run, the one in which a body lives. What is dear - a body's stiffness, factor and operators, and what
   * needs them - is there alone; meshes, fields and the interface problem are the same everywhere.
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

    /// Chooses where bodies live (see least_loaded).
    void assign(const std::vector<double> &costs, const std::vector<bool> &stay)
    {
      owners_ = least_loaded(costs, stay, owners_, n_processes());
    }
    bool is_here(const std::size_t body) const { return !processes_ || owners_[body] == rank_; }

    /**
     * {f(0), ..., f(n_bodies - 1)}, of every body: f runs where the body lives, side by side as in
     * `for_each`, and everybody gets all that comes of it. All processes have to call it, and not from within
     * a loop. An exception in any of them is passed on in all.
     */
    template <typename Function> auto of_bodies(const std::size_t n_bodies, const Function &f) const
    {
      using T = std::decay_t<decltype(f(std::size_t(0)))>;
      std::vector<T> results(n_bodies);
      const auto turn = [&](const std::size_t a) {
        if (is_here(a))
          results[a] = f(a);
      };
      if (!processes_)
        for_each(n_bodies, turn);
      else
        exchange(n_bodies, turn, typeid(T).hash_code(),
                 [&](Archive &archive, const std::size_t a) { archive(results[a]); });
      return results;
    }

  private:
    /// Runs the turns and passes on what they have made, which `pass` packs and unpacks.
    void exchange(std::size_t n_bodies, const std::function<void(std::size_t)> &turn, std::size_t type,
                  const std::function<void(Archive &, std::size_t)> &pass) const;

    std::shared_ptr<Processes> processes_; ///< null: this one alone
    unsigned int n_processes_ = 1, rank_ = 0;
    std::vector<unsigned int> owners_; ///< rank of every body's process
  };
} // namespace abut
