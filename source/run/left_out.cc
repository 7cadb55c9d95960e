// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/run/left_out.h>

#include <algorithm>

namespace abut
{
  std::vector<std::string> left_out(const Setup &setup, const Solution &solution)
  {
    std::vector<std::string> items;
    if (setup.model.executor().n_processes() == 1)
      items.emplace_back("MPI and p4est (serial run)");
    else if (std::none_of(setup.scene.bodies.begin(), setup.scene.bodies.end(),
                          [](const BodyDescription &body) { return body.shares_mesh; }))
      items.emplace_back("p4est (no mesh is distributed)");
    if (setup.indicator == nullptr)
      items.emplace_back("error estimation (no estimator asked for)");
    if (!setup.scene.adapts())
      items.emplace_back("adaptation (no body adapts)");
    const EstimatorEntry &estimator = Registry<EstimatorEntry>::get().find(setup.scene.adaptation.estimator);
    if (!estimator.has_boundary_elements && estimator.make_certifier == nullptr)
      items.emplace_back("boundary elements (Adaptation/Estimator is not " +
                         estimators_with_boundary_elements() + ")");
    if (std::all_of(solution.bodies.begin(), solution.bodies.end(),
                    [](const BodyResult &result) { return result.counters.mortars == 0; }))
      items.emplace_back("mortar coupling inside bodies (hanging nodes)");
    if (setup.scene.contacts.empty())
      items.emplace_back("contact (a scene without pairs)");
    if (solution.iteration.motions.size() == 0)
      items.emplace_back("rigid motions as unknowns of the interface problem (no body floats)");
    if (!solution.compliance_is_dense)
      items.emplace_back("dense interface compliance (solves are cheaper here)");
    if (setup.exact == nullptr)
      items.emplace_back("true errors (no exact solution named)");
    return items;
  }
} // namespace abut
