// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/adaptation/fe_be.h>
#include <abut/adaptation/kelly.h>
#include <abut/adaptation/spr.h>
#include <abut/adaptation/zz.h>

#include <cmath>

namespace abut
{
  std::unique_ptr<Indicator> make_indicator(const EstimatorKind kind,
                                            const BoundarySolution boundary_solution)
  {
    switch (kind)
    {
    case EstimatorKind::none:
      break;
    case EstimatorKind::kelly:
      return std::make_unique<KellyIndicator>();
    case EstimatorKind::zz:
      return std::make_unique<ZZIndicator>();
    case EstimatorKind::spr:
      return std::make_unique<SPRIndicator>();
    case EstimatorKind::fe_be:
      return std::make_unique<FEBEIndicator>(boundary_solution);
    }
    return {};
  }

  Eigen::VectorXd relative_errors(const CellErrors &errors, const Normalisation normalisation)
  {
    if (!(errors.stress_norm > 0.))
      return Eigen::VectorXd::Zero(errors.stress.size());
    const double area = errors.areas.sum();
    if (normalisation == Normalisation::printed)
      return errors.stress.cwiseQuotient(errors.areas) * (area / errors.stress_norm);
    return errors.stress.cwiseQuotient(errors.areas.cwiseSqrt()) * (std::sqrt(area) / errors.stress_norm);
  }
} // namespace abut
