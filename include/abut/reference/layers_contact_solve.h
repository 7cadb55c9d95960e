// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/reference/contact_pressure.h>

namespace abut
{
  struct LayersContactData;

  /// The data with a length that makes no difference from infinity where the ends are infinite. Throws
  /// UserError for data that make no sense.
  LayersContactData with_finite_length(const LayersContactData &data);

  /// The contact pressure of LayersContact for data of finite length; errors as there.
  ContactPressure solve_layers_contact(const LayersContactData &data);
} // namespace abut
