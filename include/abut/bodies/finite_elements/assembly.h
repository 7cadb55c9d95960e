// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/finite_elements/cell_materials.h>
#include <abut/bodies/finite_elements/space.h>

#include <Eigen/SparseCore>

namespace abut
{
  /// a(u, v) of (11), without any boundary condition: symmetric, with the rigid modes in its kernel.
  /// `projects`: with the projected divergence (projects_divergence).
  Eigen::SparseMatrix<double> assemble_stiffness(const Space &space, const CellMaterials &materials,
                                                 bool projects);
} // namespace abut
