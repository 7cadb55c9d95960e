// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace abut
{
  /// Whether somebody has initialised these libraries, which a serial run does not need.
  bool mpi_is_initialised();
  bool p4est_is_initialised();
} // namespace abut
