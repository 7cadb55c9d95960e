// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/reference/pressed_layers.h>

#include <deal.II/base/exceptions.h>

namespace abut
{
  PressedLayers::PressedLayers(const PressureBetween &solution)
      : data_(solution.data), half_width_(solution.half_width),
        pressure_(solution.pressure), responses_{{LayerResponse(data_.layers[0], pressure_, data_.ends),
                                                  LayerResponse(data_.layers[1], pressure_, data_.ends)}}
  {
    Assert(half_width_ > 0. && half_width_ < data_.length,
           dealii::ExcMessage("contact between layers ends within them"));
  }
} // namespace abut
