// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <complex>

namespace abut
{
  /// Points, vectors and tractions of the plane as complex numbers: x + i y.
  using Complex = std::complex<double>;

  /**
   * A place x in the frame of an element that lies between -1 and 1, with the body where the imaginary part
   * is positive. Both distances are kept, so that neither loses its relative accuracy near an end.
   */
  struct LocalPlace
  {
    Complex from_start; ///< x + 1
    Complex from_end;   ///< x - 1
    Complex x() const { return .5 * (from_start + from_end); }
  };

  /// A straight boundary element, run through with the body on its left: its outward normal is -i direction.
  struct BoundaryElement
  {
    BoundaryElement(const Complex start_point, const Complex end_point)
        : start(start_point), end(end_point), length(std::abs(end_point - start_point)),
          direction((end_point - start_point) / length)
    {}

    Complex start, end;
    double length;
    Complex direction; ///< unit, from start to end

    /// eta = -1 at the start, 1 at the end.
    Complex point(const double eta) const { return .5 * ((start + end) + eta * (end - start)); }
    LocalPlace local(const Complex z) const
    {
      const Complex factor = 2. / length * std::conj(direction);
      return {factor * (z - start), factor * (z - end)};
    }
  };
} // namespace abut
