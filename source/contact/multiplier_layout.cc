// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/contact/multiplier_layout.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;
  }

  MultiplierLayout::MultiplierLayout(const std::vector<Index> &n_parts, const Index n_components)
      : n_components_(n_components)
  {
    Assert(n_components >= 1, dealii::ExcMessage("a multiplier has at least one component"));
    for (const Index n : n_parts)
      first_.push_back(first_.back() + n * n_components);
  }

  Index MultiplierLayout::n_parts(const std::size_t surface) const
  {
    AssertIndexRange(surface, n_surfaces());
    return (first_[surface + 1] - first_[surface]) / n_components_;
  }

  Index MultiplierLayout::index(const std::size_t surface, const std::size_t part,
                                const Index component) const
  {
    AssertIndexRange(surface, n_surfaces());
    AssertIndexRange(static_cast<Index>(part), n_parts(surface));
    AssertIndexRange(component, n_components_);
    return first_[surface] + static_cast<Index>(part) * n_components_ + component;
  }

  MultiplierLayout::Place MultiplierLayout::place(const Index multiplier) const
  {
    AssertIndexRange(multiplier, size());
    const auto after = std::upper_bound(first_.begin(), first_.end(), multiplier);
    const auto surface = static_cast<std::size_t>(after - first_.begin()) - 1;
    const Index within = multiplier - first_[surface];
    return {surface, static_cast<std::size_t>(within / n_components_), within % n_components_};
  }

  MultiplierLayout::Indices MultiplierLayout::indices(const std::size_t surface, const Index component) const
  {
    AssertIndexRange(component, n_components_);
    return Eigen::seqN(first_[surface] + component, n_parts(surface), n_components_);
  }

  MultiplierLayout::Indices MultiplierLayout::indices(const Index component) const
  {
    AssertIndexRange(component, n_components_);
    return Eigen::seqN(component, size() / n_components_, n_components_);
  }
} // namespace abut
