// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/adaptation/indicator.h>

#include "finite_elements_testing.h"
#include <functional>

namespace abut
{
  inline const EstimatorKind estimators[] = {EstimatorKind::kelly, EstimatorKind::zz, EstimatorKind::spr};
  inline std::string name_of(const EstimatorKind kind)
  {
    return kind == EstimatorKind::kelly ? "kelly" : kind == EstimatorKind::zz ? "zz" : "spr";
  }
  inline std::string name_of(const Variant &variant)
  {
    return (variant.type == CellType::triangles ? "triangles " : "quadrilaterals ") +
           std::to_string(variant.degree);
  }

  /// What an indicator says of a body that is loaded and supported, and touched by nothing.
  inline CellErrors estimate(FiniteElementBody &body, const EstimatorKind kind)
  {
    body.prepare();
    const Eigen::VectorXd forces = Eigen::VectorXd::Zero(body.trace_size());
    const Eigen::VectorXd deformation = body.deformation(forces, 0.);
    return make_indicator(kind)->estimate({body, deformation, forces});
  }
} // namespace abut
