// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <nlohmann/json.hpp>

#include <cmath>
#include <optional>

namespace abut
{
  using Json = nlohmann::ordered_json;

  /// null for what is no number.
  inline Json number(const double value)
  {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
  }

  inline Json number(const std::optional<double> &value)
  {
    return value ? number(*value) : Json(nullptr);
  }
} // namespace abut
