// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bem/elastic_kernels.h>

#include <deal.II/base/exceptions.h>

#include <cmath>

namespace abut
{
  ElasticKernels::ElasticKernels(const double poisson_ratio)
  {
    Assert(poisson_ratio > -1. && poisson_ratio <= .5, dealii::ExcMessage("a material of plane strain"));
    const double k = 3. - 4. * poisson_ratio, factor = 1. / (4. * M_PI * (1. + k)),
                 laplace = -1. / (2. * M_PI);
    single = {-2. * k * factor, factor};
    rotated = {2. * single.log - laplace, 2. * single.even};
    const double weight = 2. * (1. - 2. * poisson_ratio) / (1. - poisson_ratio);
    hypersingular = {4. * single.log - weight * laplace, 4. * single.even};
  }
} // namespace abut
