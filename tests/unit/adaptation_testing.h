// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/adaptation/indicator.h>

#include "finite_elements_testing.h"
#include <functional>
#include <map>

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

  /// What each of the estimators says of a body under its loads and supports and contact forces (a trace
  /// vector).
  inline std::map<std::string, CellErrors> estimates(FiniteElementBody &body, const Eigen::VectorXd &forces)
  {
    body.prepare();
    const Eigen::VectorXd deformation = body.deformation(forces, 0.);
    std::map<std::string, CellErrors> errors;
    for (const std::string &kind : estimators)
      errors.emplace(kind, indicator_of(kind)->estimate({body, deformation, forces}));
    return errors;
  }
  inline std::map<std::string, CellErrors> estimates(FiniteElementBody &body)
  {
    return estimates(body, Eigen::VectorXd::Zero(body.trace_size()));
  }
} // namespace abut
