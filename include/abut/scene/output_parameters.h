// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/parameter_handler.h>

namespace abut
{
  struct Scene;

  /// After which passes the state of a run is saved.
  enum class CheckpointTimes
  {
    automatic, ///< where seconds have gone since the last time
    every_pass,
    never
  };

  /// The section `Output`.
  void declare_output(dealii::ParameterHandler &prm);

  /// Its entries. The directory has the name of the scene's file where none is given. Throws UserError.
  void parse_output(const dealii::ParameterHandler &prm, Scene &scene);
} // namespace abut
