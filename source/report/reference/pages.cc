// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/report/reference/pages.h>
#include <abut/report/reference/parameter_page.h>
#include <abut/report/reference/results_page.h>
#include <abut/report/reference/summary_schema.h>

namespace abut
{
  const std::vector<ReferencePage> &reference_pages()
  {
    static const std::vector<ReferencePage> pages = {{"parameters", "parameters.md", parameter_page},
                                                     {"results", "results.md", results_page},
                                                     {"schema", "summary.schema.json", summary_schema}};
    return pages;
  }
} // namespace abut
