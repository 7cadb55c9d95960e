// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/adaptation/indicator.h>

#include "finite_elements_testing.h"
#include <functional>

namespace abut
{
  inline const std::vector<std::string> estimators = {"kelly", "zz", "spr"};

  inline std::unique_ptr<Indicator> indicator_of(const std::string &estimator)
  {
    AdaptationParameters parameters;
    parameters.estimator = estimator;
    return make_indicator(parameters);
  }

  inline std::string name_of(const Variant &variant)
  {
    return (variant.type == CellType::triangles ? "triangles " : "quadrilaterals ") +
           std::to_string(variant.degree);
  }

  /// What an indicator says of a body that is loaded and supported, and touched by nothing.
  inline CellErrors estimate(FiniteElementBody &body, const std::string &kind)
  {
    body.prepare();
    const Eigen::VectorXd forces = Eigen::VectorXd::Zero(body.trace_size());
    const Eigen::VectorXd deformation = body.deformation(forces, 0.);
    return indicator_of(kind)->estimate({body, deformation, forces});
  }
} // namespace abut
