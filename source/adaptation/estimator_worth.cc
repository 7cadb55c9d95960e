// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/adaptation/estimator_worth.h>

#include <array>

namespace abut
{
  std::optional<EstimatorWorth> estimator_worth(const EstimatorKind kind, const unsigned int degree)
  {
    using Degrees = std::array<EstimatorWorth, 3>;
    constexpr Degrees kelly = {{{.7, 1.1}, {.8, 1.6}, {.7, 1.8}}};
    constexpr Degrees zz = {{{.7, 1.1}, {.3, .8}, {.4, .9}}};
    constexpr Degrees spr = {{{.9, 1.9}, {1.1, 3.1}, {2.1, 6.6}}};
    if (degree > 3)
      return {};
    switch (kind)
    {
    case EstimatorKind::kelly:
      return kelly[degree - 1];
    case EstimatorKind::zz:
      return zz[degree - 1];
    case EstimatorKind::spr:
      return spr[degree - 1];
    case EstimatorKind::none:
    case EstimatorKind::fe_be:
      return {};
    }
    return {};
  }
} // namespace abut
