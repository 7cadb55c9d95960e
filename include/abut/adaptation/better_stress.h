// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/adaptation/indicator.h>

#include <string>

namespace abut
{
  /// Takes the difference between a better stress, at SamplePoints::comparison, and the body's own for the
  /// error of the latter.
  CellErrors compare(const BodySolution &solution, const std::vector<Stress> &better);

  /// Throws UserError for a body with regions of other materials, which this estimator is not made for: a
  /// better stress is continuous, or that of one material.
  void check_one_material(const Body &body, const std::string &estimator);
} // namespace abut
