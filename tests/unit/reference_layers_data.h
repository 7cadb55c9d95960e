// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/reference/layers_sliding.h>

namespace abut
{
  inline LayersSlidingData equal_layers()
  {
    const Layer steel{2.1e5, 0.3, 1.};
    return {{{steel, steel}}, 4., 1e-3, 1.366e-3};
  }

  inline LayersSlidingData different_layers()
  {
    return {{{{2.1e5, 0.3, 1.}, {0.7e5, 0.42, 1.7}}}, 3.3, 2e-3, 2.2e-3};
  }
} // namespace abut
