// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace abut
{
  /// The style sheet of report.html: light and dark, narrow and wide, paper.
  extern const char *const page_style;

  /// Its script, without which all pictures are there below one another: a slider that shows one of them.
  extern const char *const page_script;
} // namespace abut
