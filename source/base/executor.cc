// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/executor.h>
#include <abut/base/processes.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <numeric>
#include <set>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <utility>

// Exported by OpenBLAS alone: with another BLAS the address is null.
extern "C" void openblas_set_num_threads(int) __attribute__((weak));

namespace abut
{
  namespace
  {
    bool use_one_blas_thread()
    {
      if (openblas_set_num_threads != nullptr)
        openblas_set_num_threads(1);
      return true;
    }
  } // namespace

  void for_each(const std::size_t n, const std::function<void(std::size_t)> &f)
  {
    Assert(f, dealii::ExcMessage("there is a function to run"));
    [[maybe_unused]] static const bool once = use_one_blas_thread();
    std::atomic<std::size_t> first_failed(
        n); // whichever comes first in time: messages are the same every time
    std::exception_ptr failure;
    std::mutex mutex;
    tbb::parallel_for(std::size_t(0), n, [&](const std::size_t i) {
      if (i > first_failed)
        return;
      try
      {
        f(i);
      }
      catch (...)
      {
        const std::lock_guard<std::mutex> lock(mutex);
        if (i >= first_failed)
          return;
        first_failed = i;
        failure = std::current_exception();
      }
    });
    if (failure)
      std::rethrow_exception(failure);
  }

  void by_itself(const std::function<void()> &f)
  {
    tbb::this_task_arena::isolate(f);
  }

  namespace
  {
    double cost_of_each(const BodyLoad &body)
    {
      return body.cost / body.n_processes;
    }

    /// The ranks with the least to do; of those with as much, rather those of `before`.
    Ranks least(const std::vector<double> &loads, const unsigned int n, const Ranks &before)
    {
      AssertIndexRange(n, loads.size() + 1);
      Ranks ranks(loads.size());
      std::iota(ranks.begin(), ranks.end(), 0u);
      const auto key = [&](const unsigned int rank) {
        return std::pair(loads[rank], !std::binary_search(before.begin(), before.end(), rank));
      };
      std::stable_sort(ranks.begin(), ranks.end(),
                       [&](const unsigned int r, const unsigned int s) { return key(r) < key(s); });
      ranks.resize(n);
      std::sort(ranks.begin(), ranks.end());
      return ranks;
    }
  } // namespace

  std::vector<Ranks> least_loaded(const std::vector<BodyLoad> &bodies, std::vector<Ranks> before,
                                  const unsigned int n_processes)
  {
    std::vector<double> loads(n_processes, 0.);
    std::vector<std::size_t> movable;
    std::vector<Ranks> homes = std::move(before);
    homes.resize(bodies.size());
    const auto add = [&](const std::size_t a) {
      for (const unsigned int rank : homes[a])
        loads[rank] += cost_of_each(bodies[a]);
    };
    for (std::size_t a = 0; a < bodies.size(); ++a)
      if (bodies[a].stays)
        add(a);
      else
        movable.push_back(a);
    std::stable_sort(movable.begin(), movable.end(), [&](const std::size_t a, const std::size_t b) {
      return cost_of_each(bodies[a]) > cost_of_each(bodies[b]);
    });
    for (const std::size_t a : movable)
    {
      homes[a] = least(loads, bodies[a].n_processes, homes[a]);
      add(a);
    }
    return homes;
  }

  Executor::Executor(std::shared_ptr<Processes> processes) : processes_(std::move(processes))
  {
    if (!processes_)
      return;
    n_processes_ = processes_->size();
    rank_ = processes_->rank();
  }

  void Executor::assign(const std::vector<BodyLoad> &bodies)
  {
    if (!processes_)
      return;
    homes_ = least_loaded(bodies, std::move(homes_), n_processes_);
    groups_.resize(bodies.size());
    for (std::size_t a = 0; a < bodies.size(); ++a)
      if (!bodies[a].stays)
        groups_[a] = homes_[a].size() > 1 ? processes_->group(homes_[a]) : nullptr;
  }

  bool Executor::is_home(const std::size_t body) const
  {
    return !processes_ || std::binary_search(homes_[body].begin(), homes_[body].end(), rank_);
  }

  unsigned int Executor::n_busy(const std::vector<std::size_t> &bodies) const
  {
    if (!processes_)
      return 1;
    std::set<unsigned int> busy;
    for (const std::size_t a : bodies)
      busy.insert(homes_[a].begin(), homes_[a].end());
    return static_cast<unsigned int>(busy.size());
  }

  std::exception_ptr Executor::take_shared_turns(const std::function<void(std::size_t)> &turn) const
  {
    std::exception_ptr failure;
    for (std::size_t a = 0; a < groups_.size(); ++a)
      if (groups_[a])
        try
        {
          groups_[a]->run([&]() {
            if (failure) // the others wait for this process in the turns to come
              std::rethrow_exception(failure);
            turn(a);
          });
        }
        catch (...)
        {
          failure = std::current_exception();
        }
    return failure;
  }

  void Executor::exchange(const std::size_t n_bodies, const std::function<void(std::size_t)> &turn,
                          const std::size_t type,
                          const std::function<void(Archive &, std::size_t)> &pass) const
  {
    AssertDimension(n_bodies, homes_.size());
    Bytes own;
    std::exception_ptr failure = take_shared_turns(turn);
    try
    {
      if (failure)
        std::rethrow_exception(failure);
      for_each(n_bodies, [&](const std::size_t a) {
        if (tells_of(a) && homes_[a].size() == 1)
          turn(a);
      });
      Archive archive(own, Archive::Direction::pack);
      for (std::size_t a = 0; a < n_bodies; ++a)
        if (tells_of(a))
          pass(archive, a);
    }
    catch (...)
    {
      failure = std::current_exception();
    }
    const Gathered all = processes_->exchange(std::move(own), failure, type);
    for (unsigned int rank = 0; rank < n_processes_; ++rank)
    {
      if (rank == rank_)
        continue;
      Archive archive = all.of(rank);
      for (std::size_t a = 0; a < n_bodies; ++a)
        if (homes_[a].front() == rank)
          pass(archive, a);
    }
  }
} // namespace abut
