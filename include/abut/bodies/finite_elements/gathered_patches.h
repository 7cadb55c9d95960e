// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/finite_elements/space.h>

#include <deal.II/base/data_out_base.h>

#include <vector>

namespace abut
{
  /// What all processes that share the mesh of a space show of their own cells.
  std::vector<dealii::DataOutBase::Patch<2>>
  gathered_patches(const Space &space, const std::vector<dealii::DataOutBase::Patch<2>> &own);
} // namespace abut
