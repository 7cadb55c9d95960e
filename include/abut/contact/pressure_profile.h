// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/contact/contact_surface.h>

namespace abut
{
  /// Pressures of a surface's parts as a function of the place on its cut sides, to carry them over to
  /// another mesh of the same sides.
  class PressureProfile
  {
  public:
    PressureProfile(const ContactSurface &surface, const Eigen::VectorXd &pressures);

    /// The mean over what each part covers, by length; zero where there was no part.
    Eigen::VectorXd on_parts_of(const ContactSurface &surface) const;

  private:
    /// An interval of a cut side, in shares of the side's length.
    struct Interval
    {
      std::size_t side;
      double start, end;
      std::size_t part;
    };
    static std::vector<Interval> intervals_of(const ContactSurface &surface);

    std::vector<Interval> intervals_; ///< in their order
    Eigen::VectorXd pressures_;
  };
} // namespace abut
