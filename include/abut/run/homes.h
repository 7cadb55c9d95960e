// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/executor.h>
#include <abut/bodies/body.h>

#include <memory>
#include <vector>

namespace abut
{
  /// In how many of n processes a body lives: as its description says or, where that says nothing, in one;
  /// in all where its factor would not fit into `free_bytes`, what a process has. Throws UserError for more
  /// than there are.
  unsigned int n_homes(const BodyDescription &body, std::size_t n_unknowns, unsigned int n_processes,
                       double free_bytes);

  /// What decides where bodies are made, as far as their descriptions tell what they cost.
  std::vector<BodyLoad> described_loads(const std::vector<BodyDescription> &bodies);

  /// What decides where the bodies live: their costs, the unknowns to the power 1.25, as the seconds for a
  /// factor grow from 10 thousand to a million of them, and `n_homes`. `stay`: bodies that are left where
  /// they are. All processes have to call it.
  std::vector<BodyLoad> body_loads(const std::vector<std::unique_ptr<Body>> &bodies,
                                   const std::vector<bool> &stay, const Executor &executor);
} // namespace abut
