// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace abut
{
  /// Where the multipliers of several surfaces stand in one vector: surface by surface, part by part, the
  /// components of a part one after the other, the normal one first.
  class MultiplierLayout
  {
  public:
    MultiplierLayout() = default;
    /// `n_parts` of every surface; n_components >= 1 of every part.
    MultiplierLayout(const std::vector<Eigen::Index> &n_parts, Eigen::Index n_components);

    Eigen::Index size() const { return first_.back(); }
    std::size_t n_surfaces() const { return first_.size() - 1; }
    Eigen::Index n_components() const { return n_components_; }
    Eigen::Index n_parts(std::size_t surface) const;

    /// The multiplier of one component of a part of a surface.
    Eigen::Index index(std::size_t surface, std::size_t part, Eigen::Index component) const;

    /// What a multiplier belongs to.
    struct Place
    {
      std::size_t surface, part;
      Eigen::Index component;
    };
    Place place(Eigen::Index multiplier) const;

    using Indices = Eigen::ArithmeticSequence<Eigen::Index, Eigen::Index, Eigen::Index>;
    /// The multipliers of one component of all parts of a surface, in their order.
    Indices indices(std::size_t surface, Eigen::Index component) const;
    /// Those of all surfaces.
    Indices indices(Eigen::Index component) const;

  private:
    std::vector<Eigen::Index> first_ = {0}; ///< multiplier of each surface, and their number at the end
    Eigen::Index n_components_ = 1;
  };
} // namespace abut
