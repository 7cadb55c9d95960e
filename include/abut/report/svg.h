// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/report/deformed.h>

#include <iosfwd>
#include <string>

namespace abut
{
  /// The text with what XML keeps for itself written as entities.
  std::string xml_text(const std::string &text);

  /// Where the plane lies on the page: pixels to the right and downwards.
  struct PageFrame
  {
    double scale = 1.; ///< pixels per unit of length
    Vector2 origin = Vector2::Zero();

    Vector2 operator()(const Vector2 &point) const
    {
      return Vector2(origin.x() + scale * point.x(), origin.y() - scale * point.y());
    }
  };

  /// The beginning of an SVG file with a white page of the given size in pixels; it ends with `</svg>`.
  void write_svg_head(std::ostream &out, const Vector2 &size);

  /// Writes an SVG path through the points. The precision is a hundredth of a pixel.
  void write_path(std::ostream &out, const Polyline &points, const PageFrame &frame, bool closed,
                  const std::string &attributes);

  enum class Anchor
  {
    start,
    middle,
    end
  };
  void write_text(std::ostream &out, const Vector2 &place, Anchor anchor, const std::string &text);
} // namespace abut
