// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/executor.h>

#include <functional>
#include <vector>

namespace abut
{
  /// Runs f(0), ..., f(n - 1) of bodies: one after the other where they may share a mesh among processes, as
  /// that takes all of these in the same order; the others side by side.
  inline void for_each_body(const std::size_t n, const std::function<bool(std::size_t)> &shares_mesh,
                            const std::function<void(std::size_t)> &f)
  {
    std::vector<std::size_t> others;
    for (std::size_t a = 0; a < n; ++a)
      if (shares_mesh(a))
        f(a);
      else
        others.push_back(a);
    for_each(others.size(), [&](const std::size_t i) { f(others[i]); });
  }
} // namespace abut
