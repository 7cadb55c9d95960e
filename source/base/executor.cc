// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/executor.h>

#include <deal.II/base/exceptions.h>

#include <tbb/parallel_for.h>

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
    tbb::parallel_for(std::size_t(0), n, f);
  }

  void for_each_body(const std::size_t n_bodies, const std::function<void(std::size_t)> &f)
  {
    for_each(n_bodies, f);
  }
} // namespace abut
