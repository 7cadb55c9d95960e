// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/trace/contact_end.h>

namespace abut
{
  /**
   * The pressure along a surface as it is reported: between the places of the parts the monotone cubic
   * through their reported pressures, slopes by [FritschButland1984]; next to a ContactEnd its square root.
   * Never negative. The partition must outlive the object.
   */
  class PressureCurve
  {
  public:
    /// Of the loads p_k >= 0. `ends_like_root`: as without a penalty, which makes the end a layer.
    PressureCurve(const Partition &partition, const Eigen::VectorXd &loads, bool ends_like_root);

    const std::vector<ContactEnd> &ends() const { return ends_; }
    /// At the places of the parts; zero where the load is.
    const Eigen::VectorXd &at_places() const { return values_; }
    /// At a place of the surface within a part.
    double at(std::size_t part, double arc) const;

  private:
    const Partition *partition_;
    std::vector<ContactEnd> ends_;
    std::vector<int> end_of_part_; ///< among `ends_`; -1: none
    Eigen::VectorXd values_;
  };
} // namespace abut
