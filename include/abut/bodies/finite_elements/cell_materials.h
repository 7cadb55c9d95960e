// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/material.h>
#include <abut/scene/body_description.h>

#include <deal.II/base/exceptions.h>

#include <vector>

namespace abut
{
  class FiniteElementBody;

  /// The material of every cell: that of the body or of its region (material id: the number of the region in
  /// `Regions`, from 1 on).
  class CellMaterials
  {
  public:
    explicit CellMaterials(const BodyDescription &body) : materials_(body.materials()) {}
    explicit CellMaterials(const Material &one) : materials_{one} {}

    /// For any iterator on cells.
    template <typename CellIterator> const Material &operator()(const CellIterator &cell) const
    {
      AssertIndexRange(cell->material_id(), materials_.size());
      return materials_[cell->material_id()];
    }

  private:
    std::vector<Material> materials_;
  };

  /// Of all cells, by their active index.
  std::vector<Material> materials_of_cells(const FiniteElementBody &body);
} // namespace abut
