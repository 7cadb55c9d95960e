// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/adaptation/indicator.h>

#include <cmath>

namespace abut
{
  namespace
  {
    const Registered<EstimatorEntry> registered_none({"none", "nothing is estimated"});
  } // namespace

  std::unique_ptr<Indicator> make_indicator(const AdaptationParameters &parameters)
  {
    const EstimatorEntry &entry = Registry<EstimatorEntry>::get().find(parameters.estimator);
    return entry.estimates() ? entry.make(parameters) : nullptr;
  }

  std::unique_ptr<Indicator> make_certifier(const AdaptationParameters &parameters)
  {
    const EstimatorEntry &entry = Registry<EstimatorEntry>::get().find(parameters.estimator);
    return entry.make_certifier != nullptr ? entry.make_certifier(parameters) : nullptr;
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
