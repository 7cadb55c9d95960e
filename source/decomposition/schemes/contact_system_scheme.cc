// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/schemes/contact_system_scheme.h>

#include <deal.II/base/exceptions.h>

namespace abut
{
  SchemeResult ContactSystemScheme::result_of(const InterfaceProblem::Loads &loads,
                                              const Eigen::VectorXd &pressures,
                                              const Eigen::VectorXd &amplitudes,
                                              const Eigen::VectorXd &pressure_response) const
  {
    AssertDimension(pressures.size(), system_.problem.n_pressures());
    AssertDimension(amplitudes.size(), system_.motions.size());
    AssertDimension(pressure_response.size(), system_.problem.response_size());
    const InterfaceProblem &problem = system_.problem;
    SchemeResult result;
    result.traction = problem.law().project(pressures);
    result.motions = system_.motions.amplitudes(amplitudes);
    result.response = loads.response + pressure_response + system_.motions.all.responses * result.motions;
    result.iterate = result.response;
    const bool bounded =
        system_.motions.size() == 0 && problem.n_pressures() > 0 && (problem.penalties().array() > 0.).all();
    if (bounded)
      result.iteration_error =
          system_.residual.guaranteed(loads, result.traction, pressure_response, result.response);
    result.error_is_bound = bounded && result.iteration_error <= parameters_.tolerance;
    if (!result.error_is_bound)
      result.iteration_error =
          system_.residual.algebraic(loads, result.traction, pressure_response, result.response);
    result.stopped_by = result.error_is_bound ? StoppedBy::bound : StoppedBy::residual;
    return result;
  }
} // namespace abut
