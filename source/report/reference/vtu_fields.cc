// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/report/reference/vtu_fields.h>

namespace abut
{
  const std::vector<CsvColumn> &vtu_fields()
  {
    static const std::vector<CsvColumn> fields = {
        {"displacement", "length", "of the points, a vector; the points themselves are undeformed"},
        {"stress_xx", "stress", "of the finite elements, along the axes of the plane; tension is positive"},
        {"stress_yy", "stress", "likewise"},
        {"stress_xy", "stress", "likewise, the shear stress"},
        {"stress_zz", "stress", "across the plane"},
        {"von_mises", "stress", "of these components at the point"},
        {"mean_von_mises", "stress", "mean of the cell"},
        {"level", "", "how often the cell was split"},
        {"eta", "relative",
         "estimated stress error of the cell by the mean stress of its body; with an estimator"},
        {"better_stress_xx", "stress", "the estimator's better stress; with zz, spr, fe-be"},
        {"better_stress_yy", "stress", "likewise"},
        {"better_stress_xy", "stress", "likewise"},
        {"better_stress_zz", "stress", "likewise"},
        {"better_von_mises", "stress", "of these components at the point"}};
    return fields;
  }
} // namespace abut
