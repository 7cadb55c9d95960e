// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/results/results.h>

#include "estimator_fields.h"
#include <string>
#include <vector>

/// One body and the stress with which it answers what acts on it.
struct KnownBody
{
  abut::BodyDescription description;
  std::function<abut::Stress(const abut::Vector2 &)> stress;
};

/// The outward normal of a side, by the place.
using SideNormal = std::function<abut::Vector2(const abut::Vector2 &)>;
SideNormal outward(double x, double y);

/// Conditions with the values of a field.
void hold(const PlaneField &field, const std::string &side, abut::BodyDescription &body);
void hold_along(const PlaneField &field, const std::string &side, abut::ConditionKind component,
                abut::BodyDescription &body);
void load(const PlaneField &field, const std::string &side, const SideNormal &normal,
          abut::BodyDescription &body);
/// Holds what rigid motions need: the first point in both directions, the other one along y.
void hold_points(const PlaneField &field, const abut::Vector2 &first, const abut::Vector2 &second,
                 abut::BodyDescription &body);

enum class Meshes
{
  uniform,
  adapted ///< Doerfler's marking, half of the squared error
};

/// What an estimator is worth on one mesh after the other, printed as `abut study` does.
class EstimatorPasses
{
public:
  EstimatorPasses(const std::string &title, const KnownBody &body, unsigned int n_passes, Meshes meshes,
                  const std::string &estimator = "fe-be",
                  abut::BoundarySolution boundary_solution = abut::BoundarySolution::trace_space);
  /// The passes of a scene of the folder prm/.
  EstimatorPasses(const std::string &title, const std::string &scene,
                  const std::vector<std::string> &overrides);

  const std::vector<abut::PassRecord> &passes() const { return passes_; }
  const abut::EstimatorQuality &last() const { return passes_.back().quality.value(); }
  /// Every pass, from the one with the number `from` on (the first mesh is 0).
  void expect_effectivity_within(double least, double most, unsigned int from = 0) const;
  void expect_better_ratio_below(double bound, unsigned int from = 0) const;
  void expect_correlation_above(double bound, unsigned int from = 0) const;

private:
  void print(const std::string &title) const;

  std::vector<abut::PassRecord> passes_;
};
