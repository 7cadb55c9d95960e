// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/hp/fe_collection.h>

namespace abut
{
  /**
   * Lagrange elements that share nothing with those of other cells that have another index in a collection:
   * one copy for each level gives cells and finer ones displacements of their own at the vertices they share.
   */
  class LevelElement : public dealii::FE_Q<2>
  {
  public:
    explicit LevelElement(const unsigned int degree) : dealii::FE_Q<2>(degree) {}

    std::unique_ptr<dealii::FiniteElement<2>> clone() const override
    {
      return std::make_unique<LevelElement>(*this);
    }
    std::vector<std::pair<unsigned int, unsigned int>>
    hp_vertex_dof_identities(const dealii::FiniteElement<2> &) const override
    {
      return {};
    }
    std::vector<std::pair<unsigned int, unsigned int>>
    hp_line_dof_identities(const dealii::FiniteElement<2> &) const override
    {
      return {};
    }
  };

  /// Vectors of two, one for each level of a mesh.
  inline dealii::hp::FECollection<2> elements_of_levels(const unsigned int degree,
                                                        const unsigned int n_levels)
  {
    dealii::hp::FECollection<2> collection;
    for (unsigned int level = 0; level < n_levels; ++level)
      collection.push_back(dealii::FESystem<2>(LevelElement(degree), 2));
    return collection;
  }
} // namespace abut
