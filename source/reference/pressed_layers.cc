// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/reference/pressed_layers.h>

namespace abut
{
  PressedLayers::PressedLayers(const PressureBetween &solution)
      : data_(solution.data), half_width_(solution.half_width),
        pressure_(solution.pressure), responses_{{LayerResponse(data_.layers[0], pressure_, data_.ends),
                                                  LayerResponse(data_.layers[1], pressure_, data_.ends)}}
  {}
} // namespace abut
