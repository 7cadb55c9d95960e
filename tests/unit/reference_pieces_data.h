// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/reference/piecewise_pressure.h>

#include <vector>

namespace abut
{
  constexpr double rough_length = 3.3;

  /// Pieces of every width on [0, 3.3], with jumps, a gap and kinks at both mirrors.
  inline std::vector<PressurePiece> rough_pieces()
  {
    return {{0., 0.3, {{0.7, -0.4, 0.9, -0.3}}},        {0.3, 0.4, {{1.1, 0.8, 0., 0.}}},
            {0.4, 0.4000033, {{1.9, -0.6, -0.5, 0.2}}}, {0.9, 1.7, {{0.3, 0., 0., 0.8}}},
            {1.7, 1.7001, {{1.4, 0.2, -0.7, 0.}}},      {3., 3.3, {{0.2, 0.5, 0.1, -0.2}}}};
  }

  inline double exact_value(const PressurePiece &piece, double x)
  {
    const double t = (x - piece.start) / (piece.end - piece.start);
    double sum = 0.;
    for (std::size_t j = piece.coefficients.size(); j-- > 0;)
      sum = sum * t + piece.coefficients[j];
    return sum;
  }

  /// The polynomial of a piece, given on a part of it.
  inline PressurePiece part_of(const PressurePiece &piece, double start, double end)
  {
    const double width = piece.end - piece.start;
    const double scale = (end - start) / width;
    const double t = (start - piece.start) / width;
    const std::array<double, 4> &c = piece.coefficients;
    return {start,
            end,
            {{exact_value(piece, start), scale * (c[1] + t * (2. * c[2] + t * 3. * c[3])),
              scale * scale * (c[2] + 3. * t * c[3]), scale * scale * scale * c[3]}}};
  }
} // namespace abut
