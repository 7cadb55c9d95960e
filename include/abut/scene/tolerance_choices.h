// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/parameter_sections.h>

#include <string>
#include <vector>

namespace abut
{
  /// What `Tolerance` is about: whose bodies and parts.
  struct ToleranceScope
  {
    double tolerance; ///< above 0
    std::vector<std::string> bodies, parts;
  };

  /**
   * Sets what a run with a tolerance chooses by itself where no line of the file or override gives it:
   * degree, first mesh, which bodies adapt, estimator, marking, passes, accuracy of the iteration. Sections
   * hold the file's values already; those stay. See doc/tolerance.md.
   */
  void choose_for_tolerance(const ToleranceScope &scope, const std::vector<ParameterLine> &given,
                            ParameterSections &sections);
} // namespace abut
