// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/finite_elements/cell_materials.h>
#include <abut/bodies/finite_elements/space.h>

#include <Eigen/SparseCore>

#include <vector>

namespace abut
{
  /// a(u, v) of (11), without any boundary condition: symmetric, with the rigid modes in its kernel.
  /// `projects`: with the projected divergence (projects_divergence). `cells`: by active cell index, whether
  /// it is summed over; empty: all are.
  Eigen::SparseMatrix<double> assemble_stiffness(const Space &space, const CellMaterials &materials,
                                                 bool projects, const std::vector<bool> &cells = {});
} // namespace abut
