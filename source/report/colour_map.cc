// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/report/colour_map.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace abut
{
  namespace
  {
    /// Equally spaced, 0xrrggbb.
    constexpr std::array<unsigned int, 20> viridis_colours = {
        {0x440154, 0x481567, 0x482677, 0x453781, 0x404788, 0x39568c, 0x33638d, 0x2d708e, 0x287d8e, 0x238a8d,
         0x1f968b, 0x20a387, 0x29af7f, 0x3cbb75, 0x55c667, 0x73d055, 0x95d840, 0xb8de29, 0xdce319, 0xfde725}};

    constexpr char hexadecimal[] = "0123456789abcdef";
  } // namespace

  std::string viridis(const double value)
  {
    const double place = std::clamp(value, 0., 1.) * static_cast<double>(viridis_colours.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), viridis_colours.size() - 2);
    const double share = place - static_cast<double>(below);
    std::string text = "#";
    for (const unsigned int shift : {16u, 8u, 0u})
    {
      const double a = (viridis_colours[below] >> shift) & 0xffu;
      const double b = (viridis_colours[below + 1] >> shift) & 0xffu;
      const auto channel = static_cast<std::size_t>(std::lround((1. - share) * a + share * b));
      text += {hexadecimal[channel / 16], hexadecimal[channel % 16]};
    }
    return text;
  }
} // namespace abut
