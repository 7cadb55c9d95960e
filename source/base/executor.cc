// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/executor.h>
#include <abut/base/processes.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <tbb/parallel_for.h>
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

  std::vector<unsigned int> least_loaded(const std::vector<double> &costs, const std::vector<bool> &stay,
                                         std::vector<unsigned int> before, const unsigned int n_processes)
  {
    AssertDimension(costs.size(), stay.size());
    std::vector<double> loads(n_processes, 0.);
    std::vector<std::size_t> movable;
    std::vector<unsigned int> owners = std::move(before);
    owners.resize(costs.size(), 0);
    for (std::size_t a = 0; a < costs.size(); ++a)
      if (stay[a])
        loads[owners[a]] += costs[a];
      else
        movable.push_back(a);
    std::stable_sort(movable.begin(), movable.end(),
                     [&](const std::size_t a, const std::size_t b) { return costs[a] > costs[b]; });
    for (const std::size_t a : movable)
    {
      const auto least = std::min_element(loads.begin(), loads.end());
      owners[a] = static_cast<unsigned int>(least - loads.begin());
      *least += costs[a];
    }
    return owners;
  }

  Executor::Executor(std::shared_ptr<Processes> processes) : processes_(std::move(processes))
  {
    if (!processes_)
      return;
    n_processes_ = processes_->size();
    rank_ = processes_->rank();
  }

  void Executor::exchange(const std::size_t n_bodies, const std::function<void(std::size_t)> &turn,
                          const std::size_t type,
                          const std::function<void(Archive &, std::size_t)> &pass) const
  {
    AssertDimension(n_bodies, owners_.size());
    Bytes own;
    std::exception_ptr failure;
    try
    {
      for_each(n_bodies, turn);
      Archive archive(own, Archive::Direction::pack);
      for (std::size_t a = 0; a < n_bodies; ++a)
        if (is_here(a))
          pass(archive, a);
    }
    catch (...)
    {
      failure = std::current_exception();
    }
    std::vector<Bytes> all = processes_->exchange(std::move(own), failure, type);
    for (unsigned int rank = 0; rank < all.size(); ++rank)
    {
      if (rank == rank_)
        continue;
      Archive archive(all[rank], Archive::Direction::unpack);
      for (std::size_t a = 0; a < n_bodies; ++a)
        if (owners_[a] == rank)
          pass(archive, a);
    }
  }
} // namespace abut
