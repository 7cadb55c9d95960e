// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bodies/body.h>

namespace abut
{
  std::optional<Stress> Body::stress_at(const Eigen::VectorXd &deformation, const Vector2 &point) const
  {
    const std::vector<MaterialStress> stresses = stresses_at(deformation, point);
    if (stresses.size() == 1)
      return stresses.front().stress;
    Stress sum;
    unsigned int n_cells = 0;
    for (const MaterialStress &own : stresses)
    {
      sum = sum + own.stress * own.n_cells;
      n_cells += own.n_cells;
    }
    if (n_cells == 0)
      return {};
    return sum * (1. / n_cells);
  }
} // namespace abut
