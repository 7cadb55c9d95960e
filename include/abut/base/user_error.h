// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace abut
{
  /**
   * Something the user can mend: a wrong command line, parameter, mesh or scene. The text is one clear
   * sentence that names the file or parameter, the value received and the values allowed. The program prints
   * it and ends with status 1, before anything is written.
   */
  class UserError : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /**
   * A computation that cannot be trusted: a lost factorisation, NaN, a stalled iteration. The text names the
   * cause and a way out. The program prints it and ends with status 2.
   */
  class ComputationError : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };
} // namespace abut
