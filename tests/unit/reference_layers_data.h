// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/reference/layers_contact.h>

namespace abut
{
  inline LayersContactData equal_layers()
  {
    const Layer steel{2.1e5, 0.3, 1.};
    return {{{steel, steel}}, 4., 1e-3, 1.366e-3};
  }

  inline LayersContactData different_layers()
  {
    return {{{{2.1e5, 0.3, 1.}, {0.7e5, 0.42, 1.7}}}, 3.3, 2e-3, 2.2e-3};
  }

  inline LayersContactData bonded_and_sliding_layers()
  {
    return {{{{2.1e5, 0.3, 0.6, Layer::Base::bonded}, {0.7e5, 0.42, 1.3}}}, 2.9, 2e-3, 1.7e-3};
  }

  inline LayersContactData bonded_layers()
  {
    return {{{{2.1e5, -0.2, 0.8, Layer::Base::bonded}, {3e5, 0.47, 1.1, Layer::Base::bonded}}},
            3.1,
            2e-3,
            1.9e-3};
  }

  /// The steel layers of equal_layers() without ends.
  inline LayersContactData infinite_layers(Layer::Base base)
  {
    LayersContactData data = equal_layers();
    data.length = 0.;
    data.ends = Layer::Ends::infinite;
    for (Layer &layer : data.layers)
      layer.base = base;
    return data;
  }
} // namespace abut
