// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace abut
{
  // Files that study.html holds, as the build found them: contrib/uplot and source/study/page.
  extern const char *const uplot_license;
  extern const char *const uplot_style;
  extern const char *const uplot_script;
  extern const char *const study_style;
  extern const char *const study_script;
} // namespace abut
