// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <functional>

namespace abut
{
  /**
   * Runs f(0), ..., f(n - 1) side by side, in any order; the turns must not touch each other's results. The
   * first exception is passed on when the turns that have begun have ended; the others need not begin.
   *
   * This file is the only one that knows of threads. Its loops may stand within each other. Before the first
   * one a threaded BLAS (OpenBLAS) is told to use one thread in each caller: the turns already run side by
   * side.
   */
  void for_each(std::size_t n, const std::function<void(std::size_t)> &f);

  /**
   * Runs f(a) for every body a of a scene, like `for_each`: threads of one process today. An executor of
   * several processes would run the turns of the bodies that live in its own and leave the entries of the
   * others as they are; the sums over bodies that follow such a loop (responses, energies, errors) would
   * then be sums over processes, and one process's exception would have to end them all.
   */
  void for_each_body(std::size_t n_bodies, const std::function<void(std::size_t)> &f);
} // namespace abut
