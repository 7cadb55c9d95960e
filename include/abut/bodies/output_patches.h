// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/material.h>

#include <deal.II/base/data_out_base.h>

#include <Eigen/Core>

#include <string>
#include <tuple>
#include <vector>

namespace abut
{
  /// What is written of a body's solution, beside its stress.
  struct OutputFields
  {
    const Eigen::VectorXd &displacement; ///< all unknowns
    const Eigen::VectorXd &deformation;  ///< the same less the rigid motion
    const Eigen::VectorXd &eta;          ///< of each cell; may be empty
    const std::vector<Stress> &better;   ///< at SamplePoints::comparison; may be empty
  };

  /// A body's cells or facets with the values of its fields, as deal.II writes them to files.
  struct OutputPatches
  {
    using Range =
        std::tuple<unsigned int, unsigned int, std::string,
                   dealii::DataComponentInterpretation::DataComponentInterpretation>; ///< of vectors

    std::vector<dealii::DataOutBase::Patch<2>> patches;
    std::vector<std::string> names;
    std::vector<Range> vectors;
  };
} // namespace abut
